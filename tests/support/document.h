// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Tables of the documentation, for tests to compare with what happens.
#pragma once

#include <string>
#include <vector>

namespace mortise::test {

/// The lines of the tables in a Markdown file of this repository as cells, the head first, the line below the head left out.
[[nodiscard]] std::vector<std::vector<std::string>> read_table(const std::string& file);

}  // namespace mortise::test
