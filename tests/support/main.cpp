// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The test program: Catch2's own command line, plus `--long` for the full number of random cases.
#define CATCH_CONFIG_RUNNER
#include "support/catch.h"

#include <algorithm>

#include "support/test_scale.h"

namespace mortise::test {
namespace {

bool long_run = false;

}  // namespace

bool is_long_run() { return long_run; }

bool is_reduced_run() {
#if defined(__EMSCRIPTEN__) || defined(__SANITIZE_ADDRESS__)
  return true;
#elif defined(__has_feature)
  return __has_feature(address_sanitizer);
#else
  return false;
#endif
}

std::size_t scaled_count(std::size_t full, std::size_t long_count) {
  if (long_run) return long_count;
  return is_reduced_run() ? std::max<std::size_t>(full / 10, 1) : full;
}

}  // namespace mortise::test

int main(int argc, char** argv) {
  Catch::Session session;
#ifdef CATCH_VERSION_MAJOR
#if CATCH_VERSION_MAJOR >= 3
  using Catch::Clara::Opt;
#else
  using Catch::clara::Opt;
#endif
#endif
  session.cli(session.cli() | Opt(mortise::test::long_run)["--long"]("run a million random cases of every kind"));
  if (const int usage_error = session.applyCommandLine(argc, argv); usage_error != 0) return usage_error;
  return session.run();
}
