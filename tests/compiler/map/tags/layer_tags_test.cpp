#include "compiler/map/tags/layer_tags.h"

#include <gtest/gtest.h>

#include "tests/compiler/map/map_text.h"

namespace citykiln::map {
namespace {

TEST(LayerTags, AreThoseOfTheWaysThatDiagnosesOfTwoName) {
  const source::OsmData osm = extract(
      "w1 0:0 50:0 highway=service layer=-2 tunnel=yes maxheight=3.5\n"
      "w2 25:-9 25:9 highway=service name=A\n"
      "w3 90:0 99:0 highway=service layer=-1");
  Report report;
  report.add_pair(Code::kClearanceNotMet, {OsmType::kWay, 1}, {OsmType::kWay, 2}, 1);
  report.add_pair(Code::kClearanceNotMet, {OsmType::kWay, 9}, {OsmType::kRelation, 3}, 1);
  report.add(Code::kTooSteep, {OsmType::kWay, 3}, 1);
  EXPECT_EQ(layer_tags_of(osm, report),
            (LayerTags{{{OsmType::kWay, 1}, "tunnel=yes layer=-2 maxheight=3.5"}, {{OsmType::kWay, 2}, ""}}));
}

}  // namespace
}  // namespace citykiln::map
