#include "compiler/structures/generate.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/contract/detail_tolerances.h"
#include "compiler/geometry/snap.h"
#include "compiler/structures/ribs.h"
#include "tests/compiler/structures/made_spans.h"

namespace citykiln::structures {
namespace {

Span bent(bool has_pavements = false) {
  return made_span({{0, 0}, {20, 0}, {30, 10}, {30, 40}}, {{0, 10, 0}, {20, 12, 0}, {34.125, 12, 0}, {64.125, 9, 0}},
                   has_pavements);
}

Span with_supports() {
  Span span = bent(true);
  span.from = {EndKind::kGround, {-20, 0}, 0}, span.to = {EndKind::kBesideRoad, {}, 3};
  span.piers = {{20, 2}, {40, 1.5}};
  return span;
}

double distance_to_segment(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 ab = b - a;
  const double l2 = dot(ab, ab), t = l2 > 0 ? std::clamp(dot(p - a, ab) / l2, 0.0, 1.0) : 0;
  return length(p - (a + ab * t));
}

double distance_to_triangle(Vec3 p, Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 n = unit(cross(b - a, c - a));
  const auto inside = [&](Vec3 u, Vec3 v) { return dot(cross(v - u, p - u), n) >= 0; };
  if (inside(a, b) && inside(b, c) && inside(c, a)) return std::abs(dot(p - a, n));
  return std::min({distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

double distance_to(const std::vector<materials::MaterialMesh>& meshes, Vec3 p) {
  double nearest = 1e9;
  for (const auto& m : meshes)
    for (const auto& [a, b, c] : m.mesh.triangles)
      nearest =
          std::min(nearest, distance_to_triangle(p, m.mesh.positions[a], m.mesh.positions[b], m.mesh.positions[c]));
  return nearest;
}

TEST(Generate, ClosesTheDeckAndEveryPart) {
  for (const bool has_pavements : {false, true})
    for (const double tolerance_m : {0.02, 0.1, 0.5})
      EXPECT_TRUE(open_edges(all_meshes(generate(bent(has_pavements), tolerance_m))).empty()) << tolerance_m;
  EXPECT_TRUE(open_edges(all_meshes(generate(with_supports(), 0.02))).empty());
  Span path = bent();
  path.surface = map::LandCoverClass::kFootPath;
  EXPECT_TRUE(open_edges(all_meshes(generate(path, 0.02))).empty());
}

TEST(Generate, FacesOutwards) {
  Span straight = made_span({{0, 0}, {50, 0}}, {{0, 10, 0}});
  const double slab = 50 * 6.5 * 0.45, volume = volume_m3(all_meshes(generate(straight, 0.02)));
  EXPECT_GT(volume, slab);
  EXPECT_LT(volume, 50 * (6.5 * 2.5 + 0.5));
  EXPECT_GT(volume_m3(all_meshes(generate(with_supports(), 0.02))),
            volume_m3(all_meshes(generate(bent(true), 0.02))) / 2);
}

TEST(Generate, HasTheWidthsOfItsRoad) {
  Span span = made_span({{0, 0}, {50, 0}}, {{0, 10, 0}}, true);
  span.section.lanes.pop_back();
  const auto meshes = all_meshes(generate(span, 0.02));
  EXPECT_TRUE(has_point(meshes, {0, 5, 10}));
  EXPECT_TRUE(has_point(meshes, {0, -3, 10 - 0.125}));
  EXPECT_TRUE(has_point(meshes, {0, 5.25, 11}));
  EXPECT_TRUE(has_point(meshes, {0, -3.25, 11}));
}

TEST(Generate, HasMarkingsOnFineLevels) {
  EXPECT_EQ(generate(bent(), 0.02).marked.size(), 1u);
  EXPECT_TRUE(generate(bent(), tolerances_with(Detail::kRoadSurfaces).below_m).marked.empty());
}

TEST(Generate, GivesJoinedSpansTheSameEdges) {
  Span a = made_span({{0, 0}, {40, 0}}, {{0, 10, 0}}), b = made_span({{40, 0}, {60, 30}}, {{0, 10, 0}});
  a.to = {EndKind::kJoint, {60, 30}, 0}, b.from = {EndKind::kJoint, {0, 0}, 0};
  // the same span, drawn in the opposite direction
  Span c = made_span({{60, 30}, {40, 0}}, {{0, 10, 0}});
  c.to = {EndKind::kJoint, {0, 0}, 0};
  const auto corners = [](const Span& span, bool at_end) {
    std::vector<Vec3> points;
    const auto ribs = ribs_of(span);
    for (const double left_m : {3.25, -3.25})
      points.push_back(point_on(at_end ? ribs.back() : ribs.front(), left_m, 0));
    std::ranges::sort(points);
    return points;
  };
  EXPECT_EQ(corners(a, true), corners(b, false));
  EXPECT_EQ(corners(a, true), corners(c, true));
}

TEST(Generate, StatesAnErrorOfAtLeastWhatItOmits) {
  Span arched = with_supports();
  arched.profile = {{0, 10, 0}, {10, 10.5, 0.01}, {20, 10.75, 0.02}, {30, 10.5, 0}, {50, 9.75, 0}, {64.125, 9, 0}};
  Span path = arched;
  path.surface = map::LandCoverClass::kFootPath;
  for (const Span& span : {arched, path}) {
    const auto fine = all_meshes(generate(span, 0.001));
    for (const double tolerance_m : {0.02, 0.1, 0.5, 1.5, 2.5, 12.5}) {
      const GeneratedStructure expanded = generate(span, tolerance_m);
      const auto coarse = all_meshes(expanded);
      EXPECT_LE(expanded.error_m, tolerance_m);
      for (const auto& m : fine) {
        for (const Vec3 p : m.mesh.positions) {
          // to the coarse mesh or to the ground below it
          const double off_m = std::min(distance_to(coarse, p), std::abs(p.z - 2));
          EXPECT_LE(off_m, expanded.error_m + 0.01) << tolerance_m << " " << p.z;
        }
      }
    }
  }
}

TEST(Generate, NeedsFewTrianglesFromAfar) {
  std::size_t last = 1u << 30;
  for (const double tolerance_m : {0.02, 0.1, 0.5, 2.5, 12.5}) {
    std::size_t triangles = 0;
    for (const auto& m : all_meshes(generate(with_supports(), tolerance_m))) triangles += m.mesh.triangles.size();
    EXPECT_LE(triangles, last);
    last = triangles;
  }
  EXPECT_LE(last, 6u);
}

TEST(Generate, CutsEndsBackAtARoadThatPasses) {
  Span span = made_span({{0, 0}, {50, 0}}, {{0, 10, 0}});
  span.to = {EndKind::kBesideRoad, {}, 4.25};
  for (const auto& m : all_meshes(generate(span, 0.02)))
    for (const Vec3 p : m.mesh.positions) EXPECT_LE(p.x, 45.75);
  span.to.cut_m = 60;
  EXPECT_TRUE(all_meshes(generate(span, 0.02)).empty());
}

TEST(Generate, IsTotalOnHairpinsAndStubs) {
  Span span = made_span({{0, 0}, {10, 0}, {0, 0}}, {});
  for (const auto& part : all_meshes(generate(span, 0.02)))
    for (const Vec3 p : part.mesh.positions) EXPECT_EQ(p, snapped(p));
  span.axis = {{0, 0}};
  EXPECT_TRUE(all_meshes(generate(span, 0.02)).empty());
}

}  // namespace
}  // namespace citykiln::structures
