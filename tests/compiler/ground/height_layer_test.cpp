#include "compiler/ground/height_layer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/ground/generate.h"
#include "compiler/ground/plan.h"
#include "tests/compiler/roads/made_road.h"

namespace citykiln::ground {
namespace {

constexpr Box2 kLayeredCell{{0, 0}, {128, 128}};
constexpr double kAtEnds_m = 20, kInside_m = 16;

map::Heightfield flat_field() {
  map::Heightfield field{{-256, -256}, {16, 16}, 49, 49, {}, 0};
  field.heights.assign(49 * 49, static_cast<std::int32_t>(kAtEnds_m / map::kHeightQuantum_m));
  return field;
}

// From west to east through the cell; 3 m wide.
roads::Road path(Profile profile) {
  roads::Road road = roads::made_road(1, {{-64, 64}, {192, 64}}, 3, map::LandCoverClass::kFootPath);
  road.profile = std::move(profile);
  return road;
}

// Down 4 m to an underpass and up again.
Profile down_and_up() { return {{0, kAtEnds_m, 0}, {96, kInside_m, 0}, {160, kInside_m, 0}, {256, kAtEnds_m, 0}}; }

// Crosses the path with a clearance of 2 m, which is too little: the land lies below the path.
roads::Road low_bridge() {
  roads::Road road = roads::made_road(2, {{64, 32}, {64, 96}}, 6);
  road.profile = {{0, kInside_m + 2, 0}, {64, kInside_m + 2, 0}};
  return road;
}

// The largest distance of the path's faces from its profile.
double largest_gap_m(const roads::Road& road) {
  const std::vector surfaces{surface_of(road, {})};
  const std::vector roads{road}, decks{low_bridge()};
  const GradedTerrain graded =
      grade_terrain(flat_field(), {roads, {}, surfaces, kLayeredCell.widened(kGrading_m), true, decks});
  Report report;
  const GroundMesh ground = generate_cell(surfaces, graded, kLayeredCell, 0.1, report);
  double largest_m = -1;
  for (std::uint32_t f = 0; f < ground.first_vertical; ++f)
    for (const std::uint32_t v : ground.mesh.triangles[f]) {
      if (ground.face_cover[f] == kNoLandCover) continue;
      const Vec3 p = ground.mesh.positions[v];
      largest_m = std::max(largest_m, std::abs(p.z - knot_at(road.profile, p.x + 64).z_m));
    }
  return largest_m;
}

TEST(HeightLayer, PathsWithProfilesLieOnThem) {
  const double gap_m = largest_gap_m(path(down_and_up()));
  EXPECT_GE(gap_m, 0) << "there is no path";
  EXPECT_LE(gap_m, 0.1);
}

TEST(HeightLayer, PathsWithoutProfilesLieOnTheLand) {
  EXPECT_EQ(layer_of(surface_of(path({}), {})), HeightLayer::kLand);
  EXPECT_EQ(layer_of(surface_of(path(down_and_up()), {})), HeightLayer::kCarriageway);
}

TEST(HeightLayer, TrimmedPathsStayOnTheirProfiles) {
  const LandCoverPolygon whole = surface_of(path(down_and_up()), {});
  EXPECT_EQ(layer_of(trimmed_to(whole, kLayeredCell)), HeightLayer::kCarriageway);
}

}  // namespace
}  // namespace citykiln::ground
