#include "compiler/source/areas/mended_rings.h"

#include <gtest/gtest.h>

#include <cstdint>

#include "compiler/contract/random_sequence.h"
#include "tests/compiler/source/extract_text.h"

namespace citykiln::source {
namespace {

AreaLine line(std::vector<Location> points, bool is_inner = false) { return {std::move(points), is_inner}; }

AreaLine square(int low, int high, bool is_inner = false) {
  return line({{low, low}, {high, low}, {high, high}, {low, high}, {low, low}}, is_inner);
}

double ring_area(const std::vector<Location>& ring) {
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Location a = ring[i], b = ring[(i + 1) % ring.size()];
    twice += double(a.lon_e7) * b.lat_e7 - double(b.lon_e7) * a.lat_e7;
  }
  return twice / 2;
}

double area_of(const std::vector<MendedPolygon>& polygons) {
  double sum = 0;
  for (const MendedPolygon& polygon : polygons)
    for (const std::vector<Location>& ring : polygon) sum += ring_area(ring);
  return sum;
}

TEST(MendedRings, BowTiesAreTwoLobes) {
  const auto lobes = mended_polygons({{line({{0, 0}, {1000, 1000}, {1000, 0}, {0, 1000}, {0, 0}})}});
  EXPECT_EQ(lobes.size(), 2u);
  EXPECT_NEAR(area_of(lobes), 500000, 1);
}

TEST(MendedRings, AnInnerRingOnTheEdgeLeavesAU) {
  const AreaLine inner = line({{400, 600}, {600, 600}, {600, 1000}, {400, 1000}, {400, 600}}, true);
  const auto u = mended_polygons({{square(0, 1000), inner}});
  ASSERT_EQ(u.size(), 1u);
  EXPECT_EQ(u[0].size(), 1u);
  EXPECT_NEAR(area_of(u), 1e6 - 8e4, 1);
}

TEST(MendedRings, AnInnerRingThatCrossesTakesOnlyWhatIsInside) {
  const AreaLine inner = line({{400, 600}, {600, 600}, {600, 1200}, {400, 1200}, {400, 600}}, true);
  EXPECT_NEAR(area_of(mended_polygons({{square(0, 1000), inner}})), 1e6 - 8e4, 1);
}

TEST(MendedRings, SpikesAndDoubleSegmentsHaveNoArea) {
  const auto spike =
      mended_polygons({{line({{0, 0}, {1000, 0}, {2000, 0}, {1000, 0}, {1000, 1000}, {0, 1000}, {0, 0}})}});
  EXPECT_NEAR(area_of(spike), 1e6, 1);
  EXPECT_TRUE(mended_polygons({{line({{0, 0}, {1000, 0}, {0, 0}, {1000, 0}, {0, 0}})}}).empty());
}

TEST(MendedRings, LinesAreJoinedByRoleInAnyDirection) {
  const std::vector<AreaLine> joined = joined_lines(
      {line({{0, 0}, {9, 0}}), line({{9, 9}, {9, 0}}), line({{5, 5}, {6, 6}}, true), line({{9, 9}, {0, 9}, {0, 0}})});
  ASSERT_EQ(joined.size(), 2u);
  EXPECT_EQ(joined[0].points.front(), joined[0].points.back());
  EXPECT_EQ(joined[0].points.size(), 5u);
}

TEST(MendedRings, NoRandomRingIsLostAndNoneIsLargerThanItsBox) {
  for (std::uint32_t seed = 0; seed < 1000; ++seed) {
    const RandomSequence draw(seed, StableId{}, "ring");
    std::vector<Location> points;
    for (std::uint32_t i = 0; i < 8; ++i)
      points.push_back({static_cast<int>(draw.below(1000, 2 * i)), static_cast<int>(draw.below(1000, 2 * i + 1))});
    points.push_back(points.front());
    const double area = area_of(mended_polygons({{line(points)}}));
    EXPECT_GT(area, 0) << seed;
    EXPECT_LE(area, 1e6) << seed;
  }
}

TEST(MendedRings, BuildingsWithBrokenRingsAreReadAndDiagnosed) {
  const std::string nodes = R"(<node id="1" lat="0" lon="0"/><node id="2" lat="0.001" lon="0.001"/>)"
                            R"(<node id="3" lat="0" lon="0.001"/><node id="4" lat="0.001" lon="0"/>)";
  Report report;
  const OsmData data = read(nodes + R"(<way id="7"><nd ref="1"/><nd ref="2"/><nd ref="3"/><nd ref="4"/><nd ref="1"/>)"
                                    R"(<tag k="building" v="yes"/></way>)",
                            report);
  ASSERT_EQ(data.areas.size(), 1u);
  EXPECT_EQ(data.areas[0].rings.count, 2u);
  EXPECT_EQ(report.counts()[Code::kAreaMended], 1u);
  EXPECT_EQ(report.counts()[Code::kBrokenArea], 0u);
}

TEST(MendedRings, AreasThatCannotBeMendedAreDiagnosedWithTheirKindAndSize) {
  // there and back again: 0.001 degrees of latitude are 111 m
  const std::string nodes = R"(<node id="1" lat="0" lon="0"/><node id="2" lat="0.001" lon="0"/>)"
                            R"(<node id="3" lat="0.0005" lon="0"/>)";
  Report report;
  const OsmData data = read(nodes + R"(<way id="7"><nd ref="1"/><nd ref="2"/><nd ref="3"/><nd ref="1"/>)"
                                    R"(<tag k="natural" v="water"/></way>)",
                            report);
  EXPECT_TRUE(data.areas.empty());
  const auto broken = std::ranges::find(report.diagnoses(), Code::kBrokenArea, &Diagnosis::code);
  ASSERT_NE(broken, report.diagnoses().end());
  EXPECT_EQ(broken->tag, "natural=water");
  EXPECT_EQ(broken->size, 111);
}

}  // namespace
}  // namespace citykiln::source
