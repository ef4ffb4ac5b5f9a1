#include "compiler/map/lanes/track_points.h"

#include <gtest/gtest.h>

#include "tests/compiler/map/map_text.h"

namespace citykiln::map {
namespace {

// "1zebra^ 2signals": vertex, kind, and ^ along or v against the way.
std::string text_of_points(const Track& track) {
  constexpr const char* kNames[] = {"zebra", "crossing", "signals", "stop", "give_way", "level",    "turning",
                                    "mini",  "loop",     "plain",   "hump", "table",    "cushions", "island"};
  std::string text;
  for (const TrackPoint& point : track.points)
    text += fmt::format("{}{}{}{}", text.empty() ? "" : " ", point.vertex, kNames[static_cast<int>(point.kind)],
                        point.facing == 0  ? ""
                        : point.facing > 0 ? "^"
                                           : "v");
  return text;
}

// The points of w1 of a drawn extract, whose nodes are numbered as map_text.h numbers them: by their place.
std::string points_in(const std::string& text, std::size_t track = 0) {
  source::OsmData osm = extract(text);
  for (source::Node& node : osm.nodes) node.id = std::int64_t{node.at.lon_e7} * 4294967296 + node.at.lat_e7;
  Report report;
  const Features features = features_of(osm, report);
  EXPECT_EQ(report.counts()[Code::kBadTagValue], 0u) << text;
  return track < features.tracks.size() ? text_of_points(features.tracks[track]) : "no track";
}

std::string of_node(const std::string& tags) {
  return points_in("n9 10:0 " + tags + "\nw1 0:0 10:0 20:0 highway=residential");
}

TEST(TrackPoints, OfRailsAndWaysThatShareANodeAreLevelCrossings) {
  const std::string path = "\nw2 10:-9 10:0 10:9 highway=footway";
  EXPECT_EQ(points_in("w1 0:0 10:0 20:0 railway=rail" + path), "1level");
  EXPECT_EQ(points_in("n9 10:0 railway=crossing\nw1 0:0 10:0 20:0 railway=rail" + path), "1level");
  EXPECT_EQ(points_in("w1 0:0 10:0 20:0 railway=tram" + path), "");
  EXPECT_EQ(points_in("w1 0:0 10:0 20:0 railway=rail bridge=yes layer=1" + path), "");
}

TEST(TrackPoints, FollowFromTheTagsOfNodes) {
  const struct {
    const char *tags, *points;
  } cases[] = {
      {"highway=crossing crossing=zebra", "1zebra"},
      {"highway=crossing crossing=marked crossing_ref=zebra", "1zebra"},
      {"highway=crossing crossing:markings=zebra", "1zebra"},
      {"highway=crossing crossing:markings=zebra:double crossing=traffic_signals", "1zebra"},
      {"highway=crossing crossing:markings=ladder:skewed", "1zebra"},
      {"highway=crossing crossing=uncontrolled", "1zebra"},
      {"highway=crossing crossing=uncontrolled crossing:markings=yes", "1zebra"},
      {"highway=crossing crossing=uncontrolled crossing:markings=lines", "1crossing"},
      {"highway=crossing crossing=uncontrolled crossing:markings=no", "1plain"},
      {"highway=crossing crossing=traffic_signals", "1crossing"},
      {"highway=crossing crossing=marked", "1crossing"},
      {"highway=crossing crossing=island", "1crossing"},
      {"highway=crossing crossing=toucan!", "1crossing"},
      {"highway=crossing crossing=marked crossing_ref=puffin", "1crossing"},
      {"highway=crossing", "1crossing"},
      {"highway=crossing crossing=unmarked", "1plain"},
      {"highway=crossing crossing=unmarked crossing:markings=dashes", "1crossing"},
      {"highway=crossing crossing=informal", "1plain"},
      {"highway=crossing crossing=no", ""},
      {"highway=traffic_signals", "1signals"},
      {"highway=traffic_signals crossing=traffic_signals", "1crossing 1signals"},
      {"highway=traffic_signals crossing=no", "1signals"},
      {"highway=traffic_signals direction=forward", "1signals^"},
      {"highway=traffic_signals traffic_signals:direction=backward", "1signalsv"},
      {"highway=traffic_signals traffic_signals:direction=both direction=forward", "1signals"},
      {"highway=stop", "1stop"},
      {"highway=stop direction=backward", "1stopv"},
      {"highway=stop direction=270", "1stop"},
      {"highway=give_way direction=forward", "1give_way^"},
      {"railway=level_crossing", "1level"},
      {"railway=crossing", "1level"},
      {"railway=tram_crossing highway=crossing crossing=zebra", "1zebra 1level"},
      {"traffic_calming=bump", "1hump"},
      {"traffic_calming=table highway=crossing crossing=zebra", "1zebra 1table"},
      {"highway=turning_circle diameter=12", "1turning"},
      {"highway=turning_loop", "1loop"},
      {"highway=mini_roundabout direction=clockwise", "1mini"},
      {"highway=bus_stop crossing=zebra", ""},
      {"highway=street_lamp", ""},
  };
  for (const auto& c : cases) EXPECT_EQ(of_node(c.tags), c.points) << c.tags;
}

// The traits of the crossing of w1, whose node 1 is crossed by w2.
int traits_of_crossing(const std::string& tags, const std::string& kerb_tags) {
  source::OsmData osm = extract("n9 10:0 highway=crossing crossing=unmarked " + tags + "\nn8 10:5 " + kerb_tags +
                                "\nw1 0:0 10:0 20:0 highway=residential\nw2 10:-5 10:0 10:5 highway=footway");
  for (source::Node& node : osm.nodes) node.id = std::int64_t{node.at.lon_e7} * 4294967296 + node.at.lat_e7;
  Report report;
  const Features features = features_of(osm, report);
  return features.tracks.at(0).points.empty() ? -1 : features.tracks.at(0).points[0].traits;
}

TEST(TrackPoints, CrossingsHaveTheTraitsOfTheirTagsAndElseOfTheKerbsBesideThem) {
  EXPECT_EQ(traits_of_crossing("kerb=lowered tactile_paving=no", ""), kLoweredKerb | kNoTactileSlabs);
  EXPECT_EQ(traits_of_crossing("crossing:island=yes", ""), kCrossingIsland);
  EXPECT_EQ(traits_of_crossing("", "barrier=kerb kerb=flush tactile_paving=yes"), kFlushKerb | kTactileSlabs);
  EXPECT_EQ(traits_of_crossing("kerb=raised", "barrier=kerb kerb=flush"), kRaisedKerb);
  EXPECT_EQ(traits_of_crossing("", ""), 0);
}

TEST(TrackPoints, AreSortedByVertexAlongTheWay) {
  EXPECT_EQ(points_in(R"(
    n1 30:0 highway=stop
    n2 10:0 highway=crossing
    n3 0:0 highway=traffic_signals crossing=zebra
    n4 40:9 highway=stop
    w1 0:0 10:0 20:0 30:0 40:0 highway=residential)"),
            "0zebra 0signals 1crossing 3stop");
}

TEST(TrackPoints, BelongToEveryTrackThroughTheNode) {
  const std::string text =
      "n1 10:0 railway=level_crossing\nw1 0:0 10:0 20:0 highway=residential\nw2 10:-9 10:-5 10:0 10:9 railway=rail";
  EXPECT_EQ(points_in(text, 0), "1level");
  EXPECT_EQ(points_in(text, 1), "2level");
}

TEST(TrackPoints, NodesThatSnapTogetherKeepBothMarks) {
  // 3 mm apart: one vertex of the plane's grid, two places of OSM's
  source::OsmData osm =
      extract("w1 0:0 10:0 11:0 20:0 highway=residential\nn8 10:0 highway=stop\nn9 11:0 highway=crossing");
  osm.way_nodes[2].at = osm.way_nodes[1].at;
  osm.nodes[0].id = osm.way_nodes[1].id;
  osm.nodes[1].id = osm.way_nodes[2].id;
  Report report;
  const Features features = features_of(osm, report);
  ASSERT_EQ(features.tracks.size(), 1u);
  EXPECT_EQ(features.tracks[0].axis.size(), 3u);
  EXPECT_EQ(text_of_points(features.tracks[0]), "1crossing 1stop");
}

TEST(TrackPoints, ClosedWaysHaveTheirFirstNodeOnce) {
  EXPECT_EQ(points_in("n1 0:0 highway=stop\nn2 9:9 highway=stop\nw1 0:0 9:0 9:9 0:9 0:0 highway=residential"),
            "0stop 2stop");
  EXPECT_EQ(points_in("n1 9:0 highway=stop\nw1 0:0 9:0 9:9 0:9 9:0 -5:-5 highway=residential"), "1stop 4stop");
}

}  // namespace
}  // namespace citykiln::map
