#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <set>

#include "compiler/map/locate.h"
#include "compiler/roads/generate.h"
#include "compiler/roads/roads_on_ground.h"
#include "compiler/roads/width_limits/building_obstacles.h"
#include "compiler/roads/width_limits/limit_widths.h"
#include "compiler/roads/width_limits/narrowed_section.h"
#include "compiler/source/read_osm.h"
#include "tests/compiler/roads/junctions/junction_claims.h"
#include "tests/compiler/roads/real_map.h"
#include "tests/test_files.h"

namespace citykiln::roads {
namespace {

// The area that the rings and a footprint share.
double under_footprints_m2(std::span<const Ring> rings, const Polygon& footprint) {
  const Box2 box = box_of(footprint.outer);
  std::vector<GEOSGeometry*> near;
  for (const Ring& ring : rings)
    if (box_of(ring).touches(box)) near.push_back(shape({ring, {}}).release());
  if (near.empty()) return 0;
  const Shape all(GEOSGeom_createCollection(GEOS_MULTIPOLYGON, near.data(), static_cast<unsigned>(near.size())));
  const Shape covered(GEOSUnaryUnion(all.get()));
  return area_of(Shape(GEOSIntersection(covered.get(), shape(footprint).get())));
}

double under_footprints_m2(std::span<const Ring> rings, const Box2& box, const ObstructingFootprints& footprints) {
  double shared = 0;
  for (const std::uint32_t f : footprints.near(box)) shared += under_footprints_m2(rings, footprints[f]);
  return shared;
}

// The area under buildings, summed over roads, even where these overlap.
struct Under {
  double carriageway_m2 = 0, pavement_m2 = 0;
};

Under under_buildings(const Road& road, const StripEnds& ends, const ObstructingFootprints& footprints) {
  const Box2 box = box_of(road.axis).widened(max_offset_m(road));
  const double carriageway = under_footprints_m2(stroke_carriageway(road, ends), box, footprints);
  const std::vector<Ring> all = stroke_pavements(road, ends);
  return {carriageway, all.empty() ? 0 : under_footprints_m2(all, box, footprints) - carriageway};
}

class LimitWidthsReal : public testing::TestWithParam<std::string> {};

TEST_P(LimitWidthsReal, KeepsOutOfBuildingsOrSaysThatItDoesNot) {
  const std::filesystem::path path = real_data(GetParam());
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "absent: " << path;
  const Geos geos;
  Report report;
  const auto real = read_real_map(path, report);
  ASSERT_TRUE(real) << to_string(real.error());
  const map::Features& features = real->features;
  const std::vector<Road> roads = roads_on_ground(features, report);
  const std::vector<Road> narrowed =
      limit_widths(roads, plan_junctions(roads, report), features.footprints, {}, report);

  const ObstructingFootprints footprints(features.footprints);
  const std::vector<StripEnds> ends = ends_of(roads);
  std::set<OsmId> told;
  for (const Diagnosis& d : report.diagnoses())
    if (d.code == Code::kBuildingOnRoad) told.insert(d.object);
  Under before, after;
  std::size_t width_limits = 0, changed = 0;
  for (std::size_t i = 0; i < roads.size(); ++i) {
    if (family_of(roads[i].surface) == Family::kOther) continue;
    const Under was = under_buildings(roads[i], ends[i], footprints);
    const bool is_same = narrowed[i] == roads[i];
    const Under is = is_same ? was : under_buildings(narrowed[i], ends[i], footprints);
    before.carriageway_m2 += was.carriageway_m2, before.pavement_m2 += was.pavement_m2;
    after.carriageway_m2 += is.carriageway_m2, after.pavement_m2 += is.pavement_m2;
    width_limits += narrowed[i].width_limits.left.size() + narrowed[i].width_limits.right.size(), changed += !is_same;
    // a path may end at a door
    const bool is_at_door = !find_building_obstacles(roads[i], ends[i], footprints).covered.empty();
    const double allowed_m2 = is_at_door ? 2 * max_offset_m(roads[i]) : 0.05;
    EXPECT_TRUE(told.contains(roads[i].id.osm) || is.carriageway_m2 + is.pavement_m2 < allowed_m2)
        << roads[i].id.osm.id << " " << is.carriageway_m2 << " " << is.pavement_m2;
  }
  EXPECT_LE(after.carriageway_m2, before.carriageway_m2);
  EXPECT_LE(after.pavement_m2, before.pavement_m2);
  std::printf(
      "%s: %zu roads, %zu narrowed by %zu limits; under buildings: carriageway %.0f -> %.0f m2, pavement %.0f "
      "-> %.0f m2\n",
      GetParam().c_str(), roads.size(), changed, width_limits, before.carriageway_m2, after.carriageway_m2,
      before.pavement_m2, after.pavement_m2);
}

INSTANTIATE_TEST_SUITE_P(Extracts, LimitWidthsReal,
                         testing::Values("monaco/monaco-2023.osm.pbf", "monaco/monaco-2016-cadastre.osm.pbf",
                                         "andorra/andorra-2023.osm.pbf", "helsinki/Helsinki.osm.pbf",
                                         "neubrandenburg/neubrandenburg.osm.bz2"));

}  // namespace
}  // namespace citykiln::roads
