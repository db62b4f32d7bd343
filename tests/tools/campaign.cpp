// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The random campaign: booleans of operands drawn from a seed, each checked by support/random_checks.h.
// usage: campaign [--cases N] [--seed S] [--case K]   (K: that case alone)
// A program of its own and no test case: how many cases, from which seed, or which one is its command line, it goes on after
// a failure, and it writes the operands of failed cases to build/campaign. Its last line is counted by scripts/test.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <string>

#include "mortise/io/files.h"
#include "support/random_checks.h"

using namespace mortise;
using namespace mortise::test;

namespace {

const std::string folder = "build/campaign";

struct Options {
  unsigned long long cases = 500, seed = 1, first = 0;
};

struct Tally {
  std::size_t cases = 0, failed = 0, uncertified = 0, slow = 0;
  double displacement = 0, seconds = 0, longest = 0;

  void add(const CaseOutcome& outcome) {
    ++cases;
    failed += outcome.faults.empty() ? 0 : 1;
    uncertified += outcome.is_uncertified ? 1 : 0;
    slow += outcome.is_slow ? 1 : 0;
    displacement = std::max(displacement, outcome.displacement);
    seconds += outcome.seconds;
    longest = std::max(longest, outcome.seconds);
  }
};

bool read_options(int argc, char** argv, Options& options) {
  for (int i = 1; i < argc; i += 2) {
    char* end = nullptr;
    const unsigned long long value = i + 1 < argc ? std::strtoull(argv[i + 1], &end, 10) : 0;
    if (end == nullptr || *end != '\0' || end == argv[i + 1]) return false;
    if (std::strcmp(argv[i], "--cases") == 0)
      options.cases = value;
    else if (std::strcmp(argv[i], "--seed") == 0)
      options.seed = value;
    else if (std::strcmp(argv[i], "--case") == 0)
      options.first = value, options.cases = 1;
    else
      return false;
  }
  return true;
}

void write_operands(const RandomCase& drawn, const std::string& name) {
  std::filesystem::create_directories(folder);
  for (std::size_t k = 0; k < drawn.operands.size(); ++k) {
    write_mesh_file(folder + "/" + name + "-" + std::to_string(k) + ".off", drawn.operands[k]);
  }
}

CaseOutcome run_case(unsigned long long seed, unsigned long long number, std::array<Tally, family_count>& families) {
  const RandomCase drawn = make_random_case(seed, number);
  const CaseOutcome outcome = check_case(drawn);
  families[static_cast<std::size_t>(drawn.family)].add(outcome);
  if (outcome.faults.empty()) return outcome;
  const std::string name = "seed" + std::to_string(seed) + "-case" + std::to_string(number);
  const std::string family(family_name(drawn.family));
  std::printf("FAILED: seed %llu, case %llu, %s; again: campaign --seed %llu --case %llu; operands: %s/%s-*.off\n%s", seed, number,
              family.c_str(), seed, number, folder.c_str(), name.c_str(), outcome.faults.c_str());
  write_operands(drawn, name);
  return outcome;
}

void print_progress(const Options& options, const Tally& all) {
  std::printf("campaign: %zu cases, seed %llu: %zu failed, %zu uncertified, %zu slow, %.1f s\n", all.cases, options.seed, all.failed,
              all.uncertified, all.slow, all.seconds);
  std::fflush(stdout);
}

void print_families(const std::array<Tally, family_count>& families) {
  for (std::size_t f = 0; f < family_count; ++f) {
    const Tally& tally = families[f];
    const std::string name(family_name(static_cast<Family>(f)));
    std::printf("  %-8s %6zu cases %4zu failed %5zu uncertified %4zu slow, displacement at most %.3g x 2^-52, %.1f s, longest %.2f s\n",
                name.c_str(), tally.cases, tally.failed, tally.uncertified, tally.slow, tally.displacement, tally.seconds, tally.longest);
  }
}

Tally run(const Options& options) {
  std::array<Tally, family_count> families;
  Tally all;
  for (unsigned long long i = 0; i < options.cases; ++i) {
    all.add(run_case(options.seed, options.first + i, families));
    if (all.cases % 1000 == 0) print_progress(options, all);
  }
  if (all.cases % 1000 != 0) print_progress(options, all);
  print_families(families);
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  Options options;
  if (!read_options(argc, argv, options)) {
    std::fputs("usage: campaign [--cases N] [--seed S] [--case K]\n", stderr);
    return 2;
  }
  try {
    const Tally all = run(options);
    std::printf("test cases: %zu | %zu passed | %zu failed\n", all.cases, all.cases - all.failed, all.failed);
    return all.failed == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "campaign: %s\n", error.what());
    return 1;
  }
}
