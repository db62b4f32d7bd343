// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// How many random cases a test runs: all of them natively, a tenth where instructions are slow, a multiple on request.
#pragma once

#include <cstddef>

namespace mortise::test {

/// For the test program: was `--long` given on the command line?
void set_long_run(bool is_long);

/// Was `--long` given on the command line?
[[nodiscard]] bool is_long_run();

/// Is this a build under a sanitizer, or WebAssembly?
[[nodiscard]] bool is_reduced_run();

/// `full` in a native run, a tenth of it (at least 1) in a reduced one, `long_count` with `--long`.
[[nodiscard]] std::size_t scaled_count(std::size_t full, std::size_t long_count);

}  // namespace mortise::test
