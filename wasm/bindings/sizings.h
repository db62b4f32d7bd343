// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Sizing proxies stay on this side of the border; JavaScript knows them by number.
#pragma once

#include <cstdint>
#include <memory>

#include "mortise/size/sizing_proxy.h"

namespace mortise::wasm {

/// It stays for the call, even if its listener disposes of it.
/// @throws Error{InvalidArgument} when there is none of that number
[[nodiscard]] std::shared_ptr<const SizingProxy> sizing_of(std::uint32_t number);

}  // namespace mortise::wasm
