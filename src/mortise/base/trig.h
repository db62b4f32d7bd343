// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Trigonometry, exp and log that give the same bits on every machine: + - * / and sqrt only, no libm.
#pragma once

namespace mortise::trig {

/// Sine and cosine of an angle in radians; any finite angle, NaN otherwise. Within 1 ulp.
[[nodiscard]] double sin(double x);
[[nodiscard]] double cos(double x);

/// Sine and cosine of an angle in degrees; exact at every multiple of 30 that has a short answer (0, 1/2, 1), symmetric
/// round every multiple of 45, never -0. Within 1 ulp; NaN unless finite.
[[nodiscard]] double sin_deg(double degrees);
[[nodiscard]] double cos_deg(double degrees);

/// Angle of (x, y) in (-pi, pi], with the signs of zeros and infinities of C. Within 1 ulp.
[[nodiscard]] double atan2(double y, double x);

/// Angle in [0, pi]; NaN outside [-1, 1]. Within 1 ulp.
[[nodiscard]] double acos(double x);

/// e to the x: 0 and infinity beyond the range. Within 1 ulp.
[[nodiscard]] double exp(double x);

/// Natural logarithm: -infinity at 0, NaN below. Within 1 ulp.
[[nodiscard]] double log(double x);

[[nodiscard]] double to_degrees(double radians);

}  // namespace mortise::trig
