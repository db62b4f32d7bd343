// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Reads the resident memory of this process and its peak from /proc.
#include "measure_cost.h"

#include <malloc.h>

#include <cstdio>
#include <fstream>
#include <string>

#include "mortise/base/stopwatch.h"

namespace mortise::peers {
namespace {

/// A line of /proc/self/status in megabytes; 0 where there is none.
double status_megabytes(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind(key + ":", 0) == 0) return std::strtod(line.c_str() + key.size() + 1, nullptr) / 1024;
  }
  return 0;
}

/// Freed memory goes back to the system, and the peak starts again at what is left.
void reset_peak() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << 5;
}

}  // namespace

Cost measure_cost(const std::function<void()>& call) {
  reset_peak();
  const double before = status_megabytes("VmRSS");
  const Stopwatch watch;
  call();
  const double milliseconds = watch.milliseconds();
  return {milliseconds, status_megabytes("VmHWM") - before};
}

}  // namespace mortise::peers
