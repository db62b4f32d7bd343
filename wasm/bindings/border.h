// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// No C++ exception crosses into JavaScript: every bound function answers {value} or {error}.
#pragma once

#include <emscripten/val.h>

#include <exception>
#include <new>
#include <stdexcept>
#include <utility>

#include "mortise/base/error.h"
#include "mortise/base/progress.h"

namespace mortise::wasm {

/// {code, stage, message, details: {operand?, kind?, ids?}}.
[[nodiscard]] emscripten::val error_out(const Error& error);

/// @param listener  (stage, fraction) -> go on? or undefined
[[nodiscard]] ProgressCallback progress_in(const emscripten::val& listener);

/// {value: work()} or {error}. Exceptions of JavaScript pass through.
template <class Work>
[[nodiscard]] emscripten::val answer(Work work) {
  emscripten::val object = emscripten::val::object();
  try {
    object.set("value", work());
  } catch (const Error& error) {
    object.set("error", error_out(error));
  } catch (const std::bad_alloc&) {
    object.set("error", error_out(Error(ErrorCode::OutOfMemory, "", "the memory of the WebAssembly core (at most 4 GB) is not enough")));
  } catch (const std::length_error&) {
    object.set("error", error_out(Error(ErrorCode::OutOfMemory, "", "an array would be larger than 32 bits can address")));
  } catch (const std::exception& error) {
    object.set("error", error_out(Error(ErrorCode::InternalError, "", error.what())));
  }
  return object;
}

/// work(); its errors name the operand.
template <class Work>
[[nodiscard]] auto in_operand(std::size_t index, Work work) {
  try {
    return work();
  } catch (Error& error) {
    throw std::move(error).in_operand(index);
  }
}

}  // namespace mortise::wasm
