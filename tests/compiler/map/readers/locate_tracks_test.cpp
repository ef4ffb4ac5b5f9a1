#include <gtest/gtest.h>

#include "compiler/contract/derived_id.h"
#include "tests/compiler/map/map_text.h"

namespace citykiln::map {
namespace {

Track track_of(const std::string& tags) {
  const Features features = features_of("w1 0:0 50:0 50:40 " + tags);
  EXPECT_EQ(features.tracks.size(), 1u) << tags;
  return features.tracks.empty() ? Track{} : features.tracks[0];
}

TEST(LocateTracks, TagsDecideClassAndWidth) {
  const struct {
    const char* tags;
    LandCoverClass surface;
    double width_m;
  } cases[] = {
      {"highway=motorway oneway=yes lanes=3", LandCoverClass::kMotorwayRoad, 11.25},
      {"highway=motorway oneway=yes", LandCoverClass::kMotorwayRoad, 7.5},
      {"highway=trunk_link oneway=yes", LandCoverClass::kMotorwayRoad, 4.5},
      {"highway=primary", LandCoverClass::kPrimaryRoad, 7},
      {"highway=primary width=8.5", LandCoverClass::kPrimaryRoad, 8.5},
      {"highway=secondary lanes=4", LandCoverClass::kSecondaryRoad, 13},
      {"highway=tertiary", LandCoverClass::kTertiaryRoad, 6},
      {"highway=residential", LandCoverClass::kResidentialRoad, 5.5},
      {"highway=residential oneway=yes", LandCoverClass::kResidentialRoad, 3.5},
      {"highway=residential oneway=yes lanes=2 width:lanes=3|", LandCoverClass::kResidentialRoad, 5.75},
      {"highway=living_street", LandCoverClass::kPedestrianStreet, 5},
      {"highway=service", LandCoverClass::kServiceRoad, 3.5},
      {"highway=service surface=gravel", LandCoverClass::kUnpavedRoad, 3.5},
      {"highway=track", LandCoverClass::kFarmTrack, 2.75},
      {"highway=track surface=asphalt", LandCoverClass::kServiceRoad, 2.75},
      {"highway=cycleway", LandCoverClass::kCyclePath, 2.5},
      {"highway=footway", LandCoverClass::kPavedFootPath, 2},
      {"highway=footway surface=gravel", LandCoverClass::kFootPath, 2},
      {"highway=path", LandCoverClass::kFootPath, 1.25},
      {"highway=steps width=64", LandCoverClass::kSteps, 64},  // Helsinki cathedral, w33085003
      {"railway=rail", LandCoverClass::kRailway, 4},
      {"railway=tram", LandCoverClass::kTram, 3},
      {"railway=funicular", LandCoverClass::kFunicular, 3},
      {"railway=narrow_gauge rack=riggenbach", LandCoverClass::kFunicular, 3},
      {"railway=narrow_gauge rack=no", LandCoverClass::kRailway, 3},
      {"aeroway=runway width=45", LandCoverClass::kRunway, 45},
  };
  for (const auto& c : cases) {
    const Track track = track_of(c.tags);
    EXPECT_EQ(values_of(track.surface).name, values_of(c.surface).name) << c.tags;
    EXPECT_EQ(carriageway_width_m(track.section), c.width_m) << c.tags;
  }
}

TEST(LocateTracks, PassageAndLayerComeFromTags) {
  EXPECT_EQ(track_of("highway=primary bridge=yes layer=1").passage, Passage::kBridge);
  EXPECT_EQ(track_of("highway=primary bridge=viaduct layer=2").layer, 2);
  EXPECT_EQ(track_of("highway=primary tunnel=yes layer=-1").passage, Passage::kTunnel);
  EXPECT_EQ(track_of("highway=primary tunnel=yes layer=-1").layer, -1);
  EXPECT_EQ(track_of("highway=footway level=-1").passage, Passage::kTunnel);
  EXPECT_EQ(track_of("highway=service tunnel=building_passage").passage, Passage::kGround);
  EXPECT_EQ(track_of("highway=primary bridge=no").passage, Passage::kGround);
  EXPECT_TRUE(track_of("railway=rail").is_rail);
  EXPECT_TRUE(track_of("highway=residential lit=yes").is_lit);
}

TEST(LocateTracks, WaysOnUpperStoreysAndInRoomsAreDropped) {
  Report report;
  const Features features = features_of(R"(
    w1 0:0 50:0 highway=footway level=1
    w2 0:5 50:5 highway=service level=2;3
    w3 0:10 50:10 highway=footway indoor=yes
    w4 0:15 50:15 highway=corridor level=0
    w5 0:20 50:20 highway=steps level=0;1
    w6 0:25 50:25 highway=footway level=1 bridge=yes layer=1
    w7 0:30 50:30 highway=footway layer=1)",
                                        report);
  std::vector<std::int64_t> ways;
  for (const Track& track : features.tracks) ways.push_back(track.id.osm.id);
  EXPECT_EQ(ways, (std::vector<std::int64_t>{5, 6, 7}));
  EXPECT_EQ(report.counts()[Code::kAboveGround], 2u);
  EXPECT_EQ(report.counts()[Code::kInsideBuilding], 2u);
  EXPECT_EQ(report.counts()[Code::kUnknownKind], 0u);
  EXPECT_TRUE(report.balances());
}

TEST(LocateTracks, AClosedRunwayIsItsOutlineAndAClosedTaxiwayALoop) {
  const Features features = features_of(R"(
    a1 0:0 300:0 300:40 0:40 aeroway=runway
    a2 0:100 300:100 300:140 0:140 aeroway=taxiway
    a3 0:200 300:200 300:220 0:220 aeroway=taxiway area=yes)");
  ASSERT_EQ(features.tracks.size(), 1u);
  EXPECT_EQ(features.tracks[0].id.osm.id, 2);
  ASSERT_EQ(features.areas.size(), 2u);
  EXPECT_EQ(features.areas[0].id.osm.id, 1);
  EXPECT_EQ(features.areas[1].id.osm.id, 3);
}

TEST(LocateTracks, APathThroughABuildingOnAnUpperStoreyIsACorridor) {
  EXPECT_EQ(track_of("highway=footway tunnel=building_passage").passage, Passage::kGround);
  EXPECT_EQ(track_of("highway=footway tunnel=building_passage layer=-1").passage, Passage::kGround);
  EXPECT_EQ(track_of("highway=footway tunnel=building_passage layer=1").passage, Passage::kTunnel);
  EXPECT_EQ(track_of("highway=footway tunnel=building_passage bridge=yes layer=1").passage, Passage::kBridge);
  EXPECT_EQ(track_of("highway=service tunnel=building_passage layer=1").passage, Passage::kGround);
  EXPECT_TRUE(track_of("highway=service tunnel=building_passage").is_through_building);
  EXPECT_TRUE(track_of("highway=footway covered=arcade").is_through_building);
  EXPECT_TRUE(track_of("highway=footway level=0").is_through_building);
  EXPECT_FALSE(track_of("highway=footway covered=no").is_through_building);
}

TEST(LocateTracks, LayersAndBridgesThatDisagreeAreDiagnosed) {
  const auto told = [](const std::string& tags) {
    Report report;
    features_of("w1 0:0 50:0 50:40 " + tags, report);
    std::vector<Code> codes;
    for (const Diagnosis& diagnosis : report.diagnoses()) codes.push_back(diagnosis.code);
    return codes;
  };
  using Codes = std::vector<Code>;
  EXPECT_EQ(told("highway=primary bridge=yes"), Codes{Code::kBridgeWithoutLayer});
  EXPECT_EQ(told("highway=primary layer=1"), Codes{Code::kLayerWithoutBridge});
  EXPECT_EQ(told("highway=primary layer=-2"), Codes{Code::kLayerWithoutBridge});
  EXPECT_EQ(told("highway=primary bridge=yes layer=1"), Codes{});
  EXPECT_EQ(told("highway=primary tunnel=yes"), Codes{Code::kTunnelWithoutLayer});
  EXPECT_EQ(told("highway=primary tunnel=yes layer=-1"), Codes{});
  EXPECT_EQ(told("highway=footway tunnel=yes"), Codes{});
  EXPECT_EQ(told("highway=primary"), Codes{});
}

TEST(LocateTracks, RoundaboutsAndLinksAreKnown) {
  EXPECT_TRUE(track_of("highway=primary junction=roundabout").is_roundabout);
  EXPECT_TRUE(track_of("highway=residential junction=circular").is_roundabout);
  EXPECT_FALSE(track_of("highway=primary junction=jughandle").is_roundabout);
  EXPECT_TRUE(track_of("highway=motorway_link").is_link);
  EXPECT_TRUE(track_of("highway=tertiary_link").is_link);
  EXPECT_FALSE(track_of("highway=tertiary").is_link);
}

TEST(LocateTracks, TheCrossSectionIsKeptWhole) {
  const Track track = track_of("highway=residential lanes=3 sidewalk=right cycleway:left=lane");
  EXPECT_EQ(to_string(track.section), "cddd|s vv-^|-");
  EXPECT_EQ(track.side, DrivingSide::kRight);
}

TEST(LocateTracks, BadValuesAreDiagnosedAndTheClassesValuesUsed) {
  for (const char* bad : {"width=wide", "width=-1", "width=0", "lanes=0", "lanes=many", "layer=top", "layer=99",
                          "oneway=maybe", "sidewalk=both sidewalk:both:width=wide"}) {
    Report report;
    const Features features = features_of(std::string("w1 0:0 50:0 highway=residential ") + bad, report);
    ASSERT_EQ(features.tracks.size(), 1u);
    EXPECT_EQ(carriageway_width_m(features.tracks[0].section), 5.5) << bad;
    EXPECT_EQ(features.tracks[0].layer, 0) << bad;
    EXPECT_EQ(report.counts()[Code::kBadTagValue], 1u) << bad;
  }
}

TEST(LocateTracks, ValuesOfAnyLengthAreReadOnce) {
  for (const std::string& bad : {std::string(10000, '|'), std::string(10000, 'x'), std::string(10000, ';') + "x"}) {
    Report report;
    const Features features =
        features_of("w1 0:0 50:0 highway=residential oneway=yes lanes=2 turn:lanes=through|" + bad, report);
    ASSERT_EQ(features.tracks.size(), 1u);
    EXPECT_EQ(to_string(features.tracks[0].section), "dd ^^");
    EXPECT_EQ(report.counts()[Code::kBadTagValue], 1u) << bad[0];
  }
}

TEST(LocateTracks, NodesStayAlignedWithThePoints) {
  // the second and third node lie in one place of the plane's grid
  const Features features = features_of("w1 0:0 10:0 10:0 20:0 20:9 highway=residential");
  ASSERT_EQ(features.tracks.size(), 1u);
  EXPECT_EQ(features.tracks[0].axis.size(), 4u);
  EXPECT_EQ(features.tracks[0].node_ids.size(), 4u);
  const Features crossing = features_of("w1 0:0 10:0 20:0 highway=residential\nw2 10:-9 10:0 10:9 highway=residential");
  EXPECT_EQ(crossing.tracks[0].node_ids[1], crossing.tracks[1].node_ids[1]);
  EXPECT_EQ(crossing.tracks[0].axis[1], crossing.tracks[1].axis[1]);
}

TEST(LocateTracks, WhatIsDroppedIsCounted) {
  Report report;
  const Features features = features_of(R"(
    w1 0:0 50:0 highway=residential
    w2 0:0 50:0 highway=unheard_of
    w3 9000:0 9050:0 highway=residential
    w4 7:7 7:7 highway=residential
    w5 0:0 50:0 name=nothing)",
                                        report);
  EXPECT_EQ(features.tracks.size(), 1u);
  const Account& account = report.account("map", "track");
  EXPECT_EQ(account.in, 3u);
  EXPECT_EQ(account.dropped.at(Code::kOutsideBounds), 1u);
  EXPECT_EQ(account.dropped.at(Code::kNoLength), 1u);
  EXPECT_TRUE(report.balances());
}

