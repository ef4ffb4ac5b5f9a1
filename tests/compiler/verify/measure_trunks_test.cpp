#include "compiler/verify/measure_trunks.h"

#include <gtest/gtest.h>

namespace citykiln::verify {
namespace {

ground::Surface surface(std::int64_t id, map::SurfaceClass kind, Ring ring) {
  return {{{OsmType::kWay, id}, 0}, kind, 9, {std::move(ring)}};
}

bake::Instanced standing(const char* name, std::vector<bake::Float3> at) {
  bake::Instanced instanced;
  instanced.name = name;
  instanced.features.assign(at.size(), 0);
  instanced.translations = std::move(at);
  return instanced;
}

TEST(MeasureTrunks, CountsThoseInRoadsRailsBuildingsAndWater) {
  const std::vector<ground::Surface> surfaces = {
      surface(1, map::SurfaceClass::kForest, {{0, 0}, {100, 0}, {100, 100}, {0, 100}}),
      surface(2, map::SurfaceClass::kResidentialRoad, {{0, 10}, {100, 10}, {100, 16}, {0, 16}}),
      surface(3, map::SurfaceClass::kLake, {{50, 50}, {80, 50}, {80, 80}, {50, 80}}),
      surface(4, map::SurfaceClass::kBuilding, {{10, 50}, {20, 50}, {20, 60}, {10, 60}}),
      surface(5, map::SurfaceClass::kPavement, {{0, 16}, {100, 16}, {100, 19}, {0, 19}})};
  const ground::SurfaceMap map = ground::map_surfaces(surfaces, {{0, 0}, {128, 128}});
  bake::BakedTile tile;
  tile.origin = {0, 0, 500};
  tile.features = {{OsmType::kWay, 1}};
  // plane x and y, as meshes of tiles have them
  tile.instanced = {standing("oak_3", {{5, 5, 0}, {5, 12, 0}, {5, 17, 0}}),
                    standing("fir_0", {{60, 60, 1}, {15, 55, 2}}), standing("hedge_1", {{5, 13, 0}}),
                    standing("wheat_1", {{5, 13, 0}}), standing("ArmLamp", {{5, 13, 0}})};
  const Trunks trunks = measure_trunks(tile, map);
  EXPECT_EQ(trunks.trees, 5u);
  EXPECT_EQ(trunks.misplaced, 3u);
  EXPECT_EQ(trunks.at, (Vec2{5, 12}));
}

}  // namespace
}  // namespace citykiln::verify
