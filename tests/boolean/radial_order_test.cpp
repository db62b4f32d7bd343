// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The order of facets round an edge against exact angles in whole numbers, with opposite half-planes and one ulp between pages.
#include "mortise/boolean/radial_order.h"

#include <algorithm>
#include <optional>
#include <random>

#include "support/arrangement.h"
#include "support/boolean_scenes.h"
#include "support/catch.h"
#include "support/test_scale.h"

using namespace mortise;
using namespace mortise::test;

namespace {

using Whole = std::array<long long, 3>;

Whole operator-(const Whole& a, const Whole& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Whole times(long long s, const Whole& a) { return {s * a[0], s * a[1], s * a[2]}; }
long long dot_of(const Whole& a, const Whole& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Whole cross_of(const Whole& a, const Whole& b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }
bool is_zero(const Whole& a) { return dot_of(a, a) == 0; }

/// The direction of a half-plane round an edge, in a basis across the edge that is right-handed with it: x along the
/// reference, each coordinate up to a positive factor of its own. Angles change, their order does not.
struct Direction {
  long long x = 0, y = 0;
};

Direction direction_of(const Whole& edge, const Whole& reference, const Whole& towards) {
  const Whole e1 = times(dot_of(edge, edge), reference) - times(dot_of(edge, reference), edge);
  return {dot_of(towards, e1), dot_of(towards, cross_of(edge, e1))};
}

/// 0: along the reference; 1: less than half a turn from it, 2: opposite, 3: more.
int half_of(const Direction& d) { return d.y > 0 ? 1 : d.y < 0 ? 3 : d.x > 0 ? 0 : 2; }

bool turns_less(const Direction& a, const Direction& b) {
  if (half_of(a) != half_of(b)) return half_of(a) < half_of(b);
  return a.x * b.y - a.y * b.x > 0;
}

bool are_same(const Direction& a, const Direction& b) { return half_of(a) == half_of(b) && a.x * b.y - a.y * b.x == 0; }

/// Pages of a book: faces from one edge to an apex each, every other one the other way round.
struct Book {
  Whole u, v;
  std::vector<Whole> apexes;

  [[nodiscard]] SurfaceMesh mesh() const {
    const auto point = [](const Whole& p) {
      return Vec3d{static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
    };
    SurfaceMesh result;
    result.points = {point(u), point(v)};
    for (std::size_t i = 0; i < apexes.size(); ++i) {
      result.points.push_back(point(apexes[i]));
      const std::size_t from = i % 2, to = 1 - from;
      result.triangles.push_back({VertexId(from), VertexId(to), VertexId(i + 2)});
    }
    return result;
  }
};

class BookMaker {
 public:
  explicit BookMaker(std::uint32_t seed) : random_(seed) {}

  /// Up to `count` pages, no two on one half-plane; every third one opposite to a former one.
  Book make(std::size_t count) {
    Book book{point(), point(), {}};
    while (is_zero(book.v - book.u)) book.v = point();
    for (std::size_t tries = 0; tries < 4 * count && book.apexes.size() < count; ++tries) {
      Whole apex = point();
      if (tries % 3 == 2 && !book.apexes.empty()) apex = times(2, book.u) - book.apexes[random_() % book.apexes.size()];
      if (is_zero(cross_of(book.v - book.u, apex - book.u))) continue;
      const auto is_taken = [&](const Whole& other) {
        return are_same(direction_of(book.v - book.u, apex - book.u, apex - book.u),
                        direction_of(book.v - book.u, apex - book.u, other - book.u));
      };
      if (std::none_of(book.apexes.begin(), book.apexes.end(), is_taken)) book.apexes.push_back(apex);
    }
    return book;
  }

 private:
  Whole point() {
    const auto coordinate = [&] { return static_cast<long long>(random_() % 5) - 2; };
    return {coordinate(), coordinate(), coordinate()};
  }
  std::mt19937 random_;
};

std::vector<FacetAtEdge> pages_of(const Arrangement& scene, bool backward) {
  const auto& point = scene.faces.point_of_vertex[OperandId(std::size_t{0})];
  std::vector<FacetAtEdge> around;
  for (std::size_t f = 0; f < scene.facets.size(); ++f) {
    around.push_back(facet_at_edge(scene.faces, scene.facets, FacetId(f), point[backward ? 1 : 0], point[backward ? 0 : 1]));
  }
  return around;
}

std::vector<std::size_t> numbers(const std::vector<FacetAtEdge>& around) {
  std::vector<std::size_t> result;
  for (const FacetAtEdge& f : around) result.push_back(f.facet.index());
  return result;
}

/// Pages by exact angle from page `first`, looking from v to u.
std::vector<std::size_t> expected_order(const Book& book, std::size_t first, bool backward) {
  const Whole edge = backward ? book.u - book.v : book.v - book.u;
  const auto direction = [&](std::size_t i) { return direction_of(edge, book.apexes[first] - book.u, book.apexes[i] - book.u); };
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < book.apexes.size(); ++i) order.push_back(i);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return turns_less(direction(a), direction(b)); });
  return order;
}

}  // namespace

TEST_CASE("pages of a book are sorted by their exact angles, beginning with any of them, from either end") {
  constexpr std::uint32_t seed = 1515;
  INFO("seed " << seed);
  BookMaker maker(seed);
  std::size_t pages = 0;
  for (std::size_t i = 0, n = scaled_count(800, 100000); i < n; ++i) {
    INFO("case " << i);
    const Book book = maker.make(2 + i % 9);
    if (book.apexes.size() < 2) continue;
    const Arrangement scene({scaled(book.mesh(), i % 3 == 0 ? 1 : i % 3 == 1 ? 0x1p200 : 0x1p-200)});
    REQUIRE(scene.facets.size() == book.apexes.size());
    for (const bool backward : {false, true}) {
      std::vector<FacetAtEdge> around = pages_of(scene, backward);
      std::rotate(around.begin(), around.begin() + static_cast<std::ptrdiff_t>(i % around.size()), around.end());
      const std::size_t first = around.front().facet.index();
      sort_round_edge(scene.faces, around);
      CHECK(numbers(around) == expected_order(book, first, backward));
    }
    pages += book.apexes.size();
  }
  CHECK(pages > 3 * scaled_count(800, 100000));
}

