// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Times booleans stage by stage: boolean_bench [FILE_A FILE_B]; without files, generated shapes of growing size. FILE_B may be
// `turned`: the first file turned by 90 degrees about y. boolean_bench dragging [FILE]: only the rows of a part in
// many places; with a file, of it along itself.
// Prints medians of eleven runs (three of the large decks) in milliseconds, and how far one call raised the memory of a process of
// its own.
#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "mortise/base/stopwatch.h"
#include "mortise/mortise.h"

namespace {

using namespace mortise;

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void time_operation(const std::string& name, Operation operation, const SurfaceMesh& a, const SurfaceMesh& b, int runs = 11) {
  std::vector<double> totals;
  std::map<std::string, std::vector<double>> stages;
  std::vector<std::string> order;
  const SurfaceMesh* const operands[] = {&a, &b};
  for (int run = 0; run < runs; ++run) {
    const Stopwatch watch;
    const BooleanResult result = evaluate_boolean(operation, operands);
    totals.push_back(watch.milliseconds());
    for (const StageTime& s : result.report.stages) {
      if (run == 0) order.push_back(s.stage);
      stages[s.stage].push_back(s.milliseconds);
    }
  }
  std::printf("%-34s %-9s %8zu + %7zu triangles  %9.2f ms  (", name.c_str(), std::string(operation_name(operation)).c_str(),
              a.triangles.size(), b.triangles.size(), median(totals));
  for (const std::string& s : order) std::printf("%s %.2f%s", s.c_str(), median(stages[s]), s == order.back() ? ")\n" : ", ");
}

long resident_peak_kilobytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

/// By how many kilobytes a union raises the peak of a fresh process; 0 when that cannot be measured.
long memory_of_union(const SurfaceMesh& a, const SurfaceMesh& b) {
  int ends[2];
  if (pipe(ends) != 0) return 0;
  long growth = 0;
  malloc_trim(0);  // what this process has freed must not be there for the other to take
  if (const pid_t child = fork(); child == 0) {
    const long before = resident_peak_kilobytes();
    const BooleanResult result = unite(a, b);
    growth = resident_peak_kilobytes() - before;
    _exit(write(ends[1], &growth, sizeof growth) == sizeof growth ? 0 : 1);
  } else {
    waitpid(child, nullptr, 0);
  }
  close(ends[1]);
  if (read(ends[0], &growth, sizeof growth) != sizeof growth) growth = 0;
  close(ends[0]);
  return growth;
}

void print_memory(const std::string& name, const SurfaceMesh& a, const SurfaceMesh& b) {
  const long kilobytes = memory_of_union(a, b);
  const auto triangles = static_cast<double>(a.triangles.size() + b.triangles.size());
  std::printf("%-34s memory of a union: %ld MB, %.0f bytes per triangle of the operands\n", name.c_str(), kilobytes / 1024,
              1024 * static_cast<double>(kilobytes) / triangles);
}

void time_pair(const std::string& name, const SurfaceMesh& a, const SurfaceMesh& b) {
  print_memory(name, a, b);
  for (const Operation operation : {Operation::Union, Operation::Intersect, Operation::Subtract}) time_operation(name, operation, a, b);
}

/// One coplanar cluster: a deck of n x n cells and another one standing on it, moved by a tenth, so that columns of points of both
/// are an ulp apart.
void time_decks() {
  for (const std::uint32_t cells : {50U, 100U, 200U, 350U}) {
    const SurfaceMesh sheet = make_grid_sheet(1, 1, cells, cells);
    const SurfaceMesh lower = extrude_to(sheet, -1);
    const SurfaceMesh upper = extrude_to(transform(sheet, translation({0.1, 0.05, 0})), 1);
    print_memory("flush decks", lower, upper);
    time_operation("flush decks", Operation::Union, lower, upper, 3);
  }
}

/// Collects the times of calls, and of their stages.
class CallTimes {
 public:
  void add(double milliseconds, const BooleanReport& report) {
    totals_.push_back(milliseconds);
    for (const StageTime& s : report.stages) {
      if (totals_.size() == 1) order_.push_back(s.stage);
      stages_[s.stage].push_back(s.milliseconds);
    }
  }
  [[nodiscard]] double total() const { return median(totals_); }
  void print(const char* what) const {
    std::printf("    %-9s %9.2f ms  (", what, total());
    for (const std::string& s : order_) std::printf("%s %.2f%s", s.c_str(), median(stages_.at(s)), s == order_.back() ? ")\n" : ", ");
  }

