# SPDX-FileCopyrightText: the Mortise authors
# SPDX-License-Identifier: MIT
# Header-only libraries of the system, reached through symbolic links in <build>/inc: a WebAssembly build must see these
# headers but never /usr/include itself, whose C headers are those of the host.

set(MORTISE_HEADER_LINKS "${CMAKE_CURRENT_BINARY_DIR}/inc")
file(MAKE_DIRECTORY "${MORTISE_HEADER_LINKS}")

# mortise_header_library(NAME HEADER DEBIAN_PACKAGE): target mortise_NAME gives HEADER as a system header.
function(mortise_header_library name header debian_package)
  find_path(MORTISE_${name}_ROOT "${header}" NO_CMAKE_FIND_ROOT_PATH PATHS /usr/include /usr/local/include)
  mark_as_advanced(MORTISE_${name}_ROOT)
  if(NOT MORTISE_${name}_ROOT)
    message(FATAL_ERROR "${header} is missing (Debian: apt-get install ${debian_package}; else -DMORTISE_${name}_ROOT=folder)")
  endif()
  string(REGEX REPLACE "/.*" "" top "${header}")
  file(CREATE_LINK "${MORTISE_${name}_ROOT}/${top}" "${MORTISE_HEADER_LINKS}/${top}" SYMBOLIC)
  add_library(mortise_${name} INTERFACE)
  target_include_directories(mortise_${name} SYSTEM INTERFACE "${MORTISE_HEADER_LINKS}")
endfunction()
