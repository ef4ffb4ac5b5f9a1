#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

#include "compiler/geometry/snap.h"
#include "compiler/props/generate.h"

namespace citykiln::props {
namespace {

constexpr LampKind kAll[] = {LampKind::kPostTop, LampKind::kArm};
// Tolerances that select each level of a lamp of 1 m, finest first.
constexpr double kDetails[] = {0.001, 0.016, 0.5};

using Corners = std::array<Vec3, 3>;

std::vector<Corners> triangles_of(const GeneratedProp& lamp) {
  std::vector<Corners> all;
  for (const auto& part : lamp.meshes)
    for (const auto& [a, b, c] : part.mesh.triangles)
      all.push_back({part.mesh.positions[a], part.mesh.positions[b], part.mesh.positions[c]});
  return all;
}

Vec3 nearest_on_line(Vec3 a, Vec3 b, Vec3 p) {
  const Vec3 along = b - a;
  return a + along * std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
}

// On a side of the triangle, or the projection to its plane if that lies inside.
double distance_to(const Corners& t, Vec3 p) {
  const Vec3 up = unit(cross(t[1] - t[0], t[2] - t[0])), foot = p - up * dot(p - t[0], up);
  bool is_inside = true;
  double sides = 10;
  for (int i = 0; i < 3; ++i) {
    const Vec3 a = t[i], b = t[(i + 1) % 3];
    is_inside = is_inside && dot(cross(b - a, foot - a), up) >= 0;
    sides = std::min(sides, length(p - nearest_on_line(a, b, p)));
  }
  return is_inside ? length(p - foot) : sides;
}

// The distance to one triangle is convex, so a piece whose vertices are within the limit of one triangle is within it;
// otherwise the piece is halved at its longest side.
bool is_within(double limit, const Corners& piece, const std::vector<Corners>& shape, int times) {
  for (const Corners& t : shape)
    if (std::ranges::all_of(piece, [&](Vec3 p) { return distance_to(t, p) <= limit; })) return true;
  if (times == 0) return false;
  int longest = 0;
  const auto side_m = [&](int i) { return length(piece[(i + 1) % 3] - piece[i]); };
  for (int i = 1; i < 3; ++i)
    if (side_m(i) > side_m(longest)) longest = i;
  const Vec3 a = piece[longest], b = piece[(longest + 1) % 3], c = piece[(longest + 2) % 3], middle = (a + b) * 0.5;
  return is_within(limit, {a, middle, c}, shape, times - 1) && is_within(limit, {middle, b, c}, shape, times - 1);
}

bool is_within(double limit, const std::vector<Corners>& from, const std::vector<Corners>& to) {
  return std::ranges::all_of(from, [&](const Corners& piece) { return is_within(limit, piece, to, 20); });
}

TEST(LampMesh, DeviatesByNoMoreThanItsError) {
  for (const LampKind kind : kAll) {
    const auto full = triangles_of(lamp_mesh(kind, 1, kDetails[0], false));
    for (const double tolerance : {kDetails[1], kDetails[2]}) {
      const GeneratedProp cut = lamp_mesh(kind, 1, tolerance, false);
      EXPECT_GT(cut.error_m, 0);
      EXPECT_LE(cut.error_m, tolerance);
      EXPECT_TRUE(is_within(cut.error_m, full, triangles_of(cut)));
      EXPECT_TRUE(is_within(cut.error_m, triangles_of(cut), full));
    }
  }
}

TEST(LampMesh, NeedsFewTrianglesAndFewerOnCoarserLevels) {
  for (const LampKind kind : kAll) {
    std::vector<std::size_t> counts;
    for (const double tolerance : kDetails) counts.push_back(triangles_of(lamp_mesh(kind, 1, tolerance, false)).size());
    EXPECT_LE(counts[0], 80u);
    EXPECT_GE(counts[0], 2 * counts[1]);
    EXPECT_GT(counts[1], counts[2]);
    EXPECT_EQ(triangles_of(lamp_mesh(kind, 10, 0.02, false)).size(), counts[0]);
    EXPECT_LE(triangles_of(lamp_mesh(kind, 12, 0.5, false)).size(), 20u);
  }
}

TEST(LampMesh, KeepsWithinEachLevelOfTheLadder) {
  for (const LampKind kind : kAll)
    for (const double height_m : {4.0, 6.0, 8.0, 10.0, 12.0})
      for (const double tolerance : {0.02, 0.1, 0.5, 2.5, 12.5}) {
        const GeneratedProp lamp = lamp_mesh(kind, height_m, tolerance, false);
        EXPECT_LE(lamp.error_m, tolerance);
        EXPECT_EQ(lamp.meshes.empty(), height_m <= tolerance);
        EXPECT_TRUE(!lamp.meshes.empty() || lamp.error_m == height_m);
      }
}

TEST(LampMesh, IsOneMetreTallWithItsHeadTowardsX) {
  for (const LampKind kind : kAll)
    for (const double tolerance : kDetails) {
      Box2 plan;
      double top = 0, foot = 0;
      for (const auto& part : lamp_mesh(kind, 1, tolerance, false).meshes)
        for (const Vec3 p : part.mesh.positions) {
          EXPECT_EQ(p, snapped(p));
          plan.grow(in_plan(p));
          top = std::max(top, p.z), foot = std::min(foot, p.z);
        }
      EXPECT_EQ(top, 1);
      EXPECT_LT(foot, 0);
      EXPECT_GT(plan.min.x, -0.05);
      EXPECT_LT(plan.height(), 0.1);
      EXPECT_NEAR(plan.max.x, kind == LampKind::kArm ? 0.21 : 0.03, 0.015);
    }
}

TEST(LampMesh, ClosesAllItsParts) {
  for (const LampKind kind : kAll)
    for (const double tolerance : kDetails) {
      const GeneratedProp lamp = lamp_mesh(kind, 1, tolerance, false);
      ASSERT_FALSE(lamp.meshes.empty());
      for (const auto& part : lamp.meshes) {
        const Mesh& mesh = part.mesh;
        std::map<std::pair<Vec3, Vec3>, int> open;
        double six = 0;
        for (const Triangle& t : mesh.triangles) {
          six += dot(mesh.positions[t[0]], cross(mesh.positions[t[1]], mesh.positions[t[2]]));
          for (int i = 0; i < 3; ++i) {
            const Vec3 a = mesh.positions[t[i]], b = mesh.positions[t[(i + 1) % 3]];
            a < b ? ++open[{a, b}] : --open[{b, a}];
          }
        }
        EXPECT_GT(six, 0);
        for (const auto& [edge, count] : open) EXPECT_EQ(count, 0);
      }
    }
}

}  // namespace
}  // namespace citykiln::props
