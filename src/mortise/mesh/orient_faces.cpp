// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Steps of a repair that turn faces over: neighbours that disagree, shells that are inside out.
#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

#include "mortise/geom/box_tree.h"
#include "mortise/mesh/face_marks.h"
#include "mortise/mesh/find_self_crossings.h"
#include "mortise/mesh/ray_crossing.h"
#include "mortise/mesh/repair_steps.h"
#include "mortise/mesh/select_faces.h"
#include "mortise/mesh/topology.h"
#include "mortise/mesh/volume_sign.h"

namespace mortise {
namespace {

/// A set of faces joined by edges of two faces.
struct Surface {
  std::vector<FaceId> faces;
  std::vector<FaceId> turned;  ///< of these: run against the first one
  bool is_orientable = true;
};

/// Walks from face to face over edges of two faces.
class SurfaceWalk {
 public:
  explicit SurfaceWalk(const SurfaceMesh& mesh) : mesh_(mesh), topology_(build_topology(mesh)), way_(mesh.triangles.size(), Way::Unknown) {}

  std::vector<Surface> find_surfaces() {
    std::vector<Surface> surfaces;
    for (std::size_t f = 0; f < mesh_.triangles.size(); ++f) {
      if (way_[f] == Way::Unknown) surfaces.push_back(walk_from(FaceId(f)));
    }
    return surfaces;
  }

 private:
  enum class Way : std::uint8_t { Unknown, AsIs, Turned };

  Surface walk_from(FaceId first) {
    Surface surface;
    surface.faces.push_back(first);
    way_[first.index()] = Way::AsIs;
    for (std::size_t i = 0; i < surface.faces.size(); ++i) visit_neighbours(surface.faces[i], surface);
    for (const FaceId f : surface.faces) {
      if (way_[f.index()] == Way::Turned) surface.turned.push_back(f);
    }
    return surface;
  }

  void visit_neighbours(FaceId f, Surface& surface) {
    const auto first = static_cast<HalfEdge>(3 * f.index());
    for (HalfEdge h = first; h < first + 3; ++h) {
      if (!topology_.edge_of[h].is_valid()) continue;
      const auto uses = topology_.uses_of(topology_.edge_of[h]);
      if (uses.size() != 2) continue;
      const HalfEdge across = uses[0] == h ? uses[1] : uses[0];
      const bool agrees = origin_of(mesh_, across) != origin_of(mesh_, h);
      const Way expected = (way_[f.index()] == Way::AsIs) == agrees ? Way::AsIs : Way::Turned;
      Way& way = way_[face_of(across).index()];
      if (way == Way::Unknown) {
        way = expected;
        surface.faces.push_back(face_of(across));
      } else if (way != expected) {
        surface.is_orientable = false;
      }
    }
  }

  const SurfaceMesh& mesh_;
  MeshTopology topology_;
  std::vector<Way> way_;
};

/// The fewer faces that are to be turned; on a tie the first face stays.
std::vector<FaceId> minority_of(const Surface& surface) {
  if (2 * surface.turned.size() <= surface.faces.size()) return surface.turned;
  std::vector<FaceId> all = surface.faces, turned = surface.turned, others;
  std::sort(all.begin(), all.end());
  std::sort(turned.begin(), turned.end());
  std::set_difference(all.begin(), all.end(), turned.begin(), turned.end(), std::back_inserter(others));
  return others;
}

struct Shell {
  std::vector<FaceId> faces;
  bool is_closed = true;
};

/// Shells as they are after splitting pinches.
std::vector<Shell> find_shells(const SurfaceMesh& mesh) {
  const SplitPinches split = split_pinches(mesh, build_topology(mesh));
  std::vector<Shell> shells(split.shells.count);
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) shells[split.shells.component_of[f]].faces.push_back(FaceId(f));
  const MeshTopology topology = build_topology(split.mesh);
  for (const MeshEdgeId e : find_unbalanced_edges(split.mesh, topology)) {
    for (const HalfEdge h : topology.uses_of(e)) shells[split.shells.component_of[face_of(h).index()]].is_closed = false;
  }
  return shells;
}

/// A shell that has a point of another one in it, and how often it winds round that.
struct Container {
  std::uint32_t shell;
  int winding;
};

/// Which closed shells lie in which.
class Nesting {
 public:
  Nesting(const SurfaceMesh& mesh, const std::vector<Shell>& shells) : mesh_(mesh), shells_(shells), shell_of_face_(mesh.triangles.size()) {
    std::vector<Box3> boxes(mesh.triangles.size());
    for (std::uint32_t s = 0; s < shells.size(); ++s) {
      for (const FaceId f : shells[s].faces) {
        shell_of_face_[f.index()] = s;
        if (!shells[s].is_closed) continue;  // an empty box meets no ray
        for (std::size_t i = 0; i < 3; ++i) boxes[f.index()].extend(corner(f, i));
      }
    }
    tree_ = BoxTree(boxes);
  }

