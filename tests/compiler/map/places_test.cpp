#include "compiler/map/places.h"

#include <gtest/gtest.h>

namespace citykiln::map {
namespace {

constexpr OsmId kNode{OsmType::kNode, 1}, kWay{OsmType::kWay, 2}, kArea{OsmType::kRelation, 3},
    kRoute{OsmType::kRelation, 4}, kUnknown{OsmType::kWay, 99};

LonLat place_of_e7(std::int32_t lon_e7, std::int32_t lat_e7) {
  const source::Location place{lon_e7, lat_e7};
  return {place.lon_deg(), place.lat_deg()};
}

source::OsmData made_data() {
  source::OsmData osm;
  osm.nodes = {{1, {10'000'000, 20'000'000}, {}}};
  osm.way_nodes = {{5, {0, 0}}, {6, {30'000'000, 40'000'000}}, {7, {90'000'000, 0}}};
  osm.ways = {{2, {0, 3}, {}}};
  osm.ring_points = {{0, 0}, {20'000'000, 0}, {20'000'000, 10'000'000}, {0, 10'000'000}};
  osm.rings = {{{0, 4}, 0, true}};
  osm.areas = {{kArea, {0, 1}, {}}};
  osm.members = {{kUnknown, 0}, {kWay, 0}};
  osm.relations = {{3, {0, 0}, {}}, {4, {0, 2}, {}}};
  return osm;
}

TEST(Places, AreThoseOfTheElementsThatDiagnosesName) {
  Report report;
  for (const OsmId id : {kNode, kWay, kArea, kRoute, kUnknown, OsmId{}}) report.add(Code::kUnknownKind, id);
  const Places places = places_of(made_data(), report);
  const LonLat middle = place_of_e7(30'000'000, 40'000'000);
  EXPECT_EQ(places, (Places{{kNode, place_of_e7(10'000'000, 20'000'000)},
                            {kWay, middle},
                            {kArea, place_of_e7(10'000'000, 5'000'000)},
                            {kRoute, middle}}));
}

TEST(Places, DiagnosesOfElementsOutsideTheExtentAreRemoved) {
  // all nodes lie south of 5 degrees north; nothing is known of the last way
  const Plane plane({20, 10});
  const Box2 extent{{-1000, -1000}, {1000, 1000}};
  Report report;
  for (const OsmId id : {kNode, kWay, kRoute, kUnknown, OsmId{}}) report.add(Code::kNoBuildingHeight, id);
  report.add(Code::kOutsideBounds, kUnknown);
  remove_diagnoses_outside(made_data(), plane, extent, report);
  std::vector<OsmId> kept;
  for (const Diagnosis& diagnosis : report.diagnoses()) kept.push_back(diagnosis.object);
  EXPECT_EQ(kept, (std::vector<OsmId>{kUnknown, OsmId{}}));
}

TEST(Places, OfNoDiagnosesAreNone) { EXPECT_TRUE(places_of(made_data(), {}).empty()); }

}  // namespace
}  // namespace citykiln::map
