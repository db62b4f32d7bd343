// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The operands of a call: meshes and prepared operands, each where it is in this call.
#pragma once

#include <concepts>
#include <span>
#include <vector>

#include "mortise/arrange/prepared_operand.h"
#include "mortise/mesh/transform.h"

namespace mortise {

/// A mesh, or a prepared one moved by a map: the mesh that transform() makes of it, bit for bit. Refers to what it is made from.
class Operand {
 public:
  Operand(const SurfaceMesh& mesh) : mesh_(&mesh) {}
  Operand(const PreparedOperand& prepared, const AffineMap& place = {}) : mesh_(&prepared.mesh()), prepared_(&prepared), place_(place) {}

  /// Where it was prepared, if it is.
  [[nodiscard]] const SurfaceMesh& mesh() const { return *mesh_; }
  /// Null for a plain mesh.
  [[nodiscard]] const PreparedOperand* prepared() const { return prepared_; }
  [[nodiscard]] const AffineMap& place() const { return place_; }

 private:
  const SurfaceMesh* mesh_;
  const PreparedOperand* prepared_ = nullptr;
  AffineMap place_;
};

/// What a call works on; made of an array of operands or of pointers to meshes. Images of moved operands live in it.
class OperandList {
 public:
  template <class Meshes>
  requires std::convertible_to<const Meshes&, std::span<const SurfaceMesh* const>> OperandList(const Meshes& meshes)
      : OperandList(std::span<const SurfaceMesh* const>(meshes)) {}
  template <class Operands>
  requires std::convertible_to<const Operands&, std::span<const Operand>> OperandList(const Operands& operands)
      : OperandList(std::span<const Operand>(operands)) {}

  explicit OperandList(std::span<const SurfaceMesh* const> meshes);
  /// @throws Error{InvalidArgument, OutOfRange} as transform, naming the operand
  explicit OperandList(std::span<const Operand> operands);
  OperandList(OperandList&&) = default;
  OperandList& operator=(OperandList&&) = default;

  [[nodiscard]] std::size_t size() const { return meshes_.size(); }
  [[nodiscard]] bool empty() const { return meshes_.empty(); }
  /// The meshes as they are in this call.
  [[nodiscard]] std::span<const SurfaceMesh* const> meshes() const { return meshes_; }
  [[nodiscard]] const SurfaceMesh& mesh(std::size_t k) const { return *meshes_[k]; }
  /// What is known of operand k; null for a plain mesh.
  [[nodiscard]] const PreparedOperand* prepared(std::size_t k) const { return prepared_[k]; }
  /// Is operand k where it was prepared?
  [[nodiscard]] bool is_in_place(std::size_t k) const { return prepared_[k] != nullptr && meshes_[k] == &prepared_[k]->mesh(); }
  /// Where operand k was moved from where it was prepared.
  [[nodiscard]] const AffineMap& place(std::size_t k) const { return places_[k]; }

 private:
  std::vector<const SurfaceMesh*> meshes_;
  std::vector<const PreparedOperand*> prepared_;
  std::vector<AffineMap> places_;
  std::vector<SurfaceMesh> images_;
};

}  // namespace mortise
