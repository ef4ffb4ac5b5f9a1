#include "compiler/verify/standing/measure_trunks.h"

#include <gtest/gtest.h>

namespace citykiln::verify {
namespace {

ground::LandCoverPolygon surface(std::int64_t id, map::LandCoverClass kind, Ring ring) {
  return {{{OsmType::kWay, id}, 0}, kind, 9, {std::move(ring)}};
}

bake::InstancedMesh non_ground(const char* name, std::vector<bake::Float3> at) {
  bake::InstancedMesh instanced;
  instanced.name = name;
  instanced.features.assign(at.size(), 0);
  instanced.translations = std::move(at);
  return instanced;
}

TEST(MeasureTrunks, CountsThoseInRoadsRailsBuildingsAndWater) {
  const std::vector<ground::LandCoverPolygon> surfaces = {
      surface(1, map::LandCoverClass::kForest, {{0, 0}, {100, 0}, {100, 100}, {0, 100}}),
      surface(2, map::LandCoverClass::kResidentialRoad, {{0, 10}, {100, 10}, {100, 16}, {0, 16}}),
      surface(3, map::LandCoverClass::kLake, {{50, 50}, {80, 50}, {80, 80}, {50, 80}}),
      surface(4, map::LandCoverClass::kBuilding, {{10, 50}, {20, 50}, {20, 60}, {10, 60}}),
      surface(5, map::LandCoverClass::kPavement, {{0, 16}, {100, 16}, {100, 19}, {0, 19}})};
  const ground::LandCoverIndex map = ground::index_land_cover(surfaces, {{0, 0}, {128, 128}});
  bake::BakedTile tile;
  tile.origin = {0, 0, 500};
  tile.features = {{OsmType::kWay, 1}};
  // plane x and y, as meshes of tiles have them
  tile.instanced = {non_ground("oak_3", {{5, 5, 0}, {5, 12, 0}, {5, 17, 0}}),
                    non_ground("fir_0", {{60, 60, 1}, {15, 55, 2}}), non_ground("hedge_1", {{5, 13, 0}}),
                    non_ground("wheat_1", {{5, 13, 0}}), non_ground("ArmLamp", {{5, 13, 0}})};
  const Trunks trunks = measure_trunks(tile, map);
  EXPECT_EQ(trunks.tested, 5u);
  EXPECT_EQ(trunks.conflicts, 3u);
  EXPECT_EQ(trunks.at, (Vec2{5, 12}));
}

}  // namespace
}  // namespace citykiln::verify
