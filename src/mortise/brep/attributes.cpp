// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Every attribute lands on entities of the result one by one; then what landed together is merged.
#include "mortise/brep/attributes.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "mortise/base/error.h"

namespace mortise {
namespace {

// An attribute of an operand on an entity of the result.
struct Landing {
  std::string name;
  const Attribute* attribute;
  OperandEntity source;
  ModelEntity target;
};

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) text.replace(at, what.size(), by);
  return text;
}

std::string name_of_piece(const Attribute& attribute, std::size_t piece) {
  if (attribute.policy.piece_name.empty()) return attribute.name;
  return replaced(replaced(attribute.policy.piece_name, "{name}", attribute.name), "{piece}", std::to_string(piece));
}

class AttributeTransfer {
 public:
  AttributeTransfer(const Lineage& lineage, std::span<const OperandAttributes> operands) : lineage_(lineage), operands_(operands) {}

  [[nodiscard]] std::vector<Attribute> transfer() {
    for (std::uint32_t k = 0; k < operands_.size(); ++k) {
      for (const Attribute& a : operands_[k].attributes) {
        for (const ModelEntity& target : a.targets) land(a, {k, target});
      }
    }
    return gathered(merged());
  }

 private:
  void land(const Attribute& a, const OperandEntity& source) {
    if (source.entity.id >= entity_count(*operands_[source.operand].brep, source.entity.dimension))
      throw Error(ErrorCode::InvalidArgument, "transfer_attributes",
                  "attribute '" + a.name + "' is on " + entity_name(source.entity) + ", which is not there")
          .in_operand(source.operand);
    const auto results = lineage_.results_of(source);
    if (results.empty()) {
      if (a.policy.on_delete == OnDelete::ToNeighbours) land_on_neighbours(a, source);
    } else if (results.size() == 1) {
      landings_.push_back({a.name, &a, source, results[0].result});
    } else {
      land_on_pieces(a, source, results);
    }
  }

  void land_on_pieces(const Attribute& a, const OperandEntity& source, std::span<const LineageLink> pieces) {
    if (a.policy.on_split == OnSplit::Drop) return;
    if (a.policy.on_split == OnSplit::Largest) {
      const auto largest =
          std::max_element(pieces.begin(), pieces.end(), [](const LineageLink& l, const LineageLink& m) { return l.measure < m.measure; });
      landings_.push_back({a.name, &a, source, largest->result});
      return;
    }
    for (std::size_t i = 0; i < pieces.size(); ++i) landings_.push_back({name_of_piece(a, i + 1), &a, source, pieces[i].result});
  }

  void land_on_neighbours(const Attribute& a, const OperandEntity& source) {
    const Brep& brep = *operands_[source.operand].brep;
    std::set<ModelEntity> neighbours;
    for (const ModelEntity& below : entities_below(brep, source.entity)) {
      for (const ModelEntity& beside : entities_above(brep, below)) neighbours.insert(beside);
    }
    if (source.entity.dimension == EntityDimension::Vertex) {
      for (const ModelEntity& edge : entities_above(brep, source.entity)) {
        for (const ModelEntity& end : entities_below(brep, edge)) neighbours.insert(end);
      }
    }
    for (const ModelEntity& beside : neighbours) {
      for (const LineageLink& l : lineage_.results_of({source.operand, beside})) landings_.push_back({a.name, &a, source, l.result});
    }
  }

  // Landings of one name on one entity, by source; those that stay.
  [[nodiscard]] std::vector<Landing> merged() {
    std::stable_sort(landings_.begin(), landings_.end(), [](const Landing& l, const Landing& m) {
      return std::tie(l.name, l.target, l.source) < std::tie(m.name, m.target, m.source);
    });
    std::vector<Landing> stay;
    for (std::size_t i = 0; i < landings_.size();) {
      std::size_t end = i;
      while (end < landings_.size() && landings_[end].name == landings_[i].name && landings_[end].target == landings_[i].target) ++end;
      merge(std::span(landings_).subspan(i, end - i), stay);
      i = end;
    }
    return stay;
  }

  static void merge(std::span<const Landing> together, std::vector<Landing>& stay) {
    const auto has_value_of_first = [&](const Landing& l) {
      return l.attribute->value == together[0].attribute->value && l.attribute->kind == together[0].attribute->kind;
    };
    if (std::all_of(together.begin(), together.end(), has_value_of_first)) return stay.push_back(together[0]);
    switch (together[0].attribute->policy.on_merge) {
      case OnMerge::Union:
        stay.insert(stay.end(), together.begin(), together.end());
        break;
      case OnMerge::First:
        stay.push_back(together.front());
        break;
      case OnMerge::Second:
        stay.push_back(together.back());
        break;
      case OnMerge::Error:
        throw Error(ErrorCode::InvalidArgument, "transfer_attributes",
                    "attribute '" + together[0].name + "' has several values on " + entity_name(together[0].target));
      case OnMerge::Drop:
        break;
    }
  }

