// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A list of items for every owner, all in one array.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace mortise {

/// Owner k has items[begin[k]] .. items[begin[k + 1]].
template <class Owner, class Item>
struct Lists {
  std::vector<std::uint32_t> begin{0};
  std::vector<Item> items;

  [[nodiscard]] std::size_t size() const { return begin.size() - 1; }
  [[nodiscard]] std::span<const Item> of(Owner owner) const {
    return std::span<const Item>(items).subspan(begin[owner.index()], begin[owner.index() + 1] - begin[owner.index()]);
  }
  /// Ends the list of the next owner: items appended since the last one are its.
  Owner close() {
    begin.push_back(static_cast<std::uint32_t>(items.size()));
    return Owner(begin.size() - 2);
  }
};

/// Lists made from pairs in any order; each list keeps the order of its pairs.
///
/// @param owner_of, item_of  pair -> owner, below owner_count, and item
/// O(pairs + owner_count).
template <class Owner, class Item, class Pair, class OwnerOf, class ItemOf>
[[nodiscard]] Lists<Owner, Item> lists_of(const std::vector<Pair>& pairs, std::size_t owner_count, OwnerOf owner_of, ItemOf item_of) {
  Lists<Owner, Item> lists;
  lists.begin.assign(owner_count + 1, 0);
  for (const Pair& p : pairs) ++lists.begin[owner_of(p).index() + 1];
  for (std::size_t k = 0; k < owner_count; ++k) lists.begin[k + 1] += lists.begin[k];
  lists.items.resize(pairs.size());
  std::vector<std::uint32_t> next(lists.begin.begin(), lists.begin.end() - 1);
  for (const Pair& p : pairs) lists.items[next[owner_of(p).index()]++] = item_of(p);
  return lists;
}

}  // namespace mortise
