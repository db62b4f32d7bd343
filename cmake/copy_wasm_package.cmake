# SPDX-FileCopyrightText: the Mortise authors
# SPDX-License-Identifier: MIT
# Copies one link's glue and wasm into the package: cmake -D glue=FILE.mjs -D dist=FOLDER -P copy_wasm_package.cmake

file(READ "${glue}" text)
# Emscripten pads the glue with spaces.
string(REGEX REPLACE "[ \t]+\n" "\n" text "${text}")
file(MAKE_DIRECTORY "${dist}")
file(WRITE "${dist}/glue.mjs" "${text}")
string(REGEX REPLACE "\\.mjs$" ".wasm" wasm "${glue}")
file(COPY_FILE "${wasm}" "${dist}/core.wasm")
