// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Makes the images of operands that were moved.
#include "mortise/arrange/operand_list.h"

#include <utility>

#include "mortise/base/error.h"

namespace mortise {
namespace {

bool is_identity(const AffineMap& map) { return map.linear == AffineMap{}.linear && map.offset == Vec3d{}; }

SurfaceMesh image_of(const Operand& operand, std::size_t k) {
  try {
    return transform(operand.mesh(), operand.place());
  } catch (Error& error) {
    throw std::move(error).in_operand(k);
  }
}

}  // namespace

OperandList::OperandList(std::span<const SurfaceMesh* const> meshes)
    : meshes_(meshes.begin(), meshes.end()), prepared_(meshes.size(), nullptr), places_(meshes.size()) {}

OperandList::OperandList(std::span<const Operand> operands) {
  images_.reserve(operands.size());  // those that are there must stay where they are
  for (std::size_t k = 0; k < operands.size(); ++k) {
    const Operand& operand = operands[k];
    if (is_identity(operand.place())) {
      meshes_.push_back(&operand.mesh());
    } else {
      images_.push_back(image_of(operand, k));
      meshes_.push_back(&images_.back());
    }
    prepared_.push_back(operand.prepared());
    places_.push_back(operand.place());
  }
}

}  // namespace mortise
