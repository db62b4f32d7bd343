// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Sizing proxies by number; numbers are never used again.
#include "sizings.h"

#include <emscripten/bind.h>

#include <map>

#include "arrays.h"
#include "border.h"
#include "mortise/size/background_view.h"
#include "size_sources.h"

namespace mortise::wasm {
namespace {

using emscripten::val;

struct Store {
  std::map<std::uint32_t, std::shared_ptr<const SizingProxy>> proxies;
  std::uint32_t last = 0;
};

Store& store() {
  static Store kept;
  return kept;
}

/// @param object  that of size_sources_in, with {size, smallest}
val make_sizing(const val& object) {
  return answer([&] {
    const SizeLimits limits{object["size"].as<double>(), object["smallest"].as<double>()};
    store().proxies.emplace(store().last + 1, std::make_shared<const SizingProxy>(size_sources_in(object), limits));
    return ++store().last;
  });
}

void forget_sizing(std::uint32_t number) { store().proxies.erase(number); }

/// One number per point.
val sizes_at(std::uint32_t number, const val& points) {
  return answer([&] { return copy_out(sizing_of(number)->sizes_at(points_in(points))); });
}

/// @param corners  six numbers: the lowest and the highest corner
val gmsh_view(std::uint32_t number, const val& corners) {
  return answer([&] {
    const std::vector<Vec3d> box = points_in(corners);
    return background_view(*sizing_of(number), {box[0], box[1]});
  });
}

}  // namespace

std::shared_ptr<const SizingProxy> sizing_of(std::uint32_t number) {
  const auto found = store().proxies.find(number);
  if (found == store().proxies.end()) throw Error(ErrorCode::InvalidArgument, "", "the sizing was disposed of");
  return found->second;
}

EMSCRIPTEN_BINDINGS(mortise_sizing) {
  emscripten::function("makeSizing", &make_sizing);
  emscripten::function("forgetSizing", &forget_sizing);
  emscripten::function("sizesAt", &sizes_at);
  emscripten::function("gmshView", &gmsh_view);
}

}  // namespace mortise::wasm
