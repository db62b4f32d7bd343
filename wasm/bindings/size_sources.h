// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Size sources as JavaScript hands them in.
#pragma once

#include <emscripten/val.h>

#include <vector>

#include "mortise/size/size_source.h"

namespace mortise::wasm {

/// @param object  {sources, models}: models are {mesh, settings, attributes}, sources by their `kind`
///   plain {corners, sizes}, graph {points, edges, size?}, entity {entity: [dimension, id], size}, edgeCount {count, smallest},
///   curvature {chordError?, perTurn?, smallest, largest}, vertexSizes {mesh, sizes}, attributes {}
/// with growth and radius, and the number of their model where they have one
/// @throws Error{InvalidArgument} naming "sources[3]"
[[nodiscard]] std::vector<SizeSource> size_sources_in(const emscripten::val& object);

/// Segments, or points, of one size each as a Float64Array: both ends, size, growth and radius of one after the other.
[[nodiscard]] emscripten::val segment_sources_out(const std::vector<SizeSource>& sources);
[[nodiscard]] std::vector<SizeSource> segment_sources_in(const emscripten::val& array);

}  // namespace mortise::wasm