TEST(LocateTracks, PavementsLieWhereTagsSaySo) {
  const struct {
    const char* tags;
    double left_m, right_m;
  } cases[] = {
      {"", 0, 0},
      {"sidewalk=both", 2, 2},
      {"sidewalk=yes", 2, 2},
      {"sidewalk=left", 2, 0},
      {"sidewalk=right", 0, 2},
      {"sidewalk=no", 0, 0},
      {"sidewalk=separate", 0, 0},
      {"sidewalk:both=separate", 0, 0},
      {"sidewalk:left=yes sidewalk:right=no", 2, 0},
      {"sidewalk=both sidewalk:left=separate", 0, 2},
      {"sidewalk:both=yes sidewalk:right=no", 2, 0},
      {"sidewalk=both sidewalk:both:width=3.25", 3.25, 3.25},
      {"sidewalk=both sidewalk:left:width=1.5 sidewalk:right:width=4", 1.5, 4},
      {"sidewalk=both sidewalk:left:width=wide", 2, 2},
      {"sidewalk=both sidewalk:right:width=-3", 2, 2},
  };
  for (const auto& c : cases) {
    const Features features = features_of(std::string("w1 0:0 50:0 highway=residential ") + c.tags);
    ASSERT_EQ(features.tracks.size(), 1u) << c.tags;
    const std::vector<Lane>& lanes = features.tracks[0].section.lanes;
    EXPECT_EQ(lanes.front().is_raised ? lanes.front().width_m : 0, c.left_m) << c.tags;
    EXPECT_EQ(lanes.back().is_raised ? lanes.back().width_m : 0, c.right_m) << c.tags;
  }
}

