// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Random places of a part: maps that are exact, maps that round, mirrors, maps that move far away and come close to flattening.
#pragma once

#include "mortise/mesh/transform.h"
#include "support/random_source.h"

namespace mortise::test {

class RandomMaps : public RandomSource {
 public:
  using RandomSource::RandomSource;

  /// A turn, a scale and a move of at most `reach`; exact in doubles, or one that rounds, or a mirror, or any map with an inverse.
  [[nodiscard]] AffineMap next(double reach) {
    switch (below(6)) {
      case 0:
        return compose(quarter_turns(), translation(whole_steps(reach)));
      case 1:
        return compose(scaling(powers_of_two()), translation(whole_steps(reach)));
      case 2:
        return compose(compose(mirroring(axis()), turn()), translation(point(-reach, reach)));
      case 3:
        return compose(scaling(factors()), compose(turn(), translation(point(-reach, reach))));
      case 4:
        return {{point(-1, 1), point(-1, 1), point(-1, 1)}, point(-reach, reach)};
      default:
        return compose(turn(), translation(point(-reach, reach)));
    }
  }

  /// So far away or so flat that different points get the same image.
  [[nodiscard]] AffineMap next_that_welds(double size) {
    const double steps_across = octaves(2, 12);
    if (once_in(2)) return compose(turn(), translation({size * 0x1p53 / steps_across, 0, 0}));
    return compose(scaling({1, 1, 0x1p-1074 * steps_across / size}), quarter_turns());
  }

 private:
  [[nodiscard]] Axis axis() { return static_cast<Axis>(below(3)); }
  [[nodiscard]] AffineMap turn() { return compose(rotation(axis(), between(-180, 180)), rotation(axis(), between(-180, 180))); }
  [[nodiscard]] AffineMap quarter_turns() { return compose(rotation(axis(), quarter()), rotation(axis(), quarter())); }
  [[nodiscard]] double quarter() { return 90.0 * static_cast<double>(below(4)); }
  [[nodiscard]] double power_of_two() { return (once_in(2) ? -1 : 1) * std::ldexp(1.0, static_cast<int>(below(4)) - 2); }
  [[nodiscard]] Vec3d powers_of_two() {
    const double x = power_of_two(), y = power_of_two();
    return {x, y, power_of_two()};
  }
  [[nodiscard]] Vec3d factors() {
    const double x = octaves(-2, 2), y = octaves(-2, 2);
    return {x, y, octaves(-2, 2)};
  }
  /// Eighths of the reach.
  [[nodiscard]] Vec3d whole_steps(double reach) {
    const auto step = [&] { return reach * (static_cast<double>(below(17)) - 8) / 8; };
    const double x = step(), y = step();
    return {x, y, step()};
  }
};

}  // namespace mortise::test
