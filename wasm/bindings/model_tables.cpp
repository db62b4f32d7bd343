// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// One typed array for each column. On the way in every number is looked at, so that tables may be indexed by.
#include "model_tables.h"

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "arrays.h"
#include "mortise/base/error.h"

namespace mortise::wasm {
namespace {

using emscripten::val;

void set_entities(const Brep& brep, val& object) {
  object.set("edgeStart", numbers_out(brep.edges, [](const ModelEdge& e) { return e.start.value; }));
  object.set("edgeEnd", numbers_out(brep.edges, [](const ModelEdge& e) { return e.end.value; }));
  object.set("edgeIsSeam", numbers_out(brep.edges, [](const ModelEdge& e) { return e.is_seam; }));
  object.set("faceGenus", numbers_out(brep.faces, [](const ModelFace& f) { return f.genus; }));
  object.set("faceBehind", numbers_out(brep.faces, [](const ModelFace& f) { return f.region_behind.value; }));
  object.set("faceInFront", numbers_out(brep.faces, [](const ModelFace& f) { return f.region_in_front.value; }));
  object.set("loopStart", numbers_out(brep.loops, [](const ModelLoop& l) { return l.start.value; }));
  object.set("shellRegion", ids_out(brep.region_of_shell));
}

void set_adjacency(const Brep& brep, val& object) {
  object.set("loopsOfFaceBegin", copy_out(brep.loops_of_face.begin));
  object.set("usesOfLoopBegin", copy_out(brep.uses_of_loop.begin));
  object.set("useEdge", numbers_out(brep.uses_of_loop.items, [](const EdgeUse& u) { return u.edge.value; }));
  object.set("useIsReversed", numbers_out(brep.uses_of_loop.items, [](const EdgeUse& u) { return u.is_reversed; }));
  object.set("sidesOfShellBegin", copy_out(brep.sides_of_shell.begin));
  object.set("sideFace", numbers_out(brep.sides_of_shell.items, [](const FaceSide& s) { return s.face.value; }));
  object.set("sideIsFront", numbers_out(brep.sides_of_shell.items, [](const FaceSide& s) { return s.is_front; }));
  object.set("shellsOfRegionBegin", copy_out(brep.shells_of_region.begin));
  object.set("shellsOfRegion", ids_out(brep.shells_of_region.items));
  object.set("edgesOfVertexBegin", copy_out(brep.edges_of_vertex.begin));
  object.set("edgesOfVertex", ids_out(brep.edges_of_vertex.items));
  object.set("facesOfEdgeBegin", copy_out(brep.faces_of_edge.begin));
  object.set("faceOfEdge", numbers_out(brep.faces_of_edge.items, [](const FaceUse& u) { return u.face.value; }));
  object.set("faceOfEdgeIsReversed", numbers_out(brep.faces_of_edge.items, [](const FaceUse& u) { return u.is_reversed; }));
}

void set_classification(const Classification& on, val& object) {
  object.set("meshVertex", ids_out(on.mesh_vertex));
  object.set("pathBegin", copy_out(on.path.begin));
  object.set("path", ids_out(on.path.items));
  object.set("triangleFace", ids_out(on.face_of_triangle));
  object.set("vertexDimension", numbers_out(on.entity_of_vertex, [](const ModelEntity& e) { return e.dimension; }));
  object.set("vertexEntity", numbers_out(on.entity_of_vertex, [](const ModelEntity& e) { return e.id; }));
}

val measures_out(const ModelView& view, EntityDimension dimension) {
  std::vector<double> measures;
  for (std::uint32_t i = 0; i < entity_count(view.model.brep, dimension); ++i) measures.push_back(measure(view, {dimension, i}));
  return copy_out(measures);
}

/// How many there are of what tables name.
struct Counts {
  std::size_t points, triangles, vertices, edges, faces, regions, loops, shells;
};

Counts counts_in(const val& object, const SurfaceMesh& mesh) {
  const auto rows = [&](const char* name) { return object[name]["length"].as<std::size_t>(); };
  return {mesh.points.size(), mesh.triangles.size(),           rows("meshVertex"), rows("edgeStart"),
          rows("faceGenus"),  rows("shellsOfRegionBegin") - 1, rows("loopStart"),  rows("shellRegion")};
}

[[noreturn]] void refuse_table(const char* name) {
  throw Error(ErrorCode::InvalidArgument, "", std::string("the tables of the model are not those of its mesh: ") + name);
}

/// A table, and what its numbers are below.
struct Column {
  static constexpr std::size_t any = std::size_t{1} << 31;

