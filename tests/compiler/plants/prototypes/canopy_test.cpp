#include "compiler/plants/prototypes/canopy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compiler/plants/generate.h"
#include "tests/compiler/plants/made_surfaces.h"

namespace citykiln::plants {
namespace {

using ground::LandCoverPolygon;
using map::LandCoverClass;

constexpr double kTolerance_m = 12.5;
constexpr std::uint64_t kSeed = 7;
const climate::ClimateField kClimate = climate::uniform_climate(climate::ClimateClass::kCfb);

Wood wood(std::int64_t id, PlantCommunity mix, std::uint16_t trees_per_ha) {
  return {{{OsmType::kWay, id}, 0}, species_mix_of(mix), trees_per_ha, 16};
}

// Two dense woods and a park with a road, a path, a lake and a house, on an uneven slope.
struct WoodedSlope {
  std::vector<LandCoverPolygon> surfaces = {surface(1, LandCoverClass::kForest, block(-500, -500, 0, 500)),
                                            surface(2, LandCoverClass::kBroadLeavedForest, block(0, -500, 500, 300)),
                                            surface(3, LandCoverClass::kPark, block(0, 300, 500, 500)),
                                            surface(4, LandCoverClass::kResidentialRoad, block(-500, -203, 500, -197)),
                                            surface(5, LandCoverClass::kLake, block(-340, 40, -260, 110)),
                                            surface(6, LandCoverClass::kBuilding, block(-100, 50, -80, 70)),
                                            surface(7, LandCoverClass::kFootPath, block(-500, 200, 500, 201))};
  std::vector<Wood> woods = {wood(1, PlantCommunity::kMixedWood, 120), wood(2, PlantCommunity::kBroadWood, 105),
                             wood(3, PlantCommunity::kParkTrees, 22)};
  std::vector<PowerLineCorridor> corridors = {{{{OsmType::kWay, 8}, 0}, {{-500, 400}, {0, 400}}, 20}};
  ground::GradedTerrain ground{heights()};

  static map::Heightfield heights() {
    map::Heightfield field{{-768, -768}, {16, 16}, 97, 97, {}, 0};
    for (int j = 0; j < 97; ++j)
      for (int i = 0; i < 97; ++i)
        field.heights.push_back(static_cast<std::int32_t>((900 + 3 * i + 5 * (j % 7)) / map::kHeightQuantum_m));
    return field;
  }

