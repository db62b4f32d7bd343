// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// One progress callback for every long call; its answer is the way to cancel.
#pragma once

#include <functional>
#include <string_view>

#include "mortise/base/error.h"

namespace mortise {

/// Called with a stage name and the fraction of the whole call done, in [0, 1]. Returns false to cancel.
using ProgressCallback = std::function<bool(std::string_view stage, double fraction)>;

/// Reports progress; an empty callback is never called.
/// @throws Error{Cancelled} when the callback answers false
inline void report_progress(const ProgressCallback& progress, std::string_view stage, double fraction) {
  if (progress && !progress(stage, fraction)) throw Error(ErrorCode::Cancelled, stage, "cancelled by the caller");
}

}  // namespace mortise
