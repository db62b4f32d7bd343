// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Ids that do not mix, and the arrays they index.
#include "mortise/base/ids.h"

#include <type_traits>

#include "support/catch.h"

using namespace mortise;

TEST_CASE("an id is invalid until it is given a number, and is larger than all others then") {
  CHECK_FALSE(VertexId().is_valid());
  CHECK(VertexId(0).is_valid());
  CHECK(VertexId(0xfffffffeU).is_valid());
  CHECK(VertexId(0xfffffffeU) < VertexId());
  CHECK(VertexId(1) < VertexId(2));
  CHECK(VertexId(7).index() == 7);
  CHECK(VertexId(7) == VertexId(7));
}

TEST_CASE("ids of different things, and plain numbers, do not convert") {
  CHECK_FALSE(std::is_convertible_v<VertexId, FaceId>);
  CHECK_FALSE(std::is_convertible_v<std::size_t, VertexId>);
  CHECK_FALSE(std::is_convertible_v<VertexId, std::size_t>);
  CHECK_FALSE(std::is_constructible_v<VertexId, FaceId>);
  CHECK(sizeof(VertexId) == 4);
}

TEST_CASE("an array gives the id of what is pushed and of what comes next") {
  IdVector<FaceId, int> values;
  CHECK(values.empty());
  CHECK(values.next_id() == FaceId(0));
  CHECK(values.push_back(5) == FaceId(0));
  CHECK(values.push_back(6) == FaceId(1));
  CHECK(values.next_id() == FaceId(2));
  values[FaceId(0)] = 9;
  CHECK(values.values() == std::vector<int>{9, 6});
  values.resize(4, 3);
  CHECK(values.values() == std::vector<int>{9, 6, 3, 3});
  CHECK(IdVector<FaceId, int>(2, 8).values() == std::vector<int>{8, 8});
}

TEST_CASE("an array of bools hands out references that write") {
  IdVector<FaceId, bool> marks(3, false);
  marks[FaceId(1)] = true;
  CHECK((!marks[FaceId(0)] && marks[FaceId(1)] && !marks[FaceId(2)]));
}