  struct Made {
    Canopy canopy;
    PlacedPlants placed;
  };
  Made in(const Box2& box, double tolerance_m = kTolerance_m, Month month = kMidsummer) const {
    const ground::LandCoverIndex map = index_land_cover(surfaces, box.widened(kInfluenceRadius_m));
    const PlacingContext land{map, ground, box, kSeed, 42.5, kClimate};
    Report ignored;
    Made made{make_canopy(woods, corridors, land, tolerance_m, month),
              generate({{}, woods, {}, {}, corridors}, land, ignored).placed};
    return made;
  }
};

constexpr Box2 kWestOfSlope = {{-512, -512}, {0, 512}}, kEastOfSlope = {{0, -512}, {512, 512}},
               kWholeSlope = {{-512, -512}, {512, 512}};

struct Vertex {
  Vec3 at, normal;
  materials::Tint tint;
  auto operator<=>(const Vertex&) const = default;
};

std::vector<Vertex> vertices_at(const Canopy& canopy, double x) {
  std::vector<Vertex> vertices;
  for (const auto& dressed : canopy.meshes)
    for (std::size_t i = 0; i < dressed.mesh.positions.size(); ++i)
      if (dressed.mesh.positions[i].x == x)
        vertices.push_back({dressed.mesh.positions[i], dressed.mesh.normals[i], dressed.tints[i]});
  std::ranges::sort(vertices, {}, &Vertex::at);
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

std::vector<Placement> all_placements(const PlacedPlants& placed) {
  std::vector<Placement> all;
  for (const auto& [prototype, some] : placed) all.insert(all.end(), some.begin(), some.end());
  return all;
}

// Heights of the canopy above a place.
std::vector<double> tops_over(const Canopy& canopy, Vec2 p) {
  std::vector<double> tops;
  for (const auto& dressed : canopy.meshes)
    for (const auto& [a, b, c] : dressed.mesh.triangles) {
      const Vec3 pa = dressed.mesh.positions[a], pb = dressed.mesh.positions[b], pc = dressed.mesh.positions[c];
      const double area = cross(in_plan(pb - pa), in_plan(pc - pa));
      const double v = cross(in_plan(pb) - p, in_plan(pc) - p) / area,
                   w = cross(in_plan(pc) - p, in_plan(pa) - p) / area;
      if (v >= 0 && w >= 0 && v + w <= 1) tops.push_back(v * pa.z + w * pb.z + (1 - v - w) * pc.z);
    }
  return tops;
}

// Where the canopy ends on the border, one tile may have a vertex on the ground that the other lacks.
TEST(Canopy, IsTheSameWhereTilesMeet) {
  const WoodedSlope scene;
  const auto west = vertices_at(scene.in(kWestOfSlope).canopy, 0), east = vertices_at(scene.in(kEastOfSlope).canopy, 0);
  const auto is_in_air = [&](const Vertex& v) { return v.at.z > land_m(scene.ground, in_plan(v.at)); };
  for (const auto& [one, other] : {std::pair{west, east}, {east, west}})
    for (const Vertex& vertex : one) {
      const auto same = std::ranges::find(other, in_plan(vertex.at), [](const Vertex& v) { return in_plan(v.at); });
      ASSERT_TRUE(same != other.end() || !is_in_air(vertex)) << vertex.at.y;
      EXPECT_TRUE(same == other.end() || *same == vertex) << vertex.at.y;
    }
  EXPECT_GT(std::ranges::count_if(west, is_in_air), 30);
}

TEST(Canopy, ReplacesTheTreesItRemovesAndNoOthers) {
  WoodedSlope::Made made = WoodedSlope{}.in(kWholeSlope);
  const std::vector<Placement> before = all_placements(made.placed);
  remove_trees_below(made.canopy, WoodedSlope{}.woods, made.placed);
  const std::vector<Placement> left = all_placements(made.placed);
  EXPECT_LT(left.size(), before.size() / 2);
  EXPECT_GT(left.size(), before.size() / 20);
  double worst_m = 0;
  for (const Placement& tree : before) {
    if (std::ranges::any_of(left, [&](const Placement& p) { return p.at == tree.at; })) continue;
    const std::vector<double> tops = tops_over(made.canopy, in_plan(tree.at));
    ASSERT_FALSE(tops.empty());
    worst_m = std::max({worst_m, std::abs(tops[0] - tree.at.z - tree.scale), tree.scale / 2});
  }
  EXPECT_NEAR(made.canopy.error_m, worst_m, 1e-6);
  EXPECT_LT(made.canopy.error_m, 1.5 * kTolerance_m);
}

TEST(Canopy, KeepsMappedTrees) {
  WoodedSlope::Made made = WoodedSlope{}.in(kWholeSlope);
  const Placement mapped{{200, 0, 900}, 1, 0, 30, {OsmType::kNode, 9}};
  PlacedPlants placed = {{{Species::kOak, 0}, {mapped}}};
  remove_trees_below(made.canopy, WoodedSlope{}.woods, placed);
  EXPECT_EQ(all_placements(placed).size(), 1u);
}

TEST(Canopy, CoversNeitherRoadsNorHousesNorWaterNorCorridorsNorParks) {
  const Canopy canopy = WoodedSlope{}.in(kWholeSlope).canopy;
  const Box2 free[] = {{{-490, -203}, {490, -197}},
                       {{-340, 40}, {-260, 110}},
                       {{-100, 50}, {-80, 70}},
                       {{-490, 390}, {-10, 410}},
                       {{10, 305}, {490, 490}}};
  for (const Box2& box : free)
    for (double x = box.min.x; x <= box.max.x; x += 7)
      for (double y = box.min.y; y <= box.max.y; y += 3)
        EXPECT_TRUE(tops_over(canopy, {x, y}).empty()) << x << " " << y;
  EXPECT_FALSE(tops_over(canopy, {-200, 200.5}).empty());  // a path is covered
}

TEST(Canopy, FacesUpAndIsAHeightField) {
  const Canopy canopy = WoodedSlope{}.in(kWholeSlope).canopy;
  ASSERT_GE(canopy.meshes.size(), 2u);
  for (const auto& dressed : canopy.meshes) {
    EXPECT_TRUE(dressed.feature == (OsmId{OsmType::kWay, 1}) || dressed.feature == (OsmId{OsmType::kWay, 2}));
    for (const auto& [a, b, c] : dressed.mesh.triangles) {
      const auto& p = dressed.mesh.positions;
      EXPECT_GT(cross(in_plan(p[b] - p[a]), in_plan(p[c] - p[a])), 0);
    }
    for (const Vec3 normal : dressed.mesh.normals) EXPECT_GT(normal.z, 0.4);
  }
  for (double x = -490.3; x < 490; x += 37)
    for (double y = -490.7; y < 490; y += 41) EXPECT_LE(tops_over(canopy, {x, y}).size(), 1u);
}

TEST(Canopy, IsEmptyAtFineLevelsAndForLowWoods) {
  EXPECT_TRUE(WoodedSlope{}.in(kWholeSlope, 0.39).canopy.meshes.empty());
  WoodedSlope low;
  for (Wood& wood : low.woods) wood.height_m = 2;
  EXPECT_TRUE(low.in(kWholeSlope).canopy.meshes.empty());
}

TEST(Canopy, HasNarrowerCellsAtFinerLevelsAndCoversMoreOfTheWood) {
  EXPECT_EQ(canopy_cell_m(0.5), 2);
  EXPECT_EQ(canopy_cell_m(1.2), 4);
  EXPECT_EQ(canopy_cell_m(2.5), 8);
  EXPECT_EQ(canopy_cell_m(12.5), 16);
  std::size_t left_before = 0;
  for (const double tolerance_m : {1.2, 2.5, 12.5}) {
    WoodedSlope::Made made = WoodedSlope{}.in(kWholeSlope, tolerance_m);
    remove_trees_below(made.canopy, WoodedSlope{}.woods, made.placed);
    const std::size_t left = all_placements(made.placed).size();
    EXPECT_GT(left, left_before) << tolerance_m;
    left_before = left;
  }
}

TEST(Canopy, RisesAndFallsWithCrowns) {
  const Canopy canopy = WoodedSlope{}.in(kWholeSlope, 0.5).canopy;
  double low_m = 1e9, high_m = -1e9;
  for (double x = -250.4; x < -230; x += 1.1) {
    const std::vector<double> tops = tops_over(canopy, {x, -300.3});
    ASSERT_EQ(tops.size(), 1u);
    const double above_m = tops[0] - land_m(WoodedSlope{}.ground, {x, -300.3});
    low_m = std::min(low_m, above_m), high_m = std::max(high_m, above_m);
  }
  EXPECT_GT(low_m, 3);
  EXPECT_GT(high_m - low_m, 2);
}

TEST(Canopy, HasSeasonalColours) {
  const auto redness = [](const Canopy& canopy) {
    double red = 0, green = 0;
    for (const auto& dressed : canopy.meshes)
      for (const materials::Tint tint : dressed.tints) red += tint[0], green += tint[1];
    return red / green;
  };
  EXPECT_GT(redness(WoodedSlope{}.in(kWholeSlope, kTolerance_m, Month{10}).canopy),
            1.3 * redness(WoodedSlope{}.in(kWholeSlope).canopy));
}

}  // namespace
}  // namespace citykiln::plants
