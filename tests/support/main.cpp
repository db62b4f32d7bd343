// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The test program: Catch2's own command line, plus `--long` for the full number of random cases.
#define CATCH_CONFIG_RUNNER
#include "support/catch.h"

#include "support/test_scale.h"

int main(int argc, char** argv) {
  Catch::Session session;
#ifdef CATCH_VERSION_MAJOR
#if CATCH_VERSION_MAJOR >= 3
  using Catch::Clara::Opt;
#else
  using Catch::clara::Opt;
#endif
#endif
  bool long_run = false;
  session.cli(session.cli() | Opt(long_run)["--long"]("run a million random cases of every kind"));
  if (const int usage_error = session.applyCommandLine(argc, argv); usage_error != 0) return usage_error;
  mortise::test::set_long_run(long_run);
  return session.run();
}
