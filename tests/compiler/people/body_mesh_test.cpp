#include "compiler/people/body_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

#include "compiler/geometry/snap.h"

namespace citykiln::people {
namespace {

constexpr double kFine_m = 0.1, kHalf_m = 0.5, kCoarse_m = 1;
using Corners = std::array<Vec3, 3>;

std::vector<Look> all_looks() {
  std::vector<Look> looks;
  for (const Season season : {Season::kWarm, Season::kMild, Season::kCold})
    for (std::uint16_t i = 0; i < kBodies; ++i)
      looks.push_back(look_of({i, map::CountryGroup::kCentralEurope, season}, 1));
  return looks;
}

std::vector<Corners> triangles_of(const BodyMesh& body) {
  std::vector<Corners> all;
  const Mesh& mesh = body.mesh.mesh;
  for (const auto& [a, b, c] : mesh.triangles) all.push_back({mesh.positions[a], mesh.positions[b], mesh.positions[c]});
  return all;
}

Vec3 nearest_on_line(Vec3 a, Vec3 b, Vec3 p) {
  const Vec3 along = b - a;
  return a + along * std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
}

double distance_to(const Corners& t, Vec3 p) {
  const Vec3 up = unit(cross(t[1] - t[0], t[2] - t[0])), foot = p - up * dot(p - t[0], up);
  bool is_inside = true;
  double sides = 10;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 a = t[i], b = t[(i + 1) % 3];
    is_inside = is_inside && dot(cross(b - a, foot - a), up) >= 0;
    sides = std::min(sides, length(p - nearest_on_line(a, b, p)));
  }
  return is_inside ? length(p - foot) : sides;
}

// The greatest distance of the corners of one shape from another.
double distance_of(const std::vector<Corners>& from, const std::vector<Corners>& to) {
  double greatest = 0;
  for (const Corners& t : from)
    for (const Vec3 p : t) {
      double nearest = 10;
      for (const Corners& other : to) nearest = std::min(nearest, distance_to(other, p));
      greatest = std::max(greatest, nearest);
    }
  return greatest;
}

TEST(BodyMesh, DeviatesByNoMoreThanItsError) {
  const std::vector<Look> looks = all_looks();
  // some of each stance, all bags among them
  for (std::size_t i = 0; i < looks.size(); i += 4) {
    const Look& look = looks[i];
    const std::vector<Corners> full = triangles_of(body_mesh(look, kFine_m));
    for (const double tolerance : {kHalf_m, kCoarse_m}) {
      const BodyMesh cut = body_mesh(look, tolerance);
      EXPECT_LE(cut.error_m, tolerance);
      EXPECT_LE(distance_of(full, triangles_of(cut)), cut.error_m);
      EXPECT_LE(distance_of(triangles_of(cut), full), cut.error_m);
    }
  }
}

TEST(BodyMesh, HasFewTrianglesAndFewerAtCoarseLevels) {
  for (const Look& look : all_looks()) {
    const std::size_t full = triangles_of(body_mesh(look, kFine_m)).size();
    EXPECT_GE(full, 500u);
    EXPECT_LE(full, 780u);
    EXPECT_EQ(triangles_of(body_mesh(look, kHalf_m)).size(), look.figure == Figure::kChild ? 16u : 72u);
    EXPECT_EQ(triangles_of(body_mesh(look, kCoarse_m)).size(), 16u);
  }
}

TEST(BodyMesh, IsGoneAtItsHeight) {
  for (const Look& look : all_looks()) {
    const BodyMesh gone = body_mesh(look, look.height_m);
    EXPECT_TRUE(gone.mesh.mesh.triangles.empty());
    EXPECT_EQ(gone.error_m, look.height_m);
  }
}

// Each directed side belongs to one triangle, and its opposite to another.
TEST(BodyMesh, IsClosed) {
  for (const Look& look : all_looks())
    for (const double tolerance : {kFine_m, kHalf_m, kCoarse_m}) {
      std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
      for (const Triangle& t : body_mesh(look, tolerance).mesh.mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) ++sides[{t[i], t[(i + 1) % 3]}];
      for (const auto& [side, times] : sides) {
        EXPECT_EQ(times, 1);
        EXPECT_TRUE(sides.contains({side.second, side.first}));
      }
    }
}

TEST(BodyMesh, LooksOutwardsAndStandsOnTheGround) {
  for (const Look& look : all_looks()) {
    double six_volumes = 0, lowest = 10, highest = 0;
    for (const Corners& t : triangles_of(body_mesh(look, kFine_m))) {
      six_volumes += dot(t[0], cross(t[1], t[2]));
      for (const Vec3 p : t) lowest = std::min(lowest, p.z), highest = std::max(highest, p.z);
    }
    // a person of 1.75 m has some 75 litres; here coats are solid, and parts overlap
    const double size = look.height_m / 1.75;
    EXPECT_GT(six_volumes / 6, 0.04 * size * size * size);
    EXPECT_LT(six_volumes / 6, 0.19 * size * size * size);
    EXPECT_NEAR(lowest, 0, 0.03);
    if (look.pose != Pose::kSit) {
      EXPECT_NEAR(highest, look.height_m, 0.07 * look.height_m);
    }
  }
}

TEST(BodyMesh, LiesOnTheGridWithUnitNormals) {
  for (const Look& look : all_looks()) {
    const Mesh mesh = body_mesh(look, kFine_m).mesh.mesh;
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    for (const Vec3 p : mesh.positions) EXPECT_EQ(p, snapped(p));
    for (const Vec3 n : mesh.normals) EXPECT_NEAR(length(n), 1, 1e-9);
  }
}

}  // namespace
}  // namespace citykiln::people
