#include "compiler/map/bridge_areas.h"

#include <gtest/gtest.h>

#include "compiler/contract/derived_id.h"
#include "tests/compiler/map/map_text.h"

namespace citykiln::map {
namespace {

const std::string kSquare = "a9 -20:-8 20:-8 20:0 20:8 -20:8 -20:0 highway=pedestrian area=yes bridge=yes layer=1\n";
const std::string kOutline = "a9 -20:-8 20:-8 20:8 -20:8 man_made=bridge layer=1\n";

const Track& track_with(const Features& features, ObjectId id) {
  static const Track none{};
  for (const Track& track : features.tracks)
    if (track.id == id) return track;
  ADD_FAILURE() << "no track " << id.osm.id << " part " << id.part;
  return none;
}

TEST(BridgeAreas, APedestrianAreaOnABridgeIsADeckAndNoGround) {
  const Features features = features_of(kSquare);
  EXPECT_TRUE(features.areas.empty());
  ASSERT_EQ(features.bridge_areas.size(), 1u);
  EXPECT_EQ(features.bridge_areas[0].surface, LandCoverClass::kSquare);
  EXPECT_EQ(features.bridge_areas[0].layer, 1);
  EXPECT_EQ(features.bridge_areas[0].tracks.size(), 1u);
}

TEST(BridgeAreas, ItsAxisJoinsTheNodesWherePathsMeetTheOutline) {
  const Features features = features_of(kSquare + "w1 -60:0 -20:0 highway=footway\nw2 20:0 60:0 highway=footway\n");
  const Track& axis = track_with(features, {{OsmType::kWay, 9}, kFirstDerivedPart});
  EXPECT_EQ(axis.passage, Passage::kBridge);
  ASSERT_EQ(axis.axis.size(), 2u);
  EXPECT_NEAR(length_m(axis.axis), 40, 0.1);
  const Track& path = track_with(features, {{OsmType::kWay, 1}, 0});
  EXPECT_TRUE(axis.node_ids.front() == path.node_ids.back() || axis.node_ids.back() == path.node_ids.back());
  EXPECT_EQ(values_of(axis.surface).group, LandCoverGroup::kPath);
}

TEST(BridgeAreas, AThirdPathHasABranch) {
  const Features features = features_of(kSquare +
                                        "w1 -60:0 -20:0 highway=footway\nw2 20:0 60:0 highway=footway\n"
                                        "w3 20:8 20:40 highway=steps\nw4 -20:8 -20:40 highway=steps\n");
  ASSERT_EQ(features.bridge_areas.size(), 1u);
  EXPECT_EQ(features.bridge_areas[0].tracks.size(), 3u);
}

TEST(BridgeAreas, AnOutlineCarriesTheBridgesThatRunOnIt) {
  const Features features = features_of(kOutline +
                                        "w1 -20:-4 20:-4 highway=residential bridge=yes layer=1\n"
                                        "w2 -20:4 20:4 highway=footway bridge=yes layer=1\n"
                                        "w3 -20:0 20:0 railway=rail bridge=yes layer=2\n"
                                        "w4 0:-50 0:50 highway=primary\n");
  ASSERT_EQ(features.bridge_areas.size(), 1u);
  const std::vector<ObjectId> carried = {{{OsmType::kWay, 1}, 0}, {{OsmType::kWay, 2}, 0}};
  EXPECT_EQ(features.bridge_areas[0].tracks, carried);
  EXPECT_EQ(features.bridge_areas[0].surface, LandCoverClass::kUnknown);
}

TEST(BridgeAreas, ASurfaceInAnOutlineBelongsToIt) {
  const Features features = features_of(kOutline +
                                        "a8 -20:-8 20:-8 20:8 -20:8 place=square bridge=yes layer=1\n"
                                        "w1 -20:-4 20:-4 highway=footway bridge=yes layer=1\n");
  ASSERT_EQ(features.bridge_areas.size(), 1u);
  EXPECT_EQ(features.bridge_areas[0].id.osm.id, 9);
  EXPECT_EQ(features.bridge_areas[0].surface, LandCoverClass::kSquare);
}

TEST(BridgeAreas, AnOutlineOverUntaggedWaysIsLeftOut) {
  const Features features = features_of(
      "a9 -20:-8 20:-8 20:8 -20:8 man_made=bridge\n"
      "w1 -22:0 22:0 highway=residential\n");
  EXPECT_TRUE(features.bridge_areas.empty());
  EXPECT_EQ(features.tracks.size(), 1u);
}

TEST(BridgeAreas, LakesAndWoodsAreNoDecks) {
  EXPECT_TRUE(features_of("a9 -20:-8 20:-8 20:8 -20:8 natural=water bridge=yes\n").bridge_areas.empty());
}

TEST(BridgeAreas, AnAreaWhoseWaysMeetItCloseToEachOtherHasADeck) {
  const Features features = features_of(
      "a1 0:0 1:0 20:0 20:10 0:10 highway=pedestrian area=yes bridge=yes layer=1\n"
      "w2 0:-30 0:0 highway=footway\n"
      "w3 1:-30 1:0 highway=footway");
  ASSERT_EQ(features.bridge_areas.size(), 1u);
  EXPECT_FALSE(features.bridge_areas[0].tracks.empty());
}

}  // namespace
}  // namespace citykiln::map
