// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// orient3d for many points and one plane: what depends on the plane alone is computed once.
#pragma once

#include "mortise/exact/filters.h"
#include "mortise/exact/predicates.h"

namespace mortise {

/// The plane (a, b, c) of input points; these must outlive it.
class SidesOfPlane {
 public:
  SidesOfPlane(const Vec3d& a, const Vec3d& b, const Vec3d& c) : a_(a), b_(b), c_(c), filter_(a, b, c) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (a[i] == b[i] && a[i] == c[i]) across_ = i;
    }
  }

  /// orient3d(a, b, c, d).
  [[nodiscard]] Sign of(const Vec3d& d) const {
    if (across_ < 3 && d[across_] == a_[across_]) return Sign::Zero;
    const auto sign = filter_.side_of({d, {}});
    return sign ? *sign : orient3d(a_, b_, c_, d);
  }

 private:
  const Vec3d &a_, &b_, &c_;
  filters::Plane filter_;
  std::size_t across_ = 3;  // the axis that the plane is across, if it is across one
};

}  // namespace mortise
