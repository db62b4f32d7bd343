// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// What is compared of two answers, and what each costs.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "mortise/mesh/surface_mesh.h"

namespace mortise::peers {

/// Union, intersection, A - B, B - A: the order of CGAL's Boolean_operation_type.
inline constexpr std::array<const char*, 4> question_names{"union", "intersection", "A - B", "B - A"};
enum Question : std::size_t { United, Common, ALessB, BLessA };

/// Measures of a result. Pieces that touch in a vertex or an edge count as apart.
struct Shape {
  double volume = 0;
  double area = 0;
  double perimeters = 0;    ///< sum over the triangles: what area can change by, per distance the vertices are off
  std::int64_t euler = 0;   ///< vertices - edges + triangles, once pinches are split
  std::int64_t shells = 0;  ///< connected through edges, once pinches are split
  std::uint64_t boundary_edges = 0;
  bool is_uncertified = false;  ///< the report says that doubles cannot hold this result
  std::string fault;            ///< why its doubles are no valid solid, where that was looked for; empty: nothing found
};

/// What to find out of every result. Faults take longer than the booleans.
enum class Depth : std::uint8_t { Figures, FiguresAndFaults };

struct Cost {
  double milliseconds = 0;
  double megabytes = 0;  ///< most that was resident on top of what was before; 0 where the system does not tell
};

struct Answers {
  std::array<std::optional<Shape>, 4> shapes;  ///< by question; nothing: refused
  std::string refusal;                         ///< why the whole pair was refused; empty: it was not
  double displacement = 0;                     ///< of any vertex of any result from its exact place, at most
  Cost four_cost;                              ///< of all four
  Cost union_cost;                             ///< of the union alone
};

}  // namespace mortise::peers
