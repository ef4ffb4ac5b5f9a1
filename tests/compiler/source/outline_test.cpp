#include "compiler/source/outline.h"

#include <gtest/gtest.h>

#include <string>

namespace citykiln::source {
namespace {

constexpr const char* kOuterSquare = "[[0,0],[4,0],[4,4],[0,4],[0,0]]";

std::string polygon(const std::string& rings) { return R"({"type":"Polygon","coordinates":[)" + rings + "]}"; }

Result<Outline> parse(const std::string& text, const std::string& name = "a.geojson") {
  return parse_outline(text, name);
}

std::string error_of(const Result<Outline>& outline) { return outline ? "" : to_string(outline.error()); }

TEST(Outline, ReadsPolygonsOfGeoJsonWithHolesAndInCollections) {
  const std::string hole = "[[1,1],[1,2],[2,2],[1,1]]", far = "[[10,0],[12,0],[12,2],[10,0]]";
  const std::string first = polygon(std::string(kOuterSquare) + "," + hole);
  const std::string second = R"({"type":"MultiPolygon","coordinates":[[)" + far + "]]}";
  const auto outline = parse(R"({"type":"FeatureCollection","features":[{"type":"Feature","geometry":)" + first +
                             R"(},{"type":"Feature","geometry":)" + second +
                             R"(},{"type":"Feature","geometry":{"type":"Point","coordinates":[1,1]}}]})");
  ASSERT_TRUE(outline) << error_of(outline);
  ASSERT_EQ(outline->polygons.size(), 2u);
  EXPECT_EQ(outline->polygons[0].outer.size(), 4u);
  ASSERT_EQ(outline->polygons[0].holes.size(), 1u);
  EXPECT_EQ(outline->polygons[0].holes[0].size(), 3u);
  EXPECT_EQ(box_of(*outline), (LonLatBox{0, 0, 12, 4}));
}

TEST(Outline, ReadsThePolygonFormatOfOsmosis) {
  const auto outline = parse(
      "town\n1\n\t0.0 \t 0.0\n 4E0 0\n 4 4\n 0 4\n 0 0\nEND\n!2\n 1 1\n 1 2\n 2 2\nEND\nb\n 9 0\n 10 0\n 10 "
      "1\nEND\nEND\n",
      "a.poly");
  ASSERT_TRUE(outline) << error_of(outline);
  ASSERT_EQ(outline->polygons.size(), 2u);
  EXPECT_EQ(outline->polygons[0].outer.size(), 4u);
  EXPECT_EQ(outline->polygons[0].holes.size(), 1u);
  EXPECT_TRUE(outline->polygons[1].holes.empty());
}

TEST(Outline, SaysWhereRingsCrossThemselves) {
  EXPECT_EQ(
      error_of(parse(polygon("[[0,0],[4,4],[4,0],[0,4],[0,0]]"))),
      "a.geojson: polygon 1, point 1 (0,0): the edge from here crosses or touches the one from polygon 1, point 3 "
      "(4,0)");
  EXPECT_NE(error_of(parse(polygon(std::string(kOuterSquare) + ",[[1,1],[6,1],[1,2],[1,1]]"))), "");
  EXPECT_NE(error_of(parse(polygon("[[0,0],[4,0],[2,0],[2,3],[0,0]]"))), "") << "an edge that doubles back";
}

TEST(Outline, AcceptsRingsOfDifferentPolygonsThatTouchAtAPoint) {
  const auto outline = parse(R"({"type":"MultiPolygon","coordinates":[[)" + std::string(kOuterSquare) +
                             "],[[[4,4],[6,4],[6,6],[4,4]]]]}");
  EXPECT_TRUE(outline) << error_of(outline);
}

TEST(Outline, SaysThatARingIsNotClosedOrHasTooFewPoints) {
  EXPECT_EQ(error_of(parse(polygon("[[0,0],[4,0],[4,4]]"))),
            "a.geojson: polygon 1: is not closed: the last position of a ring repeats the first");
  EXPECT_EQ(error_of(parse(polygon("[[0,0],[4,0],[0,0],[0,0]]"))),
            "a.geojson: polygon 1: expected at least 3 different points, found 2");
  EXPECT_EQ(error_of(parse("t\n1\n 0 0\n 1 0\n", "a.poly")),
            "a.poly:4: expected END after the points of a ring, found the end of the file");
  EXPECT_EQ(error_of(parse("t\n1\n 0 0\n x 0\nEND\nEND", "a.poly")),
            "a.poly:4: expected longitude and latitude, or END, found \"x 0\"");
}

TEST(Outline, SuspectsSwappedCoordinates) {
  EXPECT_EQ(error_of(parse(polygon("[[10,139],[11,139],[11,140],[10,139]]"))),
            "a.geojson: polygon 1, point 1 (10,139): is not on Earth; expected longitude, then latitude, in degrees; "
            "latitude and longitude swapped?");
}

TEST(Outline, SaysThatAHoleIsOutside) {
  EXPECT_EQ(error_of(parse(polygon(std::string(kOuterSquare) + ",[[5,5],[5,6],[6,6],[5,5]]"))),
            "a.geojson: polygon 1, hole 1: lies outside of its polygon");
}

TEST(Outline, SaysThatAFileHasNoPolygonOrIsOfAnotherFormat) {
  EXPECT_EQ(error_of(parse(R"({"type":"Point","coordinates":[0,0]})")), "a.geojson: has no Polygon or MultiPolygon");
  EXPECT_EQ(error_of(parse("{")), "a.geojson, byte 2: expected GeoJSON, found malformed JSON");
  EXPECT_NE(error_of(parse("hello", "a.txt")), "");
  EXPECT_NE(error_of(parse(R"({"type":"Polygon","crs":{"properties":{"name":"EPSG:3857"}},"coordinates":[)" +
                           std::string(kOuterSquare) + "]}")),
            "");
}

}  // namespace
}  // namespace citykiln::source