  [[nodiscard]] static std::vector<Attribute> gathered(const std::vector<Landing>& landings) {
    using Key = std::tuple<std::string, AttributeKind, std::string>;
    std::map<Key, Attribute> attributes;
    for (const Landing& l : landings) {
      const Attribute& a = *l.attribute;
      const auto [entry, is_new] = attributes.try_emplace(Key{l.name, a.kind, a.value}, Attribute{l.name, a.kind, a.value, {}, a.policy});
      entry->second.targets.push_back(l.target);
    }
    std::vector<Attribute> result;
    for (auto& [key, attribute] : attributes) {
      std::vector<ModelEntity>& targets = attribute.targets;
      std::sort(targets.begin(), targets.end());
      targets.erase(std::unique(targets.begin(), targets.end()), targets.end());
      result.push_back(std::move(attribute));
    }
    return result;
  }

  const Lineage& lineage_;
  std::span<const OperandAttributes> operands_;
  std::vector<Landing> landings_;
};

}  // namespace

std::vector<Attribute> transfer_attributes(const Lineage& lineage, std::span<const OperandAttributes> operands) {
  return AttributeTransfer(lineage, operands).transfer();
}

std::vector<std::uint32_t> group_by_attributes(const Provenance& provenance, std::span<const Classification* const> models,
                                               std::span<const OperandAttributes> operands) {
  using Set = std::vector<std::pair<std::uint32_t, std::size_t>>;  // operand and attribute, ascending
  std::vector<std::map<std::uint32_t, Set>> on_face(operands.size());
  for (std::uint32_t k = 0; k < operands.size(); ++k) {
    for (std::size_t i = 0; i < operands[k].attributes.size(); ++i) {
      for (const ModelEntity& e : operands[k].attributes[i].targets) {
        if (e.dimension == EntityDimension::Face) on_face[k][e.id].emplace_back(k, i);
      }
    }
  }
  std::map<Set, std::uint32_t> numbers;
  std::vector<std::uint32_t> groups;
  Set set;
  for (std::size_t t = 0; t < provenance.source_face.size(); ++t) {
    set.clear();
    for_each_source(provenance, FaceId(t), [&](const FacetOrigin& s) {
      const auto found = on_face[s.operand].find(models[s.operand]->face_of_triangle[s.face].value);
      if (found != on_face[s.operand].end()) set.insert(set.end(), found->second.begin(), found->second.end());
    });
    std::sort(set.begin(), set.end());
    set.erase(std::unique(set.begin(), set.end()), set.end());
    groups.push_back(numbers.try_emplace(set, static_cast<std::uint32_t>(numbers.size())).first->second);
  }
  return groups;
}

std::vector<AttributeMeasure> measure_attributes(const ModelView& view, std::span<const Attribute> attributes) {
  std::map<std::string, std::set<ModelEntity>> covered;
  for (const Attribute& a : attributes) covered[a.name].insert(a.targets.begin(), a.targets.end());
  std::vector<AttributeMeasure> measures;
  for (const auto& [name, entities] : covered) {
    AttributeMeasure sum;
    sum.name = name;
    for (const ModelEntity& e : entities) {
      if (e.dimension == EntityDimension::Vertex) ++sum.vertices;
      if (e.dimension == EntityDimension::Edge) sum.length += measure(view, e);
      if (e.dimension == EntityDimension::Face) sum.area += measure(view, e);
      if (e.dimension == EntityDimension::Region) sum.volume += measure(view, e);
    }
    measures.push_back(std::move(sum));
  }
  return measures;
}

std::vector<Attribute> interface_attributes(const ModelView& result, const Lineage& lineage, const EntityName& name_of) {
  std::map<std::string, std::vector<ModelEntity>> targets;
  const auto add = [&](const std::set<OperandEntity>& faces, const ModelEntity& target) {
    if (faces.empty() || faces.begin()->operand == faces.rbegin()->operand) return;
    std::vector<std::string> names;
    for (const OperandEntity& face : faces) names.push_back(name_of(face));
    std::string list;
    for (auto name = names.begin(); name != names.end(); ++name) {
      if (std::find(names.begin(), name, *name) == name) list += (list.empty() ? "" : ", ") + *name;
    }
    targets["interface(" + list + ")"].push_back(target);
  };
  const auto sources = [&](const ModelEntity& face, std::set<OperandEntity>& found) {
    for (const LineageLink& l : lineage.sources_of(face)) found.insert(l.source);
  };
  for (std::uint32_t e = 0; e < result.model.brep.edges.size(); ++e) {
    std::set<OperandEntity> faces;
    for (const ModelEntity& face : entities_above(result.model.brep, {EntityDimension::Edge, e})) sources(face, faces);
    add(faces, {EntityDimension::Edge, e});
  }
  for (std::uint32_t f = 0; f < result.model.brep.faces.size(); ++f) {
    std::set<OperandEntity> faces;
    sources({EntityDimension::Face, f}, faces);
    add(faces, {EntityDimension::Face, f});
  }
  std::vector<Attribute> attributes;
  for (auto& [name, entities] : targets) attributes.push_back({name, AttributeKind::User, "null", std::move(entities), {}});
  return attributes;
}

}  // namespace mortise
