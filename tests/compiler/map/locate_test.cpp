#include "compiler/map/locate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/geometry/snap.h"
#include "tests/compiler/map/map_text.h"

namespace citykiln::map {
namespace {

const char* const kVillage = R"(
  w1 -90:0 90:0 highway=residential lit=yes
  w2 0:-90 0:0 0:90 highway=track
  w3 -300:-700 300:700 railway=rail
  w4 -90:9 90:9 waterway=stream
  w5 -90:12 90:12 barrier=hedge
  a10 5:5 15:5 15:15 5:15 building=house building:levels=2
  a11 25:5 45:5 45:15 25:15 building=yes
  a12 25:5 45:5 45:15 25:15 building:part=yes height=12
  a13 -50:-50 -10:-50 -10:-10 -50:-10 landuse=forest
  a14 -5000:-5000 5000:-5000 5000:-20 -5000:-20 natural=water
  r20 100:100 200:100 200:200 100:200 / 120:120 120:140 140:140 ; 300:100 320:100 320:120 landuse=residential
  w30 -600:400 600:400 natural=coastline
  w31 200:-90 200:-60 230:-60 200:-90 natural=coastline
  n40 3:4 natural=tree
  n41 30:40 highway=street_lamp)";

// A permutation without chance.
template <typename T>
void shuffle(std::vector<T>& items, std::uint64_t seed) {
  for (std::size_t i = items.size(); i > 1; --i) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    std::swap(items[i - 1], items[(seed >> 33) % i]);
  }
}

TEST(Locate, DoesNotDependOnTheOrderOfElements) {
  const source::OsmData osm = extract(kVillage);
  Report report;
  const std::string expected = text_of(features_of(osm, report));
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    source::OsmData shuffled = osm;
    shuffle(shuffled.nodes, seed);
    shuffle(shuffled.ways, seed);
    shuffle(shuffled.areas, seed);
    Report again;
    EXPECT_EQ(text_of(features_of(shuffled, again)), expected) << seed;
    EXPECT_EQ(again.counts(), report.counts());
  }
}

TEST(Locate, LedgerBalances) {
  Report report;
  features_of(kVillage, report);
  EXPECT_TRUE(report.balances());
  for (const char* kind : {"track", "footprint", "area", "coastline", "waterway", "barrier", "point"})
    EXPECT_GT(report.account("map", kind).in, 0u) << kind;
}

TEST(Locate, EverythingIsSnappedAndSorted) {
  const Features f = features_of(kVillage);
  const auto sorted = [](const auto& v) {
    return std::is_sorted(v.begin(), v.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  };
  EXPECT_TRUE(sorted(f.tracks) && sorted(f.footprints) && sorted(f.areas) && sorted(f.waterways) &&
              sorted(f.barriers) && sorted(f.points));
  for (const Track& track : f.tracks)
    for (const Vec2 p : track.axis) EXPECT_EQ(p, snapped(p));
  for (const AreaFeature& area : f.areas)
    for (const Vec2 p : area.polygon.outer) EXPECT_EQ(p, snapped(p));
}

TEST(Locate, TheRegionIsWholeCellsAroundTheBox) {
  const Plane plane(kTestOrigin);
  for (const double half_m : {1.0, 100.0, 500.0, 3000.0}) {
    const source::LonLatBox box = box_around(half_m);
    Report report;
    const Box2 extent = locate({}, plane, box, {}, report).extent;
    for (const double v : {extent.min.x, extent.min.y, extent.max.x, extent.max.y}) EXPECT_EQ(std::fmod(v, kCell_m), 0);
    for (const LonLat corner : {LonLat{box.west, box.south}, LonLat{box.east, box.south}, LonLat{box.east, box.north},
                                LonLat{box.west, box.north}})
      EXPECT_TRUE(extent.contains(plane.forward(corner)));
    EXPECT_LT(extent.width(), 2 * half_m + 3 * kCell_m);
  }
}

TEST(Locate, AnEmptyExtractGivesEmptyFeatures) {
  Report report;
  const source::OsmData nothing;
  const source::LonLatBox box = choose_box(nothing, {});
  EXPECT_EQ(box, (source::LonLatBox{0, 0, 0, 0}));
  const Features features = locate(nothing, Plane(default_origin(box)), box, {}, report);
  EXPECT_GT(features.extent.width(), 0);
  EXPECT_TRUE(features.tracks.empty() && features.areas.empty() && features.footprints.empty());
  EXPECT_TRUE(report.balances());
}

// A node at 0, 0 by mistake, as real extracts have them.
TEST(Locate, AStrayNodeDoesNotReachAcrossTheWorld) {
  source::OsmData osm = extract("w1 0:0 50:0 90:0 highway=residential\na2 0:0 40:0 40:30 landuse=grass");
  osm.way_nodes[2].at = {0, 0};
  osm.ring_points[2] = {974200000, 0};
  Report report;
  const Features features = features_of(osm, report);
  const Box2 far = features.extent.widened(65536);
  ASSERT_EQ(features.tracks.size(), 1u);
  for (const Vec2 p : features.tracks[0].axis) EXPECT_TRUE(far.contains(p)) << p.x << " " << p.y;
  for (const AreaFeature& area : features.areas)
    for (const Vec2 p : area.polygon.outer) EXPECT_TRUE(far.contains(p)) << p.x << " " << p.y;
}

TEST(ChooseBox, TheCommandLineComesBeforeTheFile) {
  source::OsmData osm = extract(kVillage);
  osm.header_box = {7, 43, 8, 44};
  EXPECT_EQ(choose_box(osm, {}), *osm.header_box);
  Options options;
  options.bbox = {7.1, 43.1, 7.2, 43.2};
  EXPECT_EQ(choose_box(osm, options), *options.bbox);
}

TEST(ChooseBox, WithoutAHeaderAFewFarBuildingsDoNotWidenIt) {
  std::string text;
  for (int i = 0; i < 200; ++i)
    text += fmt::format("a{} {}:{} {}:{} {}:{} building=yes\n", i + 1, i % 20 * 50, i / 20 * 50, i % 20 * 50 + 9,
                        i / 20 * 50, i % 20 * 50, i / 20 * 50 + 9);
  text += "a900 50000:0 50009:0 50000:9 building=yes\nw901 -90000:0 90000:0 highway=motorway\n";
  const source::LonLatBox box = choose_box(extract(text), {});
  const Plane plane(kTestOrigin);
  const Vec2 low = plane.forward({box.west, box.south}), high = plane.forward({box.east, box.north});
  EXPECT_GT(low.x, -60);
  EXPECT_LT(high.x, 1100);
  EXPECT_GT(high.x - low.x, 850);
  EXPECT_GT(high.y - low.y, 400);
}

TEST(ChooseBox, TheOriginIsTheMiddleRoundedToAHundredthOfADegree) {
  EXPECT_NEAR(default_origin({7.409, 43.723, 7.449, 43.752}).lon_deg, 7.43, 1e-12);
  EXPECT_NEAR(default_origin({7.409, 43.723, 7.449, 43.752}).lat_deg, 43.74, 1e-12);
  EXPECT_NEAR(default_origin({-87.64, -41.27, -87.60, -41.25}).lon_deg, -87.62, 1e-12);
}

}  // namespace
}  // namespace citykiln::map
