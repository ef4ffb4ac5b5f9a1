#include <algorithm>
#include <set>
#include <tuple>

#include "compiler/plants/generate.h"
#include "compiler/scene/graded_terrain.h"
#include "compiler/scene/land_cover.h"
#include "tests/compiler/real_scenes.h"
#include "tests/test_files.h"

namespace citykiln {
namespace {

using map::LandCoverGroup;
using plants::Species;

constexpr Extract kPlantExtracts[] = {{"berlin/berlin-siegessaeule.osm.gz", "berlin/N52E013.hgt"},
                                      {"helsinki/Helsinki.osm.pbf"},
                                      {"monaco/monaco-2023.osm.pbf", "monaco/N43E007.hgt"},
                                      {"andorra/cut-canillo-village.osm.pbf", "andorra/N42E001.hgt"}};

// A plant without its tile.
struct Plant {
  Vec2 at;
  Species species{};
  std::uint8_t variant = 0;
  double height_m = 0;
  auto operator<=>(const Plant& o) const {
    return std::tuple(at, species, variant, height_m) <=> std::tuple(o.at, o.species, o.variant, o.height_m);
  }
  bool operator==(const Plant&) const = default;
};

std::vector<Plant> plants_of(const scene::Scene& scene, const scene::Chunk& chunk) {
  const Box2 box = scene::box_of(scene.header, chunk.tile);
  const auto surfaces = scene::coarse_land_cover(chunk);
  const auto map = ground::index_land_cover(surfaces, box.widened(scene::kHalo_m));
  const ground::GradedTerrain graded = scene::graded_terrain_of(scene.header, chunk, 0.5);
  Report ignored;
  std::vector<Plant> plants;
  const plants::PlacingContext land{
      map, graded, box, scene.header.seed, scene.header.origin.lat_deg, scene.header.climate};
  const plants::GeneratedPlants generated =
      plants::generate({chunk.trees, chunk.woods, chunk.plantings, chunk.tree_rows, chunk.corridors}, land, ignored);
  for (const auto& [prototype, placements] : generated.placed)
    for (const Placement& p : placements)
      plants.push_back({in_plan(p.at), prototype.species, prototype.variant, p.scale});
  return plants;
}

std::vector<Plant> plants_of(const scene::Scene& scene) {
  std::vector<Plant> all;
  for (const scene::Chunk& chunk : scene.chunks) {
    const std::vector<Plant> here = plants_of(scene, chunk);
    all.insert(all.end(), here.begin(), here.end());
  }
  std::ranges::sort(all);
  return all;
}

TEST(PlantsReal, StandInNoRoadRailBuildingOrWater) {
  if (!std::filesystem::exists(real_data())) GTEST_SKIP() << "no data";
  for (const Extract& extract : kPlantExtracts) {
    const scene::Scene scene = scene_of(extract, 512);
    std::size_t count = 0;
    for (const scene::Chunk& chunk : scene.chunks) {
      const auto surfaces = scene::coarse_land_cover(chunk);
      const auto boxes = boxes_of(surfaces);
      for (const Plant& plant : plants_of(scene, chunk)) {
        const ground::LandCoverPolygon* top = top_at(surfaces, boxes, plant.at);
        ++count;
        if (!top) continue;
        // trees may stand in pedestrian streets
        const LandCoverGroup group = map::values_of(top->surface).group;
        const bool is_road = group == LandCoverGroup::kRoad && top->surface != map::LandCoverClass::kPedestrianStreet;
        EXPECT_FALSE(is_road || group == LandCoverGroup::kRail || group == LandCoverGroup::kWater ||
                     group == LandCoverGroup::kBuilding)
            << extract.map << " " << plant.at.x << ", " << plant.at.y << " in " << map::values_of(top->surface).name;
      }
    }
    EXPECT_GT(count, 400u) << extract.map;
  }
}

TEST(PlantsReal, DoNotDependOnTiles) {
  if (!std::filesystem::exists(real_data())) GTEST_SKIP() << "no data";
  for (const Extract& extract : kPlantExtracts) {
    const std::vector<Plant> large = plants_of(scene_of(extract, 1024)), small = plants_of(scene_of(extract, 256));
    EXPECT_FALSE(large.empty()) << extract.map;
    std::vector<Plant> differing;
    std::ranges::set_symmetric_difference(large, small, std::back_inserter(differing));
    EXPECT_TRUE(differing.empty()) << extract.map << ": " << differing.size() << " of " << large.size() << ", one at "
                                   << differing.front().at.x << ", " << differing.front().at.y;
  }
}

// Canillo's woods climb from 1450 to 2200 m.
TEST(PlantsReal, OfCanilloAreOfManySpeciesAndMostlyConifers) {
  if (!std::filesystem::exists(real_data())) GTEST_SKIP() << "no data";
  const std::vector<Plant> plants = plants_of(scene_of(kPlantExtracts[3], 1024));
  std::set<Species> species;
  double needles = 0;
  for (const Plant& plant : plants) {
    species.insert(plant.species);
    needles += plants::values_of(plant.species).leaf_form == plants::LeafForm::kNeedle ? 1 : 0;
  }
  EXPECT_GE(species.size(), 10u);
  EXPECT_GT(needles / static_cast<double>(plants.size()), 0.5);
}

}  // namespace
}  // namespace citykiln
