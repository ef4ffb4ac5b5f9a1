#include <algorithm>
#include <tuple>

#include "compiler/props/street_lamps.h"
#include "compiler/scene/land_cover.h"
#include "tests/compiler/real_scenes.h"
#include "tests/test_files.h"

namespace citykiln {
namespace {

using map::LandCoverGroup;
using props::StreetLamp;

constexpr Extract kLampExtracts[] = {{"berlin/berlin-neukolln.osm"},
                                     {"helsinki/Helsinki.osm.pbf"},
                                     {"monaco/monaco-2023.osm.pbf"},
                                     {"berlin/berlin-reinickendorf-2026.osm.pbf"}};

std::vector<StreetLamp> lamps_of(const scene::Scene& scene, const scene::Chunk& chunk,
                                 std::span<const props::Lamp> mapped) {
  const Box2 box = scene::box_of(scene.header, chunk.tile);
  const auto surfaces = scene::coarse_land_cover(chunk);
  return props::lamps_of_streets(chunk.roads, mapped, ground::index_land_cover(surfaces, box.widened(scene::kHalo_m)),
                                 box);
}

// Whether it is no place for a lamp.
bool is_taken(const ground::LandCoverPolygon* top) {
  if (!top) return false;
  const LandCoverGroup group = map::values_of(top->surface).group;
  return group == LandCoverGroup::kRoad || group == LandCoverGroup::kRail || group == LandCoverGroup::kWater ||
         group == LandCoverGroup::kBuilding;
}

// From the lamp to the nearest place on the axis of the way it lights.
Vec2 towards_its_way(std::span<const roads::Road> roads, const StreetLamp& lamp) {
  Vec2 nearest{1e9, 0};
  for (const roads::Road& road : roads)
    for (std::size_t i = 0; road.id.osm == lamp.feature && i + 1 < road.axis.size(); ++i) {
      const Vec2 from = road.axis[i] - lamp.at, along = road.axis[i + 1] - road.axis[i];
      const Vec2 to = from + along * std::clamp(-dot(from, along) / dot(along, along), 0.0, 1.0);
      if (length(to) < length(nearest)) nearest = to;
    }
  return nearest;
}

TEST(StreetLampsReal, StandBesideCarriagewaysAndFaceThem) {
  if (!std::filesystem::exists(real_data())) GTEST_SKIP();
  for (const Extract& extract : kLampExtracts) {
    const scene::Scene scene = scene_of(extract, 1024);
    std::size_t count = 0, averted = 0;
    for (const scene::Chunk& chunk : scene.chunks) {
      const auto surfaces = scene::coarse_land_cover(chunk);
      const auto boxes = boxes_of(surfaces);
      for (const StreetLamp& lamp : lamps_of(scene, chunk, chunk.lamps)) {
        ++count;
        EXPECT_FALSE(is_taken(top_at(surfaces, boxes, lamp.at))) << to_string(lamp.feature);
        averted += dot(unit(towards_its_way(chunk.roads, lamp)), lamp.facing) <= 0.99;
      }
    }
    EXPECT_GT(count, 30u) << extract.map;
    // in a hairpin the other leg may be nearer than the one a lamp faces
    EXPECT_LE(averted * 33, count) << extract.map;
    RecordProperty(std::filesystem::path(extract.map).stem().string(), static_cast<int>(count));
  }
}

std::vector<StreetLamp> sorted_lamps(const scene::Scene& scene) {
  std::vector<StreetLamp> all;
  for (const scene::Chunk& chunk : scene.chunks) {
    const auto here = lamps_of(scene, chunk, {});
    all.insert(all.end(), here.begin(), here.end());
  }
  std::ranges::sort(all, [](const StreetLamp& a, const StreetLamp& b) {
    return std::tie(a.feature, a.at, a.facing) < std::tie(b.feature, b.at, b.facing);
  });
  return all;
}

TEST(StreetLampsReal, DoNotDependOnTheTileSize) {
  if (!std::filesystem::exists(real_data())) GTEST_SKIP();
  for (const Extract& extract : kLampExtracts) {
    const auto large = sorted_lamps(scene_of(extract, 2048)), small = sorted_lamps(scene_of(extract, 256));
    EXPECT_FALSE(large.empty()) << extract.map;
    EXPECT_TRUE(large == small) << extract.map << ": " << large.size() << " and " << small.size();
  }
}

}  // namespace
}  // namespace citykiln
