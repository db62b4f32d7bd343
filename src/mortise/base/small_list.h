// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A list that needs no memory of its own as long as it is short.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace mortise {

template <class T, std::size_t Few>
class SmallList {
 public:
  void push_back(const T& item) {
    if (size_ == Few) many_.assign(few_.begin(), few_.end());
    if (size_ < Few)
      few_[size_] = item;
    else
      many_.push_back(item);
    ++size_;
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const T* begin() const { return size_ <= Few ? few_.data() : many_.data(); }
  [[nodiscard]] const T* end() const { return begin() + size_; }
  [[nodiscard]] const T& operator[](std::size_t k) const { return begin()[k]; }

 private:
  std::array<T, Few> few_;
  std::vector<T> many_;  // all of them, when they are more
  std::size_t size_ = 0;
};

}  // namespace mortise
