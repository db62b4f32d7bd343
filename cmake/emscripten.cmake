# SPDX-FileCopyrightText: the Mortise authors
# SPDX-License-Identifier: MIT
# Toolchain file of the preset `wasm`, and the one place that knows how Emscripten versions differ.
# Tested: 3.1.6 (Debian 12). Newer versions get the flags their change logs ask for.

find_program(MORTISE_EMXX em++ REQUIRED)
find_program(MORTISE_EM_CONFIG em-config REQUIRED)
execute_process(COMMAND "${MORTISE_EM_CONFIG}" EMSCRIPTEN_ROOT OUTPUT_VARIABLE emscripten_root OUTPUT_STRIP_TRAILING_WHITESPACE
                COMMAND_ERROR_IS_FATAL ANY)
include("${emscripten_root}/cmake/Modules/Platform/Emscripten.cmake")

# Debian's em++ loads acorn from Debian's module folder, which only Debian's own node searches by itself. Only the link
# gets the variable: programs under test must not see it.
if(EXISTS /usr/share/nodejs/acorn)
  set(CMAKE_CXX_LINKER_LAUNCHER "${CMAKE_COMMAND};-E;env;NODE_PATH=/usr/share/nodejs")
endif()

# emcmake would add a flag that newer versions of node refuse.
find_program(MORTISE_NODE node REQUIRED)
set(CMAKE_CROSSCOMPILING_EMULATOR "${MORTISE_NODE}")

# Exceptions in the legacy encoding: Node 20 and Safari before 18.4 refuse the newer one.
set(MORTISE_EM_COMPILE_OPTIONS -fwasm-exceptions)
if(EMSCRIPTEN_VERSION VERSION_GREATER_EQUAL 4.0.0)
  list(APPEND MORTISE_EM_COMPILE_OPTIONS -sWASM_LEGACY_EXCEPTIONS=1)
endif()

# The stack: 5 MB, the default of 3.1.6; newer versions default to 64 KB and call the setting otherwise.
if(EMSCRIPTEN_VERSION VERSION_GREATER_EQUAL 3.1.25)
  set(MORTISE_EM_STACK -sSTACK_SIZE=5MB)
else()
  set(MORTISE_EM_STACK -sTOTAL_STACK=5MB)
endif()

# Embind.
if(EMSCRIPTEN_VERSION VERSION_GREATER_EQUAL 3.1.30)
  set(MORTISE_EM_BIND -lembind)
else()
  set(MORTISE_EM_BIND --bind)
endif()

set(MORTISE_EM_MEMORY -sALLOW_MEMORY_GROWTH -sINITIAL_MEMORY=16MB -sMAXIMUM_MEMORY=4GB ${MORTISE_EM_STACK})

# The library's objects are LLVM bitcode: tests and package link the very same ones.
set(MORTISE_EM_LTO -flto)

# A program run by node, with the files of the host. CommonJS in one file: the ES module form of 3.1.6 does not run in
# node, and its CommonJS form cannot find a separate wasm file there.
set(MORTISE_EM_NODE_LINK_OPTIONS ${MORTISE_EM_LTO} ${MORTISE_EM_COMPILE_OPTIONS} ${MORTISE_EM_MEMORY} -sSINGLE_FILE -sNODERAWFS -sEXIT_RUNTIME)

# The core of the npm package: one ES module for browsers, workers and node. node is not in ENVIRONMENT because 3.1.6 then
# writes code that no ES module can run; the package hands the bytes over itself. No code from strings (strict CSP).
set(MORTISE_EM_PACKAGE_LINK_OPTIONS
    -O3 ${MORTISE_EM_LTO} ${MORTISE_EM_COMPILE_OPTIONS} ${MORTISE_EM_BIND} ${MORTISE_EM_MEMORY} -sMODULARIZE -sEXPORT_ES6 -sUSE_ES6_IMPORT_META=0
    -sENVIRONMENT=web,worker -sDYNAMIC_EXECUTION=0 -sFILESYSTEM=0)