 private:
  std::vector<double> totals_;
  std::map<std::string, std::vector<double>> stages_;
  std::vector<std::string> order_;
};

/// A part dragged along a host: in every place a fresh call, its part moved by transform(), and one with both prepared.
void time_dragging(const std::string& name, Operation operation, const SurfaceMesh& host, const SurfaceMesh& part, const Vec3d& step) {
  const Stopwatch preparation;
  const PreparedOperand prepared_host(host), prepared_part(part);
  const double milliseconds = preparation.milliseconds();
  CallTimes fresh, prepared;
  for (int i = 0; i < 21; ++i) {
    const AffineMap place = compose(rotation(Axis::Z, 3.0 * i), translation(static_cast<double>(i - 10) * step));
    const Stopwatch first;
    const SurfaceMesh image = transform(part, place);
    const SurfaceMesh* const operands[] = {&host, &image};
    const BooleanResult a = evaluate_boolean(operation, operands);
    fresh.add(first.milliseconds(), a.report);
    const Stopwatch second;
    const BooleanResult b = evaluate_boolean(operation, std::array{Operand(prepared_host), Operand(prepared_part, place)});
    prepared.add(second.milliseconds(), b.report);
    if (a.mesh.triangles != b.mesh.triangles) std::printf("    NOT THE SAME\n");
  }
  std::printf("dragging: %-24s %-9s %8zu + %7zu triangles, prepared in %.2f ms; a place prepared / fresh: %.2f\n", name.c_str(),
              std::string(operation_name(operation)).c_str(), host.triangles.size(), part.triangles.size(), milliseconds,
              prepared.total() / fresh.total());
  fresh.print("fresh");
  prepared.print("prepared");
}

void time_all_dragging() {
  const SurfaceMesh large = make_icosphere(1, 6), small = make_icosphere(0.25, 5);
  const SurfaceMesh torus = make_torus(0.5, 0.125, 256, 64);
  const SurfaceMesh ground = make_grid_sheet(4, 4, 200, 200);
  for (const Operation operation : {Operation::Union, Operation::Subtract}) {
    time_dragging("two icospheres", operation, large, large, {0.05, 0, 0});
    time_dragging("ball into a large ball", operation, large, small, {0.1, 0, 0});
    time_dragging("small ball, large tool", operation, small, large, {0.1, 0, 0});
  }
  time_dragging("torus through a ball", Operation::Partition, large, torus, {0.05, 0, 0});
  time_dragging("torus through a sheet", Operation::Partition, ground, torus, {0.05, 0, 0});
}

void time_generated() {
  for (const std::uint32_t levels : {4U, 5U, 6U, 7U}) {
    const SurfaceMesh sphere = make_icosphere(1, levels);
    const AffineMap place = compose(rotation(Axis::X, 17), translation({0.5, 0.3, 0.1}));
    time_pair("icospheres", sphere, transform(sphere, place));
  }
  const SurfaceMesh plate = transform(make_box({0, 0, 0}, {1, 1, 1}), scaling({20, 20, 1}));
  time_pair("plate and torus, coplanar rings", plate, transform(make_torus(4, 1, 512, 64), translation({10, 10, 1})));
  time_pair("two boxes sharing a face", make_box({0, 0, 0}, {1, 1, 1}), make_box({1, 0, 0}, {2, 1, 1}));
  time_decks();
  time_all_dragging();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc == 2 && std::string(argv[1]) == "dragging") {
      time_all_dragging();
    } else if (argc == 3 && std::string(argv[1]) == "dragging") {
      const SurfaceMesh a = read_mesh_file(argv[2]);
      const Box3 box = bounding_box(a);
      time_dragging(std::string(argv[2]) + " along itself", Operation::Union, a, a, 0.02 * (box.hi - box.lo));
    } else if (argc == 3) {
      const SurfaceMesh a = read_mesh_file(argv[1]);
      const bool is_turned = std::string(argv[2]) == "turned";
      time_pair(std::string(argv[1]) + " " + argv[2], a, is_turned ? transform(a, rotation(Axis::Y, 90)) : read_mesh_file(argv[2]));
    } else {
      time_generated();
    }
  } catch (const Error& error) {
    std::fprintf(stderr, "%s: %s\n", error.stage.c_str(), error.what());
    return 1;
  }
  return 0;
}
