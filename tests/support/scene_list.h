// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The scenes of tests/scenes.txt (its first lines say how it is written): operands, evaluations, printed figures.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "mortise/boolean/evaluate_boolean.h"
#include "mortise/mesh/surface_mesh.h"

namespace mortise::test {

/// One operation on operands of a scene, and what was printed of its result: as text, since its last digit says how exact it
/// is; empty where nothing was.
struct ListedEvaluation {
  std::string name;                ///< "union", "subtract-B-A"
  std::string word;                ///< the name of an operation, "combine:(a|b)&!c", "keep:10,same", "implant:drop": no spaces
  std::vector<std::size_t> order;  ///< of the operands
  std::string volume, area, genus, parts;
};

struct ListedScene {
  std::string name;
  std::size_t line;                   ///< in the file, the first is 1
  std::vector<std::string> operands;  ///< as written
  std::vector<ListedEvaluation> evaluations;
  bool has_figures = false;
  bool needs_data = false;
};

/// @throws std::invalid_argument naming the line
[[nodiscard]] std::vector<ListedScene> read_scene_list(const std::string& path);

/// The scenes of this repository: tests/scenes.txt in the current folder or above it.
[[nodiscard]] std::vector<ListedScene> listed_scenes();

/// The word of an evaluation without its options, and these.
struct OperationWord {
  std::string operation;  ///< "union", "combine:(a|b)&!c"
  BooleanOptions options;
};

/// @throws std::invalid_argument naming an option that is none
[[nodiscard]] OperationWord operation_word(const std::string& word);

/// What the word of an evaluation says, with its options, done with these operands.
[[nodiscard]] BooleanResult evaluate_word(const std::string& word, std::span<const SurfaceMesh* const> operands);

/// The words of a scene without evaluations of its own.
[[nodiscard]] std::vector<std::string> default_words();

/// An operand as written: a generated shape or a file of the data, moved.
[[nodiscard]] SurfaceMesh load_operand(const std::string& text);

}  // namespace mortise::test
