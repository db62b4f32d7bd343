// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// An order of facets by where they are: it decides where their numbers, and with these the order of operands, must not.
#pragma once

#include <algorithm>

#include "mortise/arrange/facets.h"

namespace mortise {

/// Less, for facets: by their exact corners. Different facets are equal only where an operand keeps coincident faces apart.
class FacetOrder {
 public:
  FacetOrder(const OperandFaces& faces, const Facets& facets) : points_(faces.points), facets_(facets) {}

  [[nodiscard]] bool operator()(FacetId f, FacetId g) const {
    if (f == g) return false;
    const PlanePoints a = sorted_corners(f), b = sorted_corners(g);
    const auto different = std::mismatch(a.begin(), a.end(), b.begin());
    return different.first != a.end() && is_before(*different.first, *different.second);
  }

 private:
  [[nodiscard]] PlanePoints sorted_corners(FacetId f) const {
    PlanePoints corners = facets_.corners[f];
    std::sort(corners.begin(), corners.end(), [&](PointId p, PointId q) { return is_before(p, q); });
    return corners;
  }

  [[nodiscard]] bool is_before(PointId p, PointId q) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const Sign order = points_.compare(p, q, i);
      if (order != Sign::Zero) return order == Sign::Negative;
    }
    return false;
  }

  const PointSet& points_;
  const Facets& facets_;
};

}  // namespace mortise
