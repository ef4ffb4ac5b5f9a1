// The ground of two neighbouring tiles of small random maps. CITYKILN_SEEDS=FROM:TO tests other seeds than the first
// few hundred.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string>

#include "compiler/bake/ground/ground_cells.h"
#include "tests/compiler/bake/made_border_map.h"

namespace citykiln::bake {
namespace {

using ground::GroundMesh;

struct Seeds {
  std::uint64_t from = 0, to = 300;
};

Seeds asked_seeds() {
  Seeds seeds;
  if (const char* asked = std::getenv("CITYKILN_SEEDS")) {
    char* end = nullptr;
    seeds.from = std::strtoull(asked, &end, 10);
    seeds.to = *end == ':' ? std::strtoull(end + 1, nullptr, 10) : seeds.from + 1;
  }
  return seeds;
}

/// The tolerances of both tiles, and of the border between them.
struct Tolerances {
  double first_m, second_m;
  double between_m() const { return std::min(first_m, second_m); }
};

Tolerances tolerances_of(std::uint64_t seed) {
  constexpr double kLevels_m[] = {0.02, 0.1, 0.5, 2.5, 12.5};
  const double own_m = kLevels_m[seed % 5];
  return seed % 7 == 0 ? Tolerances{own_m, kLevels_m[(seed / 5) % 5]} : Tolerances{own_m, own_m};
}

std::vector<ground::LandCoverPolygon> surfaces_about(const MadeBorderMap& map, const Box2& tile) {
  std::vector<ground::LandCoverPolygon> near;
  for (const ground::LandCoverPolygon& surface : map.surfaces)
    if (auto part = ground::trimmed_to(surface, tile.widened(scene::kHalo_m)); !part.rings.empty())
      near.push_back(std::move(part));
  return near;
}

/// Generates a tile's ground from what its chunk would hold.
GroundMesh ground_of(const MadeBorderMap& map, const Box2& tile, double tolerance_m, double sides_m) {
  const auto surfaces = surfaces_about(map, tile);
  const ground::GradedTerrain graded = ground::grade_terrain(map::window_of(map.terrain, tile.widened(scene::kHalo_m)),
                                                             {.roads = map.roads,
                                                              .streams = map.streams,
                                                              .surfaces = surfaces,
                                                              .box = tile.widened(ground::kGrading_m),
                                                              .has_kerbs = sides_m < 1});
  Report report;
  const CellLevel level{tile, tolerance_m, ground::all_sides(sides_m)};
  return std::move(generate_cells(graded, surfaces, std::array{level}, 1, report).front());
}

/// The number of times that each edge on the border of both tiles occurs, without vertical ones.
using Met = std::map<std::pair<Vec3, Vec3>, int>;

void count_met(const GroundMesh& ground, const MadeBorderMap& map, Met& met) {
  const bool is_beside = map.second.min.x > map.first.min.x;
  const auto is_on_border = [&](Vec3 p) { return (is_beside ? p.x : p.y) == kMadeBorder_m; };
  for (const Triangle& t : ground.mesh.triangles)
    for (int i = 0; i < 3; ++i) {
      const Vec3 a = ground.mesh.positions[t[i]], b = ground.mesh.positions[t[(i + 1) % 3]];
      if (is_on_border(a) && is_on_border(b) && in_plan(a) != in_plan(b)) ++met[std::minmax(a, b)];
    }
}

std::string seam_of(const Met& met) {
  for (const auto& [edge, count] : met)
    if (count % 2 != 0)
      return "seam at " + std::to_string(edge.first.x) + ", " + std::to_string(edge.first.y) + ", " +
             std::to_string(edge.first.z) + " to " + std::to_string(edge.second.x) + ", " +
             std::to_string(edge.second.y) + ", " + std::to_string(edge.second.z) + "; ";
  return {};
}

std::string hole_of(const GroundMesh& ground) {
  double twice_m2 = 0;
  for (std::uint32_t f = 0; f < ground.first_vertical; ++f) {
    const Triangle& t = ground.mesh.triangles[f];
    const Vec2 a = in_plan(ground.mesh.positions[t[0]]);
    const double one = cross(in_plan(ground.mesh.positions[t[1]]) - a, in_plan(ground.mesh.positions[t[2]]) - a);
    if (one <= 0) return "a face without area; ";
    twice_m2 += one;
  }
  return twice_m2 == 2 * kMadeTile_m * kMadeTile_m ? "" : "faces do not cover the tile once; ";
}

/// Returns what is wrong with the ground of a seed; nothing where all is well.
std::string faults_of(std::uint64_t seed) {
  const MadeBorderMap map = made_border_map(seed);
  const Tolerances tolerances = tolerances_of(seed);
  const GroundMesh first = ground_of(map, map.first, tolerances.first_m, tolerances.between_m()),
                   second = ground_of(map, map.second, tolerances.second_m, tolerances.between_m());
  Met met;
  count_met(first, map, met), count_met(second, map, met);
  return seam_of(met) + hole_of(first) + hole_of(second);
}

TEST(GroundBorders, OfNeighbouringTilesAreClosedAndTheGroundHasNoHole) {
  const Seeds seeds = asked_seeds();
  std::uint64_t failed = 0;
  for (std::uint64_t seed = seeds.from; seed < seeds.to; ++seed) {
    const std::string faults = faults_of(seed);
    if (faults.empty()) continue;
    ++failed;
    if (failed <= 20) ADD_FAILURE() << "seed " << seed << ": " << faults;
  }
  EXPECT_EQ(failed, 0u) << "of " << seeds.to - seeds.from << " seeds";
}

// Beyond the seeds of the test above: a kerb that leaves the border a grid step beside another one, a kerb that passes
// a vertex of the border half a step off, and a shore one step beside the border that passes a vertex of the terrain.
TEST(GroundBorders, AreClosedWhereRoundedBordersPassTheirVerticesClosely) {
  for (const std::uint64_t seed : {832, 1326, 1476}) EXPECT_EQ(faults_of(seed), "") << "seed " << seed;
}

// Both cells have a ledge on their border, and each is higher at one end.
TEST(GroundBorders, HaveOneVerticalFaceWhereLedgesCross) { EXPECT_EQ(faults_of(297), ""); }

// A wall a tenth of a metre wide and 2 m high, with borders a few grid steps apart.
TEST(GroundBorders, BesideACliffAFewStepsWideDoNotFillTheGrid) {
  const MadeBorderMap map = made_border_map(25545);
  const Tolerances tolerances = tolerances_of(25545);
  EXPECT_EQ(faults_of(25545), "");
  EXPECT_LT(ground_of(map, map.second, tolerances.second_m, tolerances.between_m()).mesh.triangles.size(), 20'000u);
}

}  // namespace
}  // namespace citykiln::bake
