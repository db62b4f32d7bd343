// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Asks Mortise and CGAL for the booleans of pairs of real meshes and compares the answers.
// usage: differential [--seed N] [--pair N FOLDER]   (--pair: that one only, its operands written into FOLDER)
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cgal_answers.h"
#include "compare.h"
#include "mortise/mortise.h"
#include "our_answers.h"
#include "pairs.h"
#include "support/data.h"

namespace {

using namespace mortise;
using namespace mortise::peers;

constexpr std::size_t least_compared = 300;

struct Options {
  std::uint64_t seed = 1;
  std::optional<std::size_t> only_pair;
  std::string folder;
};

struct Tally {
  std::size_t pairs = 0;
  std::array<std::size_t, 5> pairs_by_verdict{};
  std::size_t results = 0;                  ///< compared
  std::size_t noticed = 0;                  ///< pairs found to differ once A - B and B - A are swapped
  std::vector<double> relative_tolerances;  ///< of the volume of the union
  std::vector<double> four_ratios, union_ratios, our_megabytes, their_megabytes;

  std::size_t& of(Verdict verdict) { return pairs_by_verdict[static_cast<std::size_t>(verdict)]; }
};

Options read_options(int count, char** words) {
  Options options;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    if (word == "--seed" && i + 1 < count) {
      options.seed = std::strtoull(words[++i], nullptr, 10);
    } else if (word == "--pair" && i + 2 < count) {
      options.only_pair = std::strtoul(words[++i], nullptr, 10);
      options.folder = words[++i];
    } else {
      std::fprintf(stderr, "usage: differential [--seed N] [--pair N FOLDER]\n");
      std::exit(2);
    }
  }
  return options;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

double largest(const std::vector<double>& values) { return values.empty() ? 0 : *std::max_element(values.begin(), values.end()); }

/// The mesh of a file; read once, and held to the conditions of the peer.
const SurfaceMesh& mesh_of(const std::string& file) {
  static std::map<std::string, SurfaceMesh> meshes;
  const auto [entry, is_new] = meshes.try_emplace(file);
  if (is_new) {
    entry->second = load(file);
    if (const std::string why = why_unfit_for_cgal(entry->second); !why.empty()) {
      std::printf("%s is no operand for CGAL: %s\n", file.c_str(), why.c_str());
      std::exit(1);
    }
  }
  return entry->second;
}

void add_costs(Tally& tally, const Answers& ours, const Answers& theirs) {
  tally.four_ratios.push_back(theirs.four_cost.milliseconds / ours.four_cost.milliseconds);
  tally.union_ratios.push_back(theirs.union_cost.milliseconds / ours.union_cost.milliseconds);
  tally.our_megabytes.push_back(ours.union_cost.megabytes);
  tally.their_megabytes.push_back(theirs.union_cost.megabytes);
}

/// Would a wrong answer be noticed?
bool is_swap_noticed(Answers ours, const Answers& theirs, const Volumes& operands) {
  std::swap(ours.shapes[ALessB], ours.shapes[BLessA]);
  return judge(ours, theirs, operands).verdict == Verdict::Differ;
}

void print_pair(std::size_t number, const Pair& pair, const Judgement& judgement) {
  constexpr std::array<const char*, 5> verdicts{"agree", "peer refused", "beyond doubles", "peer wrong", "DIFFER"};
  std::printf("pair %zu %s %s %s: %s\n", number, pose_name(pair.pose), pair.file_a.c_str(), pair.file_b.c_str(),
              verdicts[static_cast<std::size_t>(judgement.verdict)]);
  for (const std::string& line : judgement.lines) std::printf("  %s\n", line.c_str());
  std::fflush(stdout);
}

void add_pair(std::size_t number, const Pair& pair, Tally& tally) {
  const PosedPair posed = place(pair, mesh_of(pair.file_a), mesh_of(pair.file_b));
  const Volumes operands{enclosed_volume(posed.a), enclosed_volume(posed.b)};
  const auto ask = [&](Depth depth) { return std::pair{our_answers(posed.a, posed.b, depth), cgal_answers(posed.a, posed.b, depth)}; };
  const auto [ours, theirs] = ask(Depth::Figures);
  Judgement judgement = judge(ours, theirs, operands);
  if (judgement.verdict == Verdict::Differ) {
    const auto [our_faults, their_faults] = ask(Depth::FiguresAndFaults);
    judgement = judge(our_faults, their_faults, operands);
  }
  ++tally.pairs;
  ++tally.of(judgement.verdict);
  tally.results += judgement.compared;
  if (judgement.verdict != Verdict::Agree) return print_pair(number, pair, judgement);
  const Tolerance tolerance = tolerance_of(*ours.shapes[United], *theirs.shapes[United], ours.displacement + theirs.displacement, operands);
  tally.relative_tolerances.push_back(tolerance.volume / (operands.a + operands.b));
  tally.noticed += is_swap_noticed(ours, theirs, operands) ? 1 : 0;
  add_costs(tally, ours, theirs);
}

void write_operands(const Pair& pair, const std::string& folder) {
  const PosedPair posed = place(pair, mesh_of(pair.file_a), mesh_of(pair.file_b));
  write_mesh_file(folder + "/a.off", posed.a);
  write_mesh_file(folder + "/b.off", posed.b);
}

void print_summary(std::uint64_t seed, Tally& tally) {
  std::printf("time of CGAL over ours, median: %.2f for one union, %.2f for all four (one call of CGAL's, four of ours)\n",
              median(tally.union_ratios), median(tally.four_ratios));
  std::printf("peak memory of a union: ours median %.1f MB, most %.0f MB; CGAL median %.1f MB, most %.0f MB\n", median(tally.our_megabytes),
              largest(tally.our_megabytes), median(tally.their_megabytes), largest(tally.their_megabytes));
  std::printf("tolerance of the volume over V(A) + V(B): median %.1e, most %.1e; A - B and B - A swapped: noticed in %zu pairs\n",
              median(tally.relative_tolerances), largest(tally.relative_tolerances), tally.noticed);
  std::printf(
      "differential: %zu pairs (seed %llu, %zu results), %zu compared, %zu peer refused, %zu beyond doubles, %zu peer wrong, %zu differ\n",
      tally.pairs, static_cast<unsigned long long>(seed), tally.results, tally.of(Verdict::Agree), tally.of(Verdict::PeerRefused),
      tally.of(Verdict::BeyondDoubles), tally.of(Verdict::PeerWrong), tally.of(Verdict::Differ));
}

}  // namespace

int main(int count, char** words) {
  const Options options = read_options(count, words);
  if (test::is_data_missing()) return 0;
  const std::vector<Pair> pairs = make_pairs(options.seed);
  Tally tally;
  if (options.only_pair) write_operands(pairs.at(*options.only_pair), options.folder);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (options.only_pair.value_or(i) == i) add_pair(i, pairs[i], tally);
  }
  print_summary(options.seed, tally);
  if (tally.of(Verdict::Differ) != 0) return 1;
  if (options.only_pair || (tally.of(Verdict::Agree) >= least_compared && tally.noticed >= least_compared / 2)) return 0;
  std::printf("fewer than %zu pairs compared, or swapped answers noticed in fewer than half as many\n", least_compared);
  return 1;
}