TEST(LocateTracks, AWayThatIsRoadAndTramwayHasRailsInItsMiddle) {
  const Features features = features_of(
      "w1 0:0 50:0 highway=secondary lanes=2 railway=tram\n"
      "w2 0:9 50:9 highway=secondary railway=abandoned");
  ASSERT_EQ(features.tracks.size(), 3u);
  const Track &road = features.tracks[0], &rails = features.tracks[1];
  EXPECT_EQ(road.surface, LandCoverClass::kSecondaryRoad);
  EXPECT_EQ(rails.surface, LandCoverClass::kStreetRails);
  EXPECT_EQ(rails.id, (ObjectId{{OsmType::kWay, 1}, kFirstDerivedPart}));
  EXPECT_TRUE(rails.is_rail);
  EXPECT_EQ(rails.axis, road.axis);
  EXPECT_NEAR(left_kerb_m(rails.section) - right_kerb_m(rails.section),
              left_kerb_m(road.section) - right_kerb_m(road.section), 0.01);
}

TEST(LocateTracks, ARailwayInsideACarriagewayLiesInItsAsphaltAndInBallastWhereItLeavesIt) {
  const Features features = features_of(
      "w1 0:0 100:0 highway=secondary lanes=3\n"
      "w2 -60:2 160:2 railway=rail\n"
      "w3 50:-80 50:80 railway=rail\n"
      "w4 0:12 100:12 railway=rail");
  std::vector<const Track*> inside, pieces;
  for (const Track& track : features.tracks) {
    if (track.surface == LandCoverClass::kStreetRails) inside.push_back(&track);
    if (track.id.osm.id == 2) pieces.push_back(&track);
  }
  ASSERT_EQ(inside.size(), 1u);
  ASSERT_EQ(pieces.size(), 3u);
  EXPECT_EQ(inside[0], pieces[1]);
  EXPECT_NEAR(length_m(pieces[1]->axis), 100, 3);
  EXPECT_TRUE(pieces[1]->is_rail);
  // the pieces meet
  for (std::size_t i = 1; i < 3; ++i) {
    EXPECT_EQ(pieces[i - 1]->axis.back(), pieces[i]->axis.front());
    EXPECT_EQ(pieces[i - 1]->node_ids.back(), pieces[i]->node_ids.front());
    EXPECT_EQ(pieces[i - 1]->surface != pieces[i]->surface, true);
  }
}

}  // namespace
}  // namespace citykiln::map
