// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Tables of the documentation.
#include "support/document.h"

#include <fstream>

#include "support/data.h"

namespace mortise::test {
namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  for (std::size_t at = 1, next; (next = line.find('|', at)) != std::string::npos; at = next + 1) {
    const std::size_t first = line.find_first_not_of(' ', at), last = line.find_last_not_of(' ', next - 1);
    cells.push_back(line.substr(first, last + 1 - first));
  }
  return cells;
}

}  // namespace

std::vector<std::vector<std::string>> read_table(const std::string& file) {
  std::vector<std::vector<std::string>> rows;
  std::ifstream stream(repository_path(file));
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("| ", 0) == 0) rows.push_back(cells_of(line));
  }
  return rows;
}

}  // namespace mortise::test
