// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The mesh made of the polygons of a file.
#include "mortise/io/polygon_soup.h"

#include "io/io_support.h"

using namespace mortise;
using namespace mortise::test;

namespace {

PolygonSoup soup_of(std::vector<Vec3d> points, const std::vector<std::vector<std::uint32_t>>& polygons) {
  PolygonSoup soup;
  soup.points = std::move(points);
  for (const auto& polygon : polygons) {
    soup.corners.insert(soup.corners.end(), polygon.begin(), polygon.end());
    soup.end_face();
  }
  return soup;
}

const std::vector<Vec3d> square_points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

/// Twice the signed area of the triangles in the plane z = 0.
double double_area(const SurfaceMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3d& a = mesh.points[t[0].index()];
    sum += cross(mesh.points[t[1].index()] - a, mesh.points[t[2].index()] - a).z;
  }
  return sum;
}

bool has_flipped_triangle(const SurfaceMesh& mesh) {
  for (const Triangle& t : mesh.triangles) {
    const Vec3d& a = mesh.points[t[0].index()];
    if (cross(mesh.points[t[1].index()] - a, mesh.points[t[2].index()] - a).z <= 0) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("Equal positions are welded in order of first appearance, unused points stay") {
  const SurfaceMesh mesh = build_mesh(soup_of({{5, 5, 5}, {0, 0, 0}, {1, 0, 0}, {-0.0, 0, 0}, {0, 1, 0}}, {{1, 2, 4}, {4, 2, 3}}));
  CHECK(mesh.points.size() == 4);
  CHECK(mesh.triangles == std::vector<Triangle>{triangle(1, 2, 3), triangle(3, 2, 1)});
}

TEST_CASE("A polygon gives its triangles in place, each with the label of the polygon") {
  PolygonSoup soup = soup_of(square_points, {{0, 1, 2}, {0, 1, 2, 3}, {0, 2, 3}});
  soup.face_labels = {1, 0, 1};
  soup.label_names = {"square", "triangle"};
  const SurfaceMesh mesh = build_mesh(soup);
  CHECK(mesh.triangles.size() == 4);
  CHECK(mesh.face_labels == std::vector<std::uint32_t>{1, 0, 0, 1});
  CHECK(mesh.label_names == soup.label_names);
}

TEST_CASE("A corner that repeats the one before is dropped from polygons, also across the end and after welding") {
  CHECK(build_mesh(soup_of(square_points, {{0, 0, 1, 2, 2, 3, 0}})).triangles.size() == 2);
  CHECK(build_mesh(soup_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}}, {{0, 1, 2, 3}})).triangles ==
        std::vector<Triangle>{triangle(0, 1, 2)});
}

TEST_CASE("No face vanishes: degenerate triangles stay, degenerate polygons give one degenerate triangle") {
  CHECK(build_mesh(soup_of(square_points, {{0, 0, 1}, {2, 2, 2}})).triangles ==
        std::vector<Triangle>{triangle(0, 0, 1), triangle(2, 2, 2)});
  CHECK(build_mesh(soup_of(square_points, {{0, 0, 1, 1}})).triangles == std::vector<Triangle>{triangle(0, 1, 1)});
  CHECK(build_mesh(soup_of(square_points, {{3, 3, 3, 3}})).triangles == std::vector<Triangle>{triangle(3, 3, 3)});
}

TEST_CASE("Concave polygons are covered without overlap") {
  // An L of area 3 that a fan from its first corner would leave.
  const SurfaceMesh l_shape = build_mesh(soup_of({{1, 2, 0}, {0, 2, 0}, {0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}}, {{0, 1, 2, 3, 4, 5}}));
  CHECK(l_shape.triangles.size() == 4);
  CHECK(double_area(l_shape) == 6);
  CHECK_FALSE(has_flipped_triangle(l_shape));
  // A comb whose teeth a fan cuts across.
  const SurfaceMesh comb = build_mesh(soup_of(
      {{0, 0, 0}, {6, 0, 0}, {6, 4, 0}, {5, 1, 0}, {4, 4, 0}, {3, 1, 0}, {2, 4, 0}, {1, 1, 0}, {0, 4, 0}}, {{0, 1, 2, 3, 4, 5, 6, 7, 8}}));
  CHECK(comb.triangles.size() == 7);
  CHECK(double_area(comb) == 30);
  CHECK_FALSE(has_flipped_triangle(comb));
}

TEST_CASE("Labels are numbered in the order of their first use") {
  LabelTable labels;
  CHECK_FALSE(labels.has_names());
  CHECK(labels.label_of("") == 0);
  CHECK_FALSE(labels.has_names());
  CHECK(labels.label_of("b") == 1);
  CHECK(labels.label_of("a") == 2);
  CHECK(labels.label_of("b") == 1);
  CHECK(labels.has_names());
  CHECK(labels.names() == std::vector<std::string>{"", "b", "a"});
}