  const char* name;
  std::size_t limit = any;
};

std::vector<std::uint32_t> column_in(const val& object, const Column& column) {
  auto numbers = numbers_in<std::uint32_t>(object[column.name]);
  if (!std::all_of(numbers.begin(), numbers.end(), [&](std::uint32_t n) { return n < column.limit; })) refuse_table(column.name);
  return numbers;
}

/// Of lists of so many owners, of so many items.
std::vector<std::uint32_t> begin_in(const val& object, const char* name, std::size_t owners, std::size_t items) {
  auto begin = column_in(object, {name});
  const bool fits = !begin.empty() && begin.size() == owners + 1 && begin.front() == 0 && begin.back() == items &&
                    std::is_sorted(begin.begin(), begin.end());
  if (!fits) refuse_table(name);
  return begin;
}

/// Columns of equal length, row after row.
std::vector<std::uint32_t> rows_in(const val& object, std::initializer_list<Column> columns) {
  std::vector<std::uint32_t> rows;
  std::size_t k = 0;
  for (const Column& column : columns) {
    const std::vector<std::uint32_t> numbers = column_in(object, column);
    if (k == 0) rows.resize(numbers.size() * columns.size());
    if (rows.size() != numbers.size() * columns.size()) refuse_table(column.name);
    for (std::size_t i = 0; i < numbers.size(); ++i) rows[columns.size() * i + k] = numbers[i];
    ++k;
  }
  return rows;
}

/// @param make  the numbers of a row -> item
template <class Items, class Make>
Items items_in(const val& object, std::initializer_list<Column> columns, Make make) {
  const std::vector<std::uint32_t> rows = rows_in(object, columns);
  Items items;
  for (std::size_t i = 0; i < rows.size(); i += columns.size()) items.push_back(make(&rows[i]));
  return items;
}

template <class Ids>
Ids ids_in(const val& object, const Column& column) {
  using Id = std::decay_t<decltype(*std::declval<Ids>().begin())>;
  return items_in<Ids>(object, {column}, [](const std::uint32_t* row) { return Id(*row); });
}

void get_entities(const val& object, const Counts& n, Brep& brep) {
  brep.vertex_count = n.vertices;
  brep.edges = items_in<decltype(brep.edges)>(object, {{"edgeStart", n.vertices}, {"edgeEnd", n.vertices}, {"edgeIsSeam"}},
                                              [](const std::uint32_t* row) {
                                                return ModelEdge{ModelVertexId(row[0]), ModelVertexId(row[1]), row[2] != 0};
                                              });
  brep.faces = items_in<decltype(brep.faces)>(object, {{"faceGenus"}, {"faceBehind", n.regions}, {"faceInFront", n.regions}},
                                              [](const std::uint32_t* row) {
                                                return ModelFace{row[0], ModelRegionId(row[1]), ModelRegionId(row[2])};
                                              });
  brep.region_of_shell = ids_in<decltype(brep.region_of_shell)>(object, {"shellRegion", n.regions});
  brep.region_count = n.regions;
}

/// Loops are by face, ascending.
void get_loops(const val& object, const Counts& n, Brep& brep) {
  const auto starts = column_in(object, {"loopStart", n.vertices});
  brep.loops_of_face.begin = begin_in(object, "loopsOfFaceBegin", n.faces, n.loops);
  for (std::size_t f = 0; f < n.faces; ++f) {
    for (std::uint32_t l = brep.loops_of_face.begin[f]; l < brep.loops_of_face.begin[f + 1]; ++l)
      brep.loops_of_face.items.push_back(brep.loops.push_back({ModelFaceId(f), ModelVertexId(starts[l])}));
  }
  brep.uses_of_loop.items = items_in<std::vector<EdgeUse>>(object, {{"useEdge", n.edges}, {"useIsReversed"}}, [](const std::uint32_t* row) {
    return EdgeUse{ModelEdgeId(row[0]), row[1] != 0};
  });
  brep.uses_of_loop.begin = begin_in(object, "usesOfLoopBegin", n.loops, brep.uses_of_loop.items.size());
}

void get_adjacency(const val& object, const Counts& n, Brep& brep) {
  brep.sides_of_shell.items =
      items_in<std::vector<FaceSide>>(object, {{"sideFace", n.faces}, {"sideIsFront"}}, [](const std::uint32_t* row) {
        return FaceSide{ModelFaceId(row[0]), row[1] != 0};
      });
  brep.sides_of_shell.begin = begin_in(object, "sidesOfShellBegin", n.shells, brep.sides_of_shell.items.size());
  brep.shells_of_region.items = ids_in<std::vector<ShellId>>(object, {"shellsOfRegion", n.shells});
  brep.shells_of_region.begin = begin_in(object, "shellsOfRegionBegin", n.regions, brep.shells_of_region.items.size());
  brep.edges_of_vertex.items = ids_in<std::vector<ModelEdgeId>>(object, {"edgesOfVertex", n.edges});
  brep.edges_of_vertex.begin = begin_in(object, "edgesOfVertexBegin", n.vertices, brep.edges_of_vertex.items.size());
  brep.faces_of_edge.items =
      items_in<std::vector<FaceUse>>(object, {{"faceOfEdge", n.faces}, {"faceOfEdgeIsReversed"}}, [](const std::uint32_t* row) {
        return FaceUse{ModelFaceId(row[0]), row[1] != 0};
      });
  brep.faces_of_edge.begin = begin_in(object, "facesOfEdgeBegin", n.edges, brep.faces_of_edge.items.size());
}

bool is_there(const ModelEntity& entity, const Counts& n) {
  const std::size_t counts[] = {n.vertices, n.edges, n.faces};
  return entity.dimension == EntityDimension::None ||
         (entity.dimension < EntityDimension::Region && entity.id < counts[static_cast<std::size_t>(entity.dimension)]);
}

void get_classification(const val& object, const Counts& n, Classification& on) {
  on.mesh_vertex = ids_in<decltype(on.mesh_vertex)>(object, {"meshVertex", n.points});
  on.path.items = ids_in<std::vector<VertexId>>(object, {"path", n.points});
  on.path.begin = begin_in(object, "pathBegin", n.edges, on.path.items.size());
  const auto is_no_path = [](std::uint32_t begin, std::uint32_t end) { return end < begin + 2; };
  if (std::adjacent_find(on.path.begin.begin(), on.path.begin.end(), is_no_path) != on.path.begin.end()) refuse_table("pathBegin");
  on.face_of_triangle = ids_in<std::vector<ModelFaceId>>(object, {"triangleFace", n.faces});
  if (on.face_of_triangle.size() != n.triangles) refuse_table("triangleFace");
  on.entity_of_vertex = items_in<std::vector<ModelEntity>>(object, {{"vertexDimension"}, {"vertexEntity"}}, [](const std::uint32_t* row) {
    return ModelEntity{static_cast<EntityDimension>(row[0]), row[1]};
  });
  const bool are_there =
      std::all_of(on.entity_of_vertex.begin(), on.entity_of_vertex.end(), [&](const ModelEntity& entity) { return is_there(entity, n); });
  if (on.entity_of_vertex.size() != n.points || !are_there) refuse_table("vertexEntity");
}

}  // namespace

val tables_out(const ModelView& view) {
  val object = val::object();
  set_entities(view.model.brep, object);
  set_adjacency(view.model.brep, object);
  set_classification(view.model.classification, object);
  object.set("regionIsVoid", copy_out(find_voids(view.mesh, view.model)));
  object.set("edgeLength", measures_out(view, EntityDimension::Edge));
  object.set("faceArea", measures_out(view, EntityDimension::Face));
  object.set("regionVolume", measures_out(view, EntityDimension::Region));
  return object;
}

ClassifiedBrep tables_in(const val& object, const SurfaceMesh& mesh) {
  const Counts counts = counts_in(object, mesh);
  ClassifiedBrep model;
  get_entities(object, counts, model.brep);
  get_loops(object, counts, model.brep);
  get_adjacency(object, counts, model.brep);
  get_classification(object, counts, model.classification);
  return model;
}

}  // namespace mortise::wasm
