// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Prepared operands by number; numbers are never used again.
#include "prepared.h"

#include <emscripten/bind.h>

#include <map>

#include "arrays.h"
#include "border.h"

namespace mortise::wasm {
namespace {

using emscripten::val;

struct Store {
  std::map<std::uint32_t, KeptOperand> operands;
  std::uint32_t last = 0;
};

Store& store() {
  static Store kept;
  return kept;
}

val prepare(const val& mesh) {
  return answer([&] {
    store().operands.emplace(store().last + 1, std::make_shared<const PreparedOperand>(mesh_in(mesh)));
    return ++store().last;
  });
}

void forget_prepared(std::uint32_t number) { store().operands.erase(number); }

}  // namespace

KeptOperand prepared_operand(std::uint32_t number) {
  const auto found = store().operands.find(number);
  if (found == store().operands.end()) throw Error(ErrorCode::InvalidArgument, "", "the prepared operand was disposed of");
  return found->second;
}

EMSCRIPTEN_BINDINGS(mortise_prepared) {
  emscripten::function("prepare", &prepare);
  emscripten::function("forgetPrepared", &forget_prepared);
}

}  // namespace mortise::wasm
