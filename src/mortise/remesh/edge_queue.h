// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Edges to be changed, the most urgent first.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "mortise/base/bits.h"
#include "mortise/remesh/edit_mesh.h"

namespace mortise {

/// Classes of urgency a quarter of an octave wide; in each the edges come as they were pushed: no heap, and neighbours stay together.
class EdgeQueue {
 public:
  /// @param urgency  1 or more
  void push(const EditMesh& mesh, HalfEdge h, double urgency) {
    const std::size_t k = class_of(urgency);
    classes_[k].edges.push_back({h, mesh.origin(h), mesh.target(h)});
    highest_ = std::max(highest_, k);
  }

  /// The next one that still is what it was when it was pushed; no_half_edge at the end.
  HalfEdge pop(const EditMesh& mesh) {
    for (;; --highest_) {
      Class& c = classes_[highest_];
      while (c.next < c.edges.size()) {
        const QueuedEdge edge = c.edges[c.next++];
        const HalfEdge h = edge.half_edge;
        if (mesh.has(h) && mesh.origin(h) == edge.origin && mesh.target(h) == edge.target && !mesh.is_on_model_edge(h)) return h;
      }
      c = {};
      if (highest_ == 0) return no_half_edge;
    }
  }

 private:
  static constexpr std::uint32_t class_bits = 5, class_count = 256;  // classes of each octave: 2^class_bits

  struct QueuedEdge {
    HalfEdge half_edge = 0;
    VertexId origin, target;
  };
  struct Class {
    std::vector<QueuedEdge> edges;
    std::size_t next = 0;
  };

  // The exponent and the leading bits of the fraction.
  [[nodiscard]] static std::size_t class_of(double urgency) {
    const std::uint64_t bits = cast_bits<std::uint64_t>(std::max(urgency, 1.0)) - cast_bits<std::uint64_t>(1.0);
    return static_cast<std::size_t>(std::min<std::uint64_t>(bits >> (52U - class_bits), class_count - 1));
  }

  std::vector<Class> classes_ = std::vector<Class>(class_count);
  std::size_t highest_ = 0;
};

}  // namespace mortise
