// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Catch2, version 2 (one header) or 3 (a library): whichever is installed.
#pragma once

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
#else
#include <catch2/catch.hpp>
#endif
