// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
#include "mortise/remesh/quality_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "mortise/base/numbers.h"

namespace mortise {
namespace {

constexpr std::size_t name_width = 36, column_width = 12;
constexpr double most = 1e15;

std::string count_text(std::size_t count) { return std::to_string(count); }

// With so many decimals; what would come out as zero and is not, as less than the least.
std::string rounded(double value, std::size_t decimals) {
  double unit = 1;
  for (std::size_t i = 0; i < decimals; ++i) unit *= 10;
  const double scaled = std::floor(value * unit + 0.5);
  if (!(scaled < most)) return format_double(value);
  if (scaled == 0 && value > 0) return "< " + format_double(1 / unit);
  std::string digits = std::to_string(static_cast<std::uint64_t>(scaled));
  if (digits.size() <= decimals) digits.insert(0, decimals + 1 - digits.size(), '0');
  return decimals == 0 ? digits : digits.insert(digits.size() - decimals, ".");
}

std::string percent(double part) { return rounded(100 * part, 2) + " %"; }

void add_row(std::string& text, std::string_view name, std::string_view one, std::string_view other) {
  const auto add = [&](std::string_view column) {
    text.append(column_width - std::min(column.size(), column_width - 1), ' ');
    text += column;
  };
  text += name;
  text.append(name_width - std::min(name.size(), name_width), ' ');
  add(one);
  if (!other.empty()) add(other);
  text += '\n';
}

/// Rows of the same mark of two sets.
template <class Marks>
struct Rows {
  std::string& text;
  const Marks &all, &free;

  void add_count(std::string_view name, std::size_t Marks::*count) { add_row(text, name, count_text(all.*count), count_text(free.*count)); }
  void add_number(std::string_view name, double Marks::*number, std::size_t decimals) {
    add_row(text, name, rounded(all.*number, decimals), rounded(free.*number, decimals));
  }
};

void add_triangles(std::string& text, const QualityReport& report) {
  Rows<TriangleMarks> rows{text, report.all, report.free};
  rows.add_count("triangles", &TriangleMarks::count);
  rows.add_number("smallest angle, degrees", &TriangleMarks::least_angle_deg, 2);
  rows.add_number("  of all but 0.1 %", &TriangleMarks::permille_angle_deg, 2);
  rows.add_number("  of all but 1 %", &TriangleMarks::percent_angle_deg, 2);
  rows.add_number("  median", &TriangleMarks::median_angle_deg, 2);
  rows.add_number("largest angle, degrees", &TriangleMarks::greatest_angle_deg, 2);
  rows.add_count("with an angle below 30", &TriangleMarks::below_30);
  rows.add_count("with an angle above 115", &TriangleMarks::above_115);
  rows.add_number("2 r / R, mean", &TriangleMarks::mean_radius_ratio, 4);
  rows.add_number("  least", &TriangleMarks::least_radius_ratio, 4);
  rows.add_number("longest to shortest edge, mean", &TriangleMarks::mean_edge_ratio, 3);
  rows.add_number("  greatest", &TriangleMarks::greatest_edge_ratio, 3);
  rows.add_number("growth to a neighbour, greatest", &TriangleMarks::greatest_growth, 3);
}

std::string bin_name(std::size_t bin) {
  const auto limit = [](std::size_t k) { return rounded(length_limits[k], 2); };
  if (bin == 0) return "  below " + limit(0);
  return bin == length_limits.size() ? "  from " + limit(bin - 1) : "  " + limit(bin - 1) + " .. " + limit(bin);
}

void add_edges(std::string& text, const QualityReport& report) {
  Rows<LengthMarks> rows{text, report.edges, report.free_edges};
  rows.add_count("edges", &LengthMarks::count);
  rows.add_number("length over size, mean", &LengthMarks::mean, 4);
  rows.add_number("  least", &LengthMarks::least, 3);
  rows.add_number("  greatest", &LengthMarks::greatest, 3);
  add_row(text, "  in 1 / sqrt 2 .. sqrt 2", percent(report.edges.in_band), percent(report.free_edges.in_band));
  for (std::size_t bin = 0; bin < report.edges.bins.size(); ++bin)
    add_row(text, bin_name(bin), count_text(report.edges.bins[bin]), count_text(report.free_edges.bins[bin]));
  rows.add_number("growth along model edges, greatest", &LengthMarks::greatest_growth, 3);
}

void add_obstacles(std::string& text, const QualityReport& report) {
  const std::size_t bound = report.all.count - report.free.count;
  const double part = report.all.count == 0 ? 0 : static_cast<double>(bound) / static_cast<double>(report.all.count);
  add_row(text, "triangles that are not free", count_text(bound), percent(part));
  const Obstacles& o = report.obstacles;
  add_row(text, "  frozen model edges", count_text(o.frozen_edges), "");
  add_row(text, "  short model edges", count_text(o.short_edges), "");
  add_row(text, "  sharp corners", count_text(o.sharp_corners), "");
  add_row(text, "  places close to another feature", count_text(o.close_features), "");
}

void add_valences(std::string& text, const QualityReport& report) {
  text += "vertices inside faces by edges\n";
  for (std::size_t k = 0; k < report.valences.size(); ++k) {
    if (report.valences[k] == 0) continue;
    add_row(text, "  " + count_text(k) + (k + 1 == report.valences.size() ? " and more" : ""), count_text(report.valences[k]), "");
  }
  add_row(text, "folds inside faces", count_text(report.folds), "");
}

void add_distance(std::string& text, std::string_view name, const OneWayDistance& distance) {
  add_row(text, name, rounded(distance.greatest, 6), rounded(distance.in_sizes, 5));
}

}  // namespace

std::string quality_table(const QualityReport& report) {
  std::string text;
  add_row(text, "", "all", "free");
  add_triangles(text, report);
  add_edges(text, report);
  add_obstacles(text, report);
  add_valences(text, report);
  return text;
}

std::string deviation_table(const Deviation& deviation) {
  std::string text;
  add_row(text, "greatest distance", "", "in sizes");
  add_distance(text, "  surface to the reference", deviation.to_reference);
  add_distance(text, "  reference to the surface", deviation.from_reference);
  add_distance(text, "  model edges to the reference", deviation.curves_to_reference);
  add_distance(text, "  reference to the model edges", deviation.curves_from_reference);
  return text;
}

}  // namespace mortise
