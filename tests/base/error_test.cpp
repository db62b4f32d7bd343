// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Errors carry a code, a stage, places and an operand; progress turns a refusal into one.
#include "mortise/base/error.h"

#include <set>
#include <stdexcept>

#include "mortise/base/progress.h"
#include "support/catch.h"
#include "support/mesh_checks.h"

using namespace mortise;
using mortise::test::error_of;

TEST_CASE("every code has a name of its own, in capitals") {
  std::set<std::string_view> names;
  for (int code = 0; code <= static_cast<int>(ErrorCode::InternalError); ++code) {
    const std::string_view name = error_code_name(static_cast<ErrorCode>(code));
    CHECK(names.insert(name).second);
    CHECK(name.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ_") == std::string_view::npos);
  }
  CHECK(error_code_name(ErrorCode::NotClosed) == "NOT_CLOSED");
  CHECK(error_code_name(ErrorCode::ResultTooLarge) == "RESULT_TOO_LARGE");
}

TEST_CASE("every kind of id has a name of its own") {
  std::set<std::string_view> names;
  for (const IdKind kind : {IdKind::None, IdKind::Vertices, IdKind::Faces, IdKind::VertexPairs, IdKind::Line, IdKind::Byte}) {
    CHECK(names.insert(id_kind_name(kind)).second);
  }
  CHECK(id_kind_name(IdKind::None).empty());
  CHECK(id_kind_name(IdKind::VertexPairs) == "vertexPairs");
}

TEST_CASE("an error says what, where and in which operand") {
  const Error error = Error(ErrorCode::NotClosed, "categorize", "an edge is open").with_ids(IdKind::VertexPairs, {3, 4}).in_operand(2);
  CHECK(error.code == ErrorCode::NotClosed);
  CHECK(error.stage == "categorize");
  CHECK(std::string(error.what()) == "an edge is open");
  CHECK(error.id_kind == IdKind::VertexPairs);
  CHECK(error.ids == std::vector<std::uint32_t>{3, 4});
  CHECK(error.operand == 2);
  const Error plain(ErrorCode::Cancelled, "x", "y");
  CHECK((plain.id_kind == IdKind::None && plain.ids.empty() && plain.operand == -1));
}

TEST_CASE("an error keeps the first thousand places") {
  std::vector<std::uint32_t> places(1003);
  for (std::uint32_t i = 0; i < places.size(); ++i) places[i] = 5 * i;
  const Error error = Error(ErrorCode::BadIndex, "validate", "").with_ids(IdKind::Faces, places);
  REQUIRE(error.ids.size() == 1000);
  CHECK((error.ids.front() == 0 && error.ids.back() == 5 * 999));
  places.resize(1000);
  CHECK(Error(ErrorCode::BadIndex, "validate", "").with_ids(IdKind::Faces, places).ids == places);
}

TEST_CASE("an error is a standard exception") { CHECK_THROWS_AS((throw Error(ErrorCode::OutOfRange, "round", "too far")), std::exception); }

TEST_CASE("a check that does not hold names the belief, the entity and the file without its folder") {
  const auto error = error_of([] { MORTISE_CHECK(1 + 1 == 3, "face 7"); });
  REQUIRE(error);
  CHECK(error->code == ErrorCode::InternalError);
  CHECK(error->stage == "error_test.cpp");
  CHECK(error->message.find("1 + 1 == 3") != std::string::npos);
  CHECK(error->message.find("face 7") != std::string::npos);
  CHECK(error->message.find('/') == std::string::npos);
  CHECK_FALSE(error_of([] { MORTISE_CHECK(1 + 1 == 2, "nothing"); }));
}

TEST_CASE("progress is reported as it is, and a refusal cancels in the stage that asked") {
  std::string seen;
  double last = -1;
  const ProgressCallback accept = [&](std::string_view stage, double fraction) {
    seen = stage;
    last = fraction;
    return true;
  };
  report_progress(accept, "merge", 0.5);
  CHECK((seen == "merge" && last == 0.5));
  CHECK_FALSE(error_of([] { report_progress({}, "merge", 0.5); }));
  const auto error = error_of([] { report_progress([](std::string_view, double) { return false; }, "select", 0.75); });
  REQUIRE(error);
  CHECK(error->code == ErrorCode::Cancelled);
  CHECK(error->stage == "select");
}

TEST_CASE("what a callback throws itself passes through") {
  const ProgressCallback thrower = [](std::string_view, double) -> bool { throw std::runtime_error("from outside"); };
  CHECK_THROWS_AS(report_progress(thrower, "select", 0), std::runtime_error);
}
