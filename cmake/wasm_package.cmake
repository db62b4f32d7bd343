# SPDX-FileCopyrightText: the Mortise authors
# SPDX-License-Identifier: MIT
# Target mortise_wasm: wasm/bindings/*.cpp and the library -> glue.mjs and core.wasm, from one link, in MORTISE_WASM_DIST.

set(MORTISE_WASM_DIST "${CMAKE_CURRENT_SOURCE_DIR}/wasm/dist" CACHE PATH "Where glue.mjs and core.wasm go")
file(GLOB wasm_binding_sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/wasm/bindings/*.cpp")
if(wasm_binding_sources)
  add_executable(mortise_wasm ${wasm_binding_sources})
  set_target_properties(mortise_wasm PROPERTIES OUTPUT_NAME glue SUFFIX .mjs)
  target_compile_options(mortise_wasm PRIVATE ${MORTISE_EM_COMPILE_OPTIONS} ${MORTISE_EM_LTO})
  target_link_libraries(mortise_wasm PRIVATE mortise mortise_flags)
  target_link_options(mortise_wasm PRIVATE ${MORTISE_EM_PACKAGE_LINK_OPTIONS})
  add_custom_command(
    TARGET mortise_wasm POST_BUILD
    COMMAND "${CMAKE_COMMAND}" -D "glue=$<TARGET_FILE:mortise_wasm>" -D "dist=${MORTISE_WASM_DIST}" -P
            "${CMAKE_CURRENT_SOURCE_DIR}/cmake/copy_wasm_package.cmake"
    VERBATIM)
endif()
