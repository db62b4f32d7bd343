// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The formulas of the exact core, each written once for every number type: determinants, and points as base + offset / w.
// All numbers enter as differences of input coordinates, which keeps degrees and cancellation low.
#pragma once

#include <array>

#include "mortise/geom/vec.h"

namespace mortise {

/// The two coordinates kept by a projection along `axis`, in the order that keeps orientation.
[[nodiscard]] constexpr std::array<std::size_t, 2> kept_coordinates(Axis axis) {
  const auto dropped = static_cast<std::size_t>(axis);
  return {(dropped + 1) % 3, (dropped + 2) % 3};
}

template <class T>
using Triple = std::array<T, 3>;

template <class T>
[[nodiscard]] Triple<T> difference(const Vec3d& a, const Vec3d& b) {
  return {T::difference(a.x, b.x), T::difference(a.y, b.y), T::difference(a.z, b.z)};
}

/// a * d - b * c. The result has a type of its own for numbers whose type knows their size (Expansion).
template <class T>
[[nodiscard]] auto determinant(const T& a, const T& b, const T& c, const T& d) {
  return a * d - b * c;
}

template <class T>
[[nodiscard]] auto cross(const Triple<T>& a, const Triple<T>& b) {
  return Triple<decltype(a[0] * b[0] - a[0] * b[0])>{determinant(a[1], a[2], b[1], b[2]), determinant(a[2], a[0], b[2], b[0]),
                                                     determinant(a[0], a[1], b[0], b[1])};
}

template <class T, class U>
[[nodiscard]] auto dot(const Triple<T>& a, const Triple<U>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// (b - a) x (c - a), degree 2.
template <class T>
[[nodiscard]] auto normal(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return cross(difference<T>(b, a), difference<T>(c, a));
}

/// The determinant of orient3d, degree 3.
template <class T>
[[nodiscard]] auto orient3d_value(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  return dot(normal<T>(a, b, c), difference<T>(d, a));
}

/// The determinant of orient2d, degree 2.
template <class T>
[[nodiscard]] auto orient2d_value(const Vec3d& a, const Vec3d& b, const Vec3d& c, Axis axis) {
  const auto [u, v] = kept_coordinates(axis);
  return determinant(T::difference(b[u], a[u]), T::difference(b[v], a[v]), T::difference(c[u], a[u]), T::difference(c[v], a[v]));
}

/// The point base + offset / w; the base is an input point and is known to whoever asked.
template <class T>
struct Homogeneous {
  Triple<T> offset;
  T w;
};

template <class T>
[[nodiscard]] Triple<T> scaled(const T& s, const Triple<T>& a) {
  return {s * a[0], s * a[1], s * a[2]};
}

/// Line (points[0], points[1]) x plane (points[2..4]); base points[0]; degrees 4 and 3.
template <class T>
[[nodiscard]] Homogeneous<T> line_plane_point(const std::array<Vec3d, 9>& points) {
  const Triple<T> n = normal<T>(points[2], points[3], points[4]);
  const T height = dot(n, difference<T>(points[0], points[2]));
  const Triple<T> direction = difference<T>(points[1], points[0]);
  return {scaled(height, direction), -dot(n, direction)};
}

/// Line (points[0], points[1]) x line (points[2], points[3]) of one plane; base points[0]; degrees 3 and 2.
template <class T>
[[nodiscard]] Homogeneous<T> line_line_point(const std::array<Vec3d, 9>& points, Axis axis) {
  const auto [u, v] = kept_coordinates(axis);
  const Triple<T> first = difference<T>(points[1], points[0]);
  const Triple<T> second = difference<T>(points[3], points[2]);
  const Triple<T> gap = difference<T>(points[2], points[0]);
  return {scaled(determinant(gap[u], gap[v], second[u], second[v]), first), determinant(first[u], first[v], second[u], second[v])};
}

/// Planes (points[0..2]), (points[3..5]), (points[6..8]); base points[0]; degrees 7 and 6.
template <class T>
[[nodiscard]] Homogeneous<T> three_plane_point(const std::array<Vec3d, 9>& points) {
  const Triple<T> p = normal<T>(points[0], points[1], points[2]);
  const Triple<T> q = normal<T>(points[3], points[4], points[5]);
  const Triple<T> r = normal<T>(points[6], points[7], points[8]);
  const T q_height = dot(q, difference<T>(points[3], points[0]));
  const T r_height = dot(r, difference<T>(points[6], points[0]));
  const Triple<T> pq = cross(p, q);
  const Triple<T> from_q = scaled(q_height, cross(r, p));
  const Triple<T> from_r = scaled(r_height, pq);
  return {{from_q[0] + from_r[0], from_q[1] + from_r[1], from_q[2] + from_r[2]}, dot(pq, r)};
}

}  // namespace mortise
