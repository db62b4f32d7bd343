// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Copies between JavaScript's typed arrays and the library's plain arrays.
#include "arrays.h"

#include <utility>

#include "mortise/mesh/validate.h"

namespace mortise::wasm {
namespace {

using emscripten::val;

// The library keeps points and triangles without gaps, so their numbers can be copied in one piece.
static_assert(sizeof(std::array<std::uint32_t, 2>) == 2 * sizeof(std::uint32_t));
static_assert(sizeof(Vec3d) == 3 * sizeof(double) && sizeof(Triangle) == 3 * sizeof(std::uint32_t));

std::span<const double> numbers_of(const std::vector<Vec3d>& points) {
  return {reinterpret_cast<const double*>(points.data()), 3 * points.size()};
}

std::span<const std::uint32_t> numbers_of(const std::vector<Triangle>& triangles) {
  return {reinterpret_cast<const std::uint32_t*>(triangles.data()), 3 * triangles.size()};
}

std::size_t length_of(const val& array) { return array["length"].as<std::size_t>(); }

std::vector<Triangle> triangles_in(const val& array) {
  std::vector<Triangle> triangles(length_of(array) / 3);
  copy_in<std::uint32_t>(array, {reinterpret_cast<std::uint32_t*>(triangles.data()), 3 * triangles.size()});
  return triangles;
}

std::vector<Triangle> triangles_in_order(std::size_t point_count) {
  std::vector<Triangle> triangles(point_count / 3);
  for (std::size_t i = 0; i < triangles.size(); ++i) triangles[i] = {VertexId(3 * i), VertexId(3 * i + 1), VertexId(3 * i + 2)};
  return triangles;
}

std::vector<std::uint8_t> bytes_of_faces(const val& array) {
  return array.isUndefined() ? std::vector<std::uint8_t>() : numbers_in<std::uint8_t>(array);
}

DataKind kind_from(const std::string& name) {
  return name == "normal" ? DataKind::Normal : name == "vector" ? DataKind::Vector : DataKind::Value;
}

std::vector<DataChannel> channels_in(const val& array) {
  std::vector<DataChannel> channels;
  const std::size_t count = array.isUndefined() ? 0 : length_of(array);
  for (std::size_t i = 0; i < count; ++i) {
    const val object = array[i];
    DataChannel channel{
        object["name"].as<std::string>(), object["components"].as<std::uint32_t>(), kind_from(object["kind"].as<std::string>()), {}};
    channel.values = numbers_in<double>(object["values"]);
    channels.push_back(std::move(channel));
  }
  return channels;
}

void set_channels(val& mesh, const char* key, const std::vector<DataChannel>& channels) {
  if (channels.empty()) return;
  val object = val::object();
  for (const DataChannel& channel : channels) {
    val entry = val::object();
    entry.set("components", channel.components);
    entry.set("values", copy_out(channel.values));
    if (channel.kind != DataKind::Value) entry.set("kind", std::string(channel.kind == DataKind::Normal ? "normal" : "vector"));
    object.set(channel.name, entry);
  }
  mesh.set(key, object);
}

SurfaceMesh unchecked_mesh_in(const val& object) {
  SurfaceMesh mesh;
  mesh.points = points_in(object["positions"]);
  const val triangles = object["triangles"];
  mesh.triangles = triangles.isUndefined() ? triangles_in_order(mesh.points.size()) : triangles_in(triangles);
  mesh.walls = bytes_of_faces(object["walls"]);
  mesh.diagonals = bytes_of_faces(object["diagonals"]);
  mesh.vertex_data = channels_in(object["vertexData"]);
  mesh.corner_data = channels_in(object["cornerData"]);
  const val labels = object["faceLabels"];
  if (labels.isUndefined()) return mesh;
  mesh.face_labels = numbers_in<std::uint32_t>(labels);
  mesh.label_names = strings_in(object["labelNames"]);
  return mesh;
}

}  // namespace

std::vector<std::string> strings_in(const val& array) {
  std::vector<std::string> strings(length_of(array));
  for (std::size_t i = 0; i < strings.size(); ++i) strings[i] = array[i].as<std::string>();
  return strings;
}

std::vector<Vec3d> points_in(const val& array) {
  std::vector<Vec3d> points(length_of(array) / 3);
  copy_in<double>(array, {reinterpret_cast<double*>(points.data()), 3 * points.size()});
  return points;
}

val points_out(const std::vector<Vec3d>& points) { return copy_out(numbers_of(points)); }

val pairs_out(const std::vector<std::array<std::uint32_t, 2>>& pairs) {
  return copy_out(std::span<const std::uint32_t>(reinterpret_cast<const std::uint32_t*>(pairs.data()), 2 * pairs.size()));
}

val strings_out(const std::vector<std::string>& strings) {
  val array = val::array();
  for (const std::string& text : strings) array.call<void>("push", text);
  return array;
}

SurfaceMesh mesh_in(const val& object) {
  SurfaceMesh mesh = unchecked_mesh_in(object);
  validate(mesh);
  return mesh;
}

val mesh_out(const SurfaceMesh& mesh) {
  val object = val::object();
  object.set("positions", points_out(mesh.points));
  object.set("triangles", copy_out(numbers_of(mesh.triangles)));
  if (!mesh.walls.empty()) object.set("walls", copy_out(mesh.walls));
  if (!mesh.diagonals.empty()) object.set("diagonals", copy_out(mesh.diagonals));
  set_channels(object, "vertexData", mesh.vertex_data);
  set_channels(object, "cornerData", mesh.corner_data);
  if (mesh.face_labels.empty()) return object;
  object.set("faceLabels", copy_out(mesh.face_labels));
  object.set("labelNames", strings_out(mesh.label_names));
  return object;
}

Plane plane_in(const val& numbers) {
  std::array<double, 4> n{};
  copy_in<double>(numbers, n);
  return {{n[0], n[1], n[2]}, n[3]};
}

std::string bytes_in(const val& array) {
  std::string bytes(length_of(array), '\0');
  copy_in<std::uint8_t>(array, {reinterpret_cast<std::uint8_t*>(bytes.data()), bytes.size()});
  return bytes;
}

val bytes_out(const std::string& bytes) {
  return copy_out(std::span<const std::uint8_t>(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()));
}

}  // namespace mortise::wasm
