// Bytes of the manifest per building: of its recipe, packed with those of its neighbours, without rule files and
// ground.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <map>

#include "compiler/buildings/meshes/mass_model.h"
#include "compiler/buildings/meshes/rule_attributes.h"
#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/buildings/building_classes.h"
#include "exporters/kiln/manifest.h"
#include "grammars/derivation/derive.h"
#include "grammars/derivation/form_roofs.h"
#include "tests/compiler/buildings/real_buildings.h"
#include "tests/test_files.h"

namespace citykiln::exporters {
namespace {

using buildings::Building;

scene::Scene scene_of(const std::vector<Building>& all) {
  scene::Scene scene;
  std::map<scene::TileKey, scene::Chunk> chunks;
  const auto tile_at = [&](double m) { return static_cast<std::int32_t>(std::floor(m / scene.header.tile_m)); };
  for (const Building& building : all) {
    const Vec2 anchor = building.footprint.outer.front();
    scene.header.extent.grow(anchor);
    const scene::TileKey tile{tile_at(anchor.x), tile_at(anchor.y)};
    chunks[tile].tile = tile;
    chunks[tile].buildings.push_back(building);
  }
  for (auto& [tile, chunk] : chunks) {
    chunk.heights = {{}, {64, 64}, 2, 2, std::vector<std::int32_t>(4), 0};
    scene.chunks.push_back(std::move(chunk));
  }
  return scene;
}

// The bytes that buildings add to chunks without any.
std::size_t bytes_of_buildings(const std::vector<Building>& all) {
  scene::Scene scene = scene_of(all);
  const std::size_t whole = encode_manifest(scene, 1).size();
  for (scene::Chunk& chunk : scene.chunks) chunk.buildings.clear();
  return whole - encode_manifest(scene, 1).size();
}

TEST(RecipeBytesReal, OfChicagosBuildingsAreUnder150Each) {
  const std::string chicago = "chicago-loop/chicago_loop.osm.pbf";
  if (!std::filesystem::exists(real_data(chicago))) GTEST_SKIP() << "absent: " << chicago;
  const std::vector<Building> all = buildings::buildings_in(chicago);
  const std::size_t bytes = bytes_of_buildings(all);
  std::printf("%zu buildings, %zu bytes: %.1f each\n", all.size(), bytes,
              static_cast<double>(bytes) / static_cast<double>(all.size()));
  EXPECT_GE(all.size(), 1573u);
  EXPECT_LT(bytes, 150 * all.size());
}

// ---- a made-up town

// A house of a row that runs along a street, no two of one size.
map::Footprint house(std::int64_t id, double& x, double y, const RandomSequence& dice) {
  const auto at = [&](std::uint32_t index) { return 8 * static_cast<std::uint32_t>(id) + index; };
  const double width_m = snapped_to(0x1p-7, dice.between(22, 32, at(0)));
  const double depth_m = snapped_to(0x1p-7, dice.between(16, 20, at(1)));
  const double bend_m = snapped_to(0x1p-7, dice.between(-0.4, 0.4, at(2)));
  map::Footprint f;
  f.id = {{OsmType::kWay, id}, 0};
  f.polygon.outer = {{x, y}, {x + width_m, y}, {x + width_m, y + depth_m}, {x, y + depth_m + bend_m}};
  f.building_class = static_cast<std::uint8_t>(map::BuildingClass::kApartments);
  f.levels = 4 + dice.below(4, at(3));
  f.height_m = f.levels * 3.1;
  x += width_m;
  return f;
}

// Streets of rows, back to back, in blocks of eight houses.
std::vector<Building> town(int rows, int houses_in_row) {
  const RandomSequence dice(1, StableId{1}, "town");
  map::Features features;
  features.extent = {{-0x1p16, -0x1p16}, {0x1p16, 0x1p16}};
  std::int64_t id = 1'000'000;
  for (int row = 0; row < rows; ++row) {
    double x = 0;
    for (int i = 0; i < houses_in_row; ++i) {
      if (i % 8 == 0) x += 15;
      features.footprints.push_back(house(id++, x, row * 48.0, dice));
    }
    map::Track street;
    street.axis = {{0, row * 48.0 - 9}, {x, row * 48.0 - 9}};
    street.surface = map::LandCoverClass::kResidentialRoad;
    features.tracks.push_back(street);
  }
  Report report;
  map::Heightfield level{{-64, -64}, {64, 64}, 3, 3, std::vector<std::int32_t>(9), 0};
  return buildings::plan(features, ground::GradedTerrain(std::move(level)), report);
}

// A window is a niche in a wall: four reveals.
std::size_t windows_of(const Building& building, const buildings::Rulebook& rulebook) {
  const auto program = rulebook.find(building.style);
  if (program == rulebook.end()) return 0;
  Report report;
  const buildings::MassModel mass = mass_model_of(building, 0.01, report);
  grammars::DeriveOptions options;
  options.attributes = rule_attributes_of(building, mass.roof.form);
  options.tolerance_m = 0.05, options.roofs = grammars::form_roofs(0.01);
  const grammars::Derivation derivation = derive(program->second, shape_of(building, mass), options);
  std::size_t reveals = 0;
  for (const grammars::Terminal& terminal : derivation.terminals)
    reveals += terminal.name == "Reveal" && path_name(derivation, terminal.path).find("/Window/") != std::string::npos;
  return reveals / 4;
}

// The number of windows is that of a data set of Belgrade's facades.
TEST(RecipeBytes, Of195431WindowsAreUnderAMegabyte) {
  const std::vector<Building> all = town(47, 40);
  const buildings::Rulebook rulebook = buildings::parse_rulebook(buildings::shipped_rules());
  std::size_t windows = 0;
  for (const Building& building : all) windows += windows_of(building, rulebook);
  const std::size_t bytes = bytes_of_buildings(all);
  std::printf("%zu buildings with %zu windows, %zu bytes\n", all.size(), windows, bytes);
  EXPECT_GE(windows, 195'431u);
  EXPECT_LT(bytes, 1'000'000u);
}

}  // namespace
}  // namespace citykiln::exporters
