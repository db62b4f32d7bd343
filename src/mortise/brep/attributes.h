// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Named data on model entities, carried through operations by policy (paper 7.2, Fig. 18).
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "mortise/brep/lineage.h"

namespace mortise {

enum class AttributeKind : std::uint8_t { Material, BoundaryCondition, Load, Size, User };

/// When an entity became several.
enum class OnSplit : std::uint8_t {
  Copy,     ///< all of them get it
  Largest,  ///< the one that has most of the entity; of equals the lowest
  Drop,     ///< none
};

/// When attributes of one name and different values come together on an entity.
enum class OnMerge : std::uint8_t {
  Union,   ///< it has all of them
  First,   ///< that of the lowest operand and entity
  Second,  ///< that of the highest
  Error,   ///< Error{InvalidArgument} naming attribute and entity
  Drop,    ///< none
};

/// When nothing of an entity is left.
enum class OnDelete : std::uint8_t {
  Drop,
  ToNeighbours,  ///< what is left of entities that share a boundary entity with it gets it
};

struct AttributePolicy {
  OnSplit on_split = OnSplit::Copy;
  OnMerge on_merge = OnMerge::Union;
  OnDelete on_delete = OnDelete::Drop;
  std::string piece_name;  ///< of what a copy on a part of a split entity is called: "{name} {piece}", pieces from 1; empty: its name
};

struct Attribute {
  std::string name;
  AttributeKind kind = AttributeKind::User;
  std::string value;                 ///< JSON, carried as it is; equal texts are equal values
  std::vector<ModelEntity> targets;  ///< ascending
  AttributePolicy policy;
};

/// A model of an operand and what is on it.
struct OperandAttributes {
  std::span<const Attribute> attributes;
  const Brep* brep = nullptr;
};

/// The attributes of the model of a result, by name, kind and value; targets of equal ones together.
///
/// @param operands  by number; leave out the attributes of those that are to give none
/// @throws Error{InvalidArgument} when a target is not there, or a policy says so
/// O(n log n) in links and targets.
[[nodiscard]] std::vector<Attribute> transfer_attributes(const Lineage& lineage, std::span<const OperandAttributes> operands);

/// Groups of facets for FeatureRules: facets whose sources lie on faces with the same attributes share one, so that no face of the
/// result has an attribute on a part of it only.
/// @param operands  models and attributes, by number
[[nodiscard]] std::vector<std::uint32_t> group_by_attributes(const Provenance& provenance, std::span<const Classification* const> models,
                                                             std::span<const OperandAttributes> operands);

/// What an attribute covers, by dimension.
struct AttributeMeasure {
  std::string name;
  std::size_t vertices = 0;
  double length = 0, area = 0, volume = 0;
};

/// One row per name, ascending; an entity counts once for each name.
[[nodiscard]] std::vector<AttributeMeasure> measure_attributes(const ModelView& view, std::span<const Attribute> attributes);

using EntityName = std::function<std::string(const OperandEntity&)>;

/// "interface(hull.deck, gun.base)" on every face that comes from faces of several operands, by their names, and on every edge where
/// faces of different operands meet.
/// @param name_of  the name of a face of an operand, "hull.deck"
[[nodiscard]] std::vector<Attribute> interface_attributes(const ModelView& result, const Lineage& lineage, const EntityName& name_of);

}  // namespace mortise
