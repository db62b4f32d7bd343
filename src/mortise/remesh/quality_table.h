// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// A quality report as a table to read.
#pragma once

#include <string>

#include "mortise/remesh/deviation.h"
#include "mortise/remesh/quality_report.h"

namespace mortise {

/// Lines that end with a line break, of columns in a font of one width; numbers are rounded for reading.
[[nodiscard]] std::string quality_table(const QualityReport& report);
[[nodiscard]] std::string deviation_table(const Deviation& deviation);

}  // namespace mortise
