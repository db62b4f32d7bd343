// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Elapsed time for reports; nothing ever depends on it.
#pragma once

#include <chrono>

namespace mortise {

class Stopwatch {
 public:
  [[nodiscard]] double milliseconds() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace mortise