  [[nodiscard]] std::vector<Container> containers_of(std::uint32_t s) const {
    const auto with_area =
        std::find_if(shells_[s].faces.begin(), shells_[s].faces.end(), [&](FaceId f) { return !is_degenerate(mesh_, f); });
    if (with_area == shells_[s].faces.end()) return {};
    const RayStart start{corner(*with_area, 0), corner(*with_area, 1), corner(*with_area, 2)};
    std::vector<Container> steps;
    tree_.for_each_meeting(ray_box(start), [&](std::uint32_t f) {
      if (shell_of_face_[f] == s) return;
      const int step = winding_step(corner(FaceId(f), 0), corner(FaceId(f), 1), corner(FaceId(f), 2), start);
      if (step != 0) steps.push_back({shell_of_face_[f], step});
    });
    return summed(std::move(steps));
  }

 private:
  static std::vector<Container> summed(std::vector<Container> steps) {
    std::stable_sort(steps.begin(), steps.end(), [](const Container& a, const Container& b) { return a.shell < b.shell; });
    std::vector<Container> sums;
    for (const Container& step : steps) {
      if (sums.empty() || sums.back().shell != step.shell) sums.push_back({step.shell, 0});
      sums.back().winding += step.winding;
    }
    sums.erase(std::remove_if(sums.begin(), sums.end(), [](const Container& c) { return c.winding == 0; }), sums.end());
    return sums;
  }

  [[nodiscard]] const Vec3d& corner(FaceId f, std::size_t i) const { return mesh_.points[mesh_.triangles[f.index()][i].index()]; }

  const SurfaceMesh& mesh_;
  const std::vector<Shell>& shells_;
  std::vector<std::uint32_t> shell_of_face_;
  BoxTree tree_;
};

/// From outside in: a shell behind which the winding would be negative is turned, and all that lies in it with it.
std::vector<bool> find_turned_shells(const SurfaceMesh& mesh, const std::vector<Shell>& shells) {
  const Nesting nesting(mesh, shells);
  std::vector<std::vector<Container>> containers(shells.size());
  std::vector<std::uint32_t> order;
  for (std::uint32_t s = 0; s < shells.size(); ++s) {
    if (!shells[s].is_closed) continue;
    containers[s] = nesting.containers_of(s);
    order.push_back(s);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return containers[a].size() < containers[b].size(); });

  std::vector<bool> is_turned(shells.size(), false), starts_turn(shells.size(), false);
  for (const std::uint32_t s : order) {
    int winding = 0;
    bool turns_along = false;
    for (const Container& c : containers[s]) {
      winding += is_turned[c.shell] ? -c.winding : c.winding;
      turns_along = turns_along != starts_turn[c.shell];
    }
    const int own = static_cast<int>(enclosed_volume_sign(select_faces(mesh, shells[s].faces).mesh));
    starts_turn[s] = own != 0 && winding + (turns_along ? -own : own) < 0;
    is_turned[s] = turns_along != starts_turn[s];
  }
  return is_turned;
}

}  // namespace

void orient_faces(MeshInRepair& repair) {
  std::vector<FaceId> turned, one_sided;
  std::uint64_t one_sided_surfaces = 0;
  for (const Surface& surface : SurfaceWalk(repair.mesh).find_surfaces()) {
    if (surface.is_orientable) {
      const std::vector<FaceId> minority = minority_of(surface);
      turned.insert(turned.end(), minority.begin(), minority.end());
    } else {
      one_sided.insert(one_sided.end(), surface.faces.begin(), surface.faces.end());
      ++one_sided_surfaces;
    }
  }
  for (const FaceId f : turned) turn_over(f, repair.mesh);
  add_note(repair, RepairStep::Orient, RepairOutcome::Done, turned.size(), turned);
  add_note(repair, RepairStep::Orient, RepairOutcome::NotOrientable, one_sided_surfaces, one_sided);
}

void flip_inside_out_shells(MeshInRepair& repair) {
  const std::vector<Shell> shells = find_shells(repair.mesh);
  const std::vector<bool> is_turned = find_turned_shells(repair.mesh, shells);
  std::vector<FaceId> turned;
  for (std::size_t s = 0; s < shells.size(); ++s) {
    if (is_turned[s]) turned.insert(turned.end(), shells[s].faces.begin(), shells[s].faces.end());
  }
  for (const FaceId f : turned) turn_over(f, repair.mesh);
  add_note(repair, RepairStep::FlipInsideOut, RepairOutcome::Done, turned.size(), turned);
}

}  // namespace mortise
