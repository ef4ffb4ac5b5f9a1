#include "compiler/map/buildings/part_looks.h"

#include <gtest/gtest.h>

#include "compiler/map/buildings/building_classes.h"
#include "compiler/source/read_osm.h"
#include "tests/compiler/map/map_text.h"
#include "tests/scratch_folder.h"

namespace citykiln::map {
namespace {

// Two squares side by side, 10 by 11 m, and a third 100 m away.
constexpr const char* kPlacesOfParts =
    R"(<node id="1" lat="43.73" lon="7.42"/><node id="2" lat="43.73" lon="7.4201"/><node id="3" lat="43.7301" lon="7.4201"/>)"
    R"(<node id="4" lat="43.7301" lon="7.42"/><node id="5" lat="43.731" lon="7.42"/><node id="6" lat="43.731" lon="7.4201"/>)"
    R"(<node id="7" lat="43.7311" lon="7.4201"/><node id="8" lat="43.7311" lon="7.42"/>)";

std::vector<Footprint> footprints_with(const std::string& outline_tags, const std::string& relation_tags) {
  const ScratchFolder folder;
  Report report;
  const std::string text =
      std::string("<osm version=\"0.6\">") + kPlacesOfParts +
      R"(<way id="11"><nd ref="1"/><nd ref="2"/><nd ref="3"/><nd ref="4"/><nd ref="1"/>)" + outline_tags + "</way>" +
      R"(<way id="12"><nd ref="5"/><nd ref="6"/><nd ref="7"/><nd ref="8"/><nd ref="5"/><tag k="building:part" v="yes"/></way>)"
      R"(<relation id="20"><member type="way" ref="11" role="outline"/><member type="way" ref="12" role="part"/>)"
      R"(<tag k="type" v="building"/>)" +
      relation_tags + "</relation></osm>";
  const auto osm = source::read_osm(folder.write("a.osm", text), 1, report);
  EXPECT_TRUE(osm);
  return osm ? features_of(*osm, report).footprints : std::vector<Footprint>{};
}

TEST(CompleteLooks, APartFarFromItsOutlineTakesWhatItsRelationsOutlineSays) {
  const auto footprints =
      footprints_with(R"(<tag k="building" v="church"/><tag k="building:material" v="brick"/>)", "");
  ASSERT_EQ(footprints.size(), 2u);
  EXPECT_EQ(footprints[1].building_class, static_cast<std::uint8_t>(BuildingClass::kChurch));
  EXPECT_EQ(footprints[1].wall_material, materials::Material::kBrick);
}

TEST(CompleteLooks, PartsAndOutlinesTakeWhatTheRelationSays) {
  const auto footprints = footprints_with(R"(<tag k="building" v="yes"/>)",
                                          R"(<tag k="building" v="church"/><tag k="building:colour" v="#aa2222"/>)");
  ASSERT_EQ(footprints.size(), 2u);
  for (const Footprint& f : footprints) {
    EXPECT_EQ(f.building_class, static_cast<std::uint8_t>(BuildingClass::kChurch));
    EXPECT_EQ(f.wall_colour, (Srgb{0xaa, 0x22, 0x22}));
  }
}

// The finding of a brick church with one part, whose own tags are given; it looks like the outline or is plain.
std::uint64_t unlike_parts(const std::string& part_tags, bool is_plain) {
  const source::OsmData osm = extract(
      "a1 0:0 20:0 20:20 0:20 building=church building:material=brick\n"
      "a2 0:0 10:0 10:10 0:10 " +
      part_tags);
  Report report;
  std::vector<Footprint> footprints = features_of(osm, report).footprints;
  EXPECT_FALSE(report.counts().contains(Code::kPartUnlikeOutline)) << part_tags;
  for (Footprint& f : footprints)
    if (f.is_part && is_plain) f.wall_material.reset();
  const Plane plane(kTestOrigin);
  diagnose_unlike_parts({osm, plane, {{-500, -500}, {500, 500}}, report, nullptr}, footprints);
  return report.counts()[Code::kPartUnlikeOutline];
}

TEST(CompleteLooks, APartUnlikeItsOutlineWithoutATagThatSaysSoIsFound) {
  EXPECT_EQ(unlike_parts("building:part=yes", false), 0u);
  EXPECT_EQ(unlike_parts("building:part=yes", true), 1u);
  EXPECT_EQ(unlike_parts("building:part=yes building:material=glass", true), 0u);
}

}  // namespace
}  // namespace citykiln::map