TEST_CASE("the first page after minus y has the smallest exact angle from there") {
  constexpr std::uint32_t seed = 77;
  INFO("seed " << seed);
  BookMaker maker(seed);
  std::size_t compared = 0;
  for (std::size_t i = 0, n = scaled_count(800, 100000); i < n; ++i) {
    INFO("case " << i);
    const Book book = maker.make(1 + i % 7);
    const Whole edge = book.v - book.u, down{0, -1, 0};
    if (book.apexes.empty() || is_zero(cross_of(edge, down))) continue;
    const auto direction = [&](std::size_t p) { return direction_of(edge, down, book.apexes[p] - book.u); };
    std::size_t first = 0;
    bool is_fine = true;
    for (std::size_t p = 0; p < book.apexes.size(); ++p) {
      is_fine = is_fine && half_of(direction(p)) != 0;  // none may lie on that half-plane
      if (turns_less(direction(p), direction(first))) first = p;
    }
    if (!is_fine) continue;
    const Arrangement scene({book.mesh()});
    CHECK(first_after_minus_y(scene.faces, pages_of(scene, false)).facet.index() == first);
    ++compared;
  }
  CHECK(compared > scaled_count(800, 100000) / 2);
}

TEST_CASE("pages one ulp apart, and one ulp from opposite, keep their order") {
  const double ulp = 0x1p-52;
  // Round the z axis: angles of 0, one ulp, half a turn less one ulp, half a turn, half a turn and one ulp, a turn less one ulp.
  const std::vector<Vec3d> apexes{{1, 0, 0}, {1, ulp, 0}, {-1, ulp, 0}, {-1, 0, 0}, {-1, -ulp, 0}, {1, -ulp, 0}};
  SurfaceMesh mesh;
  mesh.points = {{0, 0, 0}, {0, 0, 1}};
  for (const std::size_t i : {3U, 0U, 5U, 2U, 4U, 1U}) {
    mesh.points.push_back(apexes[i]);
    mesh.triangles.push_back({VertexId(0), VertexId(1), VertexId(mesh.points.size() - 1)});
  }
  const Arrangement scene({mesh});
  std::vector<FacetAtEdge> around = pages_of(scene, false);
  std::rotate(around.begin(), around.begin() + 1, around.end());  // begin with angle 0
  sort_round_edge(scene.faces, around);
  CHECK(numbers(around) == std::vector<std::size_t>{1, 5, 3, 0, 4, 2});
}

TEST_CASE("two pages are sorted already, opposite or not") {
  const Arrangement scene({make_mesh({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 0, 0}}, {{0, 1, 2}, {1, 0, 3}})});
  std::vector<FacetAtEdge> around = pages_of(scene, false);
  sort_round_edge(scene.faces, around);
  CHECK(numbers(around) == std::vector<std::size_t>{0, 1});
}

TEST_CASE("a facet knows which way it runs along the edge, and where one comes out after it") {
  const Arrangement scene({make_mesh({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 0, 0}}, {{0, 1, 2}, {1, 0, 3}})});
  const std::vector<FacetAtEdge> up = pages_of(scene, false), down = pages_of(scene, true);
  CHECK((up[0].is_forward && !up[1].is_forward && !down[0].is_forward && down[1].is_forward));
  // Page 0 runs up the z axis to +x: its front is at +y, where one comes out turning counterclockwise.
  CHECK(up[0].is_front_after());
  CHECK_FALSE(up[1].is_front_after());
}

TEST_CASE("the witness of a facet lies on its side of the edge, also where all its corners were made") {
  std::size_t made = 0;
  for (const Scene& scene : small_scenes()) {
    INFO(scene.name);
    const Arrangement arrangement(scene.operands);
    const PointSet& points = arrangement.faces.points;
    for (std::size_t i = 0; i < arrangement.facets.size(); ++i) {
      const FacetId f(i);
      const PlanePoints& c = arrangement.facets.corners[f];
      const SourceId source = arrangement.facets.sources_of(f).front().face;
      const SlotId slot = arrangement.overlays.slot_of_face[source];
      if (!slot.is_valid()) continue;
      const Axis axis = arrangement.overlays.axis[arrangement.overlays.overlay_of_slot[slot]];
      for (std::size_t e = 0; e < 3; ++e) {
        const PointId u = c[e], v = c[(e + 1) % 3];
        const FacetAtEdge forward = facet_at_edge(arrangement.faces, arrangement.facets, f, u, v);
        const FacetAtEdge backward = facet_at_edge(arrangement.faces, arrangement.facets, f, v, u);
        CHECK((forward.is_forward && !backward.is_forward));
        CHECK((forward.face == source && backward.face == source));
        const PlanePoints& corners = arrangement.faces.corners[source];
        for (const PointId w : {forward.witness, backward.witness}) {
          CHECK(std::find(corners.begin(), corners.end(), w) != corners.end());
          CHECK(points.orient2d(u, v, w, axis) == points.orient2d(u, v, c[(e + 2) % 3], axis));
        }
      }
      made += points.is_input(c[0]) || points.is_input(c[1]) || points.is_input(c[2]) ? 0 : 1;
    }
  }
  CHECK(made > 10);
}
