// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// How many random cases a test runs.
#include "support/test_scale.h"

#include <algorithm>

namespace mortise::test {
namespace {

bool long_run = false;

}  // namespace

void set_long_run(bool is_long) { long_run = is_long; }

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
