// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Reads lists of scenes and makes their operands.
#include "support/scene_list.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "mortise/boolean/evaluate_boolean.h"
#include "mortise/boolean/evaluate_expression.h"
#include "mortise/boolean/implant.h"
#include "mortise/boolean/imprint.h"
#include "mortise/boolean/keep_faces.h"
#include "mortise/boolean/resolve.h"
#include "mortise/mesh/shape_by_name.h"
#include "support/data.h"

namespace mortise::test {
namespace {

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(trimmed(part));
  return parts;
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::vector<std::size_t> all_of(std::size_t count) {
  std::vector<std::size_t> order(count);
  for (std::size_t i = 0; i < count; ++i) order[i] = i;
  return order;
}

/// @param text  "subtract B A"
ListedEvaluation evaluation_of(const std::string& text, std::size_t operand_count) {
  const std::vector<std::string> words = words_of(text);
  ListedEvaluation evaluation{words.at(0), words[0], {}, "", "", "", ""};
  for (std::size_t i = 1; i < words.size(); ++i) {
    const auto operand = static_cast<std::size_t>(words[i].at(0) - 'A');
    if (words[i].size() != 1 || operand >= operand_count) throw std::invalid_argument("no operand " + words[i]);
    evaluation.order.push_back(operand);
    evaluation.name += "-" + words[i];
  }
  if (evaluation.order.empty()) evaluation.order = all_of(operand_count);
  return evaluation;
}

/// @param text  "subtract B A = 6.41, parts 2", or without figures
ListedEvaluation figures_of(const std::string& text, std::size_t operand_count) {
  const std::size_t equals = text.find(" = ");
  if (equals == std::string::npos) return evaluation_of(text, operand_count);
  ListedEvaluation evaluation = evaluation_of(text.substr(0, equals), operand_count);
  const std::vector<std::string> figures = split(text.substr(equals + 3), ',');
  evaluation.volume = figures.at(0);
  for (std::size_t i = 1; i < figures.size(); ++i) {
    const std::vector<std::string> words = words_of(figures[i]);
    std::string* const kept = words.at(0) == "area" ? &evaluation.area : words[0] == "genus" ? &evaluation.genus : &evaluation.parts;
    if (kept == &evaluation.parts && words[0] != "parts") throw std::invalid_argument("no figure is called " + words[0]);
    *kept = words.at(1);
  }
  return evaluation;
}

bool is_made(const std::string& operand) { return operand.starts_with("make "); }

/// @param text  "name : operand | operand"
ListedScene scene_of(const std::string& text, std::size_t line) {
  const std::size_t colon = text.find(" : ");
  if (colon == std::string::npos) throw std::invalid_argument("not a scene");
  ListedScene scene{text.substr(0, colon), line, split(text.substr(colon + 3), '|'), {}};
  for (const std::string& operand : scene.operands) scene.needs_data = scene.needs_data || !is_made(operand);
  return scene;
}

void add_line(std::vector<ListedScene>& scenes, const std::string& text, std::size_t line) {
  if (text.empty() || text[0] == '#') return;
  if (text[0] != ' ') {
    scenes.push_back(scene_of(text, line));
    return;
  }
  scenes.back().evaluations.push_back(figures_of(trimmed(text), scenes.back().operands.size()));
  scenes.back().has_figures = scenes.back().has_figures || !scenes.back().evaluations.back().volume.empty();
}

void complete(ListedScene& scene) {
  if (!scene.evaluations.empty()) return;
  for (const std::string& word : default_words()) scene.evaluations.push_back(evaluation_of(word, scene.operands.size()));
}

std::vector<double> numbers_of(const std::vector<std::string>& words, std::size_t from) {
  std::vector<double> numbers;
  for (std::size_t i = from; i < words.size(); ++i) numbers.push_back(std::strtod(words[i].c_str(), nullptr));
  return numbers;
}

/// @param text  "@tolerance=1e-7@simplify=cut", or nothing
BooleanOptions options_of(const std::string& text) {
  BooleanOptions options;
  if (text.empty()) return options;
  for (const std::string& setting : split(text.substr(1), '@')) {
    const std::size_t equals = std::min(setting.find('='), setting.size() - 1);
    const std::string name = setting.substr(0, equals), value = setting.substr(equals + 1);
    if (name == "tolerance")
      options.tolerance = std::strtod(value.c_str(), nullptr);
    else if (setting == "coordinates=float32")
      options.coordinates = Coordinates::Float32;
    else if (name == "simplify" && (value == "cut" || value == "coplanar"))
      options.simplify = value == "cut" ? Simplify::Cut : Simplify::Coplanar;
    else
      throw std::invalid_argument("no option is called " + setting);
  }
  return options;
}

}  // namespace

std::vector<ListedScene> read_scene_list(const std::string& path) {
  std::ifstream stream(path);
  if (!stream) throw std::invalid_argument("cannot read " + path);
  std::vector<ListedScene> scenes;
  std::size_t number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    try {
      add_line(scenes, line, number);
    } catch (const std::exception& error) {
      throw std::invalid_argument(path + ":" + std::to_string(number) + ": " + error.what());
    }
  }
  for (ListedScene& scene : scenes) complete(scene);
  return scenes;
}

std::vector<ListedScene> listed_scenes() { return read_scene_list(repository_path("tests/scenes.txt")); }

OperationWord operation_word(const std::string& word) {
  const std::size_t at = std::min(word.find('@'), word.size());
  return {word.substr(0, at), options_of(word.substr(at))};
}

BooleanResult evaluate_word(const std::string& whole_word, std::span<const SurfaceMesh* const> operands) {
  const auto [word, options] = operation_word(whole_word);
  if (word == "imprint") return imprint(operands, options).whole;
  if (word == "implant") return implant(operands, ImplantContact::Keep, options);
  if (word == "resolve") return resolve(*operands.front(), options);
  const std::size_t colon = word.find(':');
  if (colon == std::string::npos) return evaluate_boolean(operation_from_name(word), operands, options);
  const std::string kind = word.substr(0, colon), text = word.substr(colon + 1);
  if (kind == "combine") return evaluate_expression(text, operands, options);
  if (kind == "keep") return keep_faces(keep_mask(split(text, ',')), operands, options);
  if (kind == "implant" && text == "drop") return implant(operands, ImplantContact::Drop, options);
  throw std::invalid_argument("no operation is called " + kind);
}

std::vector<std::string> default_words() { return {"union", "intersect", "subtract", "symmetric_difference", "partition"}; }

SurfaceMesh load_operand(const std::string& text) {
  const std::vector<std::string> halves = split(text, ';');
  const std::string moves = halves.size() > 1 ? halves[1] : "";
  const std::vector<std::string> words = words_of(halves.at(0));
  if (!is_made(text)) return read_data(words.at(0), moves);
  return moved_by(make_shape(words.at(1), numbers_of(words, 2)), moves);
}

}  // namespace mortise::test
