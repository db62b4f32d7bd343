// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Errors as JavaScript objects.
#include "border.h"

#include <string>
#include <string_view>

#include "arrays.h"

namespace mortise::wasm {

emscripten::val error_out(const Error& error) {
  emscripten::val details = emscripten::val::object();
  if (!error.stage.empty()) details.set("stage", error.stage);
  if (error.operand >= 0) details.set("operand", error.operand);
  if (error.id_kind != IdKind::None) {
    details.set("kind", std::string(id_kind_name(error.id_kind)));
    details.set("ids", emscripten::val::global("Array").call<emscripten::val>("from", copy_out(error.ids)));
  }
  emscripten::val object = emscripten::val::object();
  object.set("code", std::string(error_code_name(error.code)));
  object.set("message", error.message);
  object.set("details", details);
  return object;
}

ProgressCallback progress_in(const emscripten::val& listener) {
  if (listener.isUndefined()) return {};
  return [listener](std::string_view stage, double fraction) { return listener(std::string(stage), fraction).as<bool>(); };
}

}  // namespace mortise::wasm
