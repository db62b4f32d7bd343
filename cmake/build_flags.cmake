# SPDX-FileCopyrightText: the Mortise authors
# SPDX-License-Identifier: MIT
# The flags of everything that is built here, and ccache when it is installed.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
set(CMAKE_CXX_FLAGS_DEBUG "-O1 -g1")
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")

add_library(mortise_flags INTERFACE)
# One result everywhere: no fused multiply-add, and never -ffast-math.
target_compile_options(mortise_flags INTERFACE -ffp-contract=off -Wall -Wextra -Wshadow -Wconversion)
if(EMSCRIPTEN)
  # The same wasm from every folder. Not natively: ccache would no longer find what another clone compiled.
  target_compile_options(mortise_flags INTERFACE "-fmacro-prefix-map=${CMAKE_CURRENT_SOURCE_DIR}/=")
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # GCC 12 sees overlaps in std::string's operator+ that cannot be (GCC bug 105651).
  target_compile_options(mortise_flags INTERFACE -Wno-restrict)
endif()
if(MORTISE_WERROR)
  target_compile_options(mortise_flags INTERFACE -Werror)
endif()
if(MORTISE_SANITIZE)
  set(sanitizers -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_compile_options(mortise_flags INTERFACE ${sanitizers})
  target_link_options(mortise_flags INTERFACE ${sanitizers})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # GCC cannot follow values through its own instrumentation.
    target_compile_options(mortise_flags INTERFACE -Wno-maybe-uninitialized)
  endif()
endif()

find_program(MORTISE_CCACHE ccache)
mark_as_advanced(MORTISE_CCACHE)
if(MORTISE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${MORTISE_CCACHE}")
endif()
