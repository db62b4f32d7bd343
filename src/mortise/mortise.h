// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The whole public library.
#pragma once

#include "mortise/base/error.h"
#include "mortise/base/progress.h"
#include "mortise/boolean/evaluate_boolean.h"
#include "mortise/boolean/evaluate_expression.h"
#include "mortise/boolean/implant.h"
#include "mortise/boolean/imprint.h"
#include "mortise/boolean/keep_faces.h"
#include "mortise/boolean/resolve.h"
#include "mortise/boolean/result_regions.h"
#include "mortise/io/files.h"
#include "mortise/io/formats.h"
#include "mortise/mesh/extrude_to.h"
#include "mortise/mesh/find_self_crossings.h"
#include "mortise/mesh/inspect.h"
#include "mortise/mesh/measures.h"
#include "mortise/mesh/repair.h"
#include "mortise/mesh/shapes.h"
#include "mortise/mesh/slice.h"
#include "mortise/mesh/split_parts.h"
#include "mortise/mesh/surface_mesh.h"
#include "mortise/mesh/topology.h"
#include "mortise/mesh/transform.h"
#include "mortise/mesh/validate.h"
#include "mortise/mesh/weld.h"
