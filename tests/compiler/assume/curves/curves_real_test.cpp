#include <gtest/gtest.h>

#include <filesystem>

#include "compiler/assume/curves/curves.h"
#include "compiler/roads/generate.h"
#include "compiler/roads/roads_on_ground.h"
#include "tests/compiler/roads/junctions/junction_claims.h"
#include "tests/compiler/roads/real_map.h"
#include "tests/test_files.h"

namespace citykiln::roads {
namespace {

class CurvesReal : public testing::TestWithParam<std::string> {};

TEST_P(CurvesReal, JunctionsOfCurvedRoadsAreSound) {
  const std::filesystem::path path = real_data(GetParam());
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "absent: " << path;
  const Geos geos;
  Report report;
  const auto real = read_real_map(path, report);
  ASSERT_TRUE(real) << to_string(real.error());
  map::FeatureView features = real->features;
  const std::vector<map::Track> tracks = assume::curved_tracks(features, report);
  features.tracks = tracks;
  const std::vector<Road> roads = roads_on_ground(features, report);
  const std::vector<Junction> junctions = plan_junctions(roads, report);
  const Faults faults = faults_of(junctions, outline_junctions(junctions, roads, 0), roads);
  EXPECT_GT(junctions.size(), 0u);
  EXPECT_EQ(faults.self_crossing, 0);
  EXPECT_EQ(faults.spikes, 0);
  EXPECT_EQ(faults.beyond_reach, 0);
  EXPECT_LT(faults.overlap_m2, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Maps, CurvesReal,
                         testing::Values("monaco/monaco-2023.osm.pbf", "andorra/andorra-2023.osm.pbf",
                                         "berlin/berlin-neukolln.osm", "chicago-loop/chicago_loop.osm.pbf",
                                         "helsinki/Helsinki.osm.pbf", "porto-roads/porto_portugal.osm.pbf",
                                         "junctions/kingsway_junction.osm", "junctions/montlake_roundabout.osm",
                                         "junctions/tiny_roundabout.osm", "junctions/i5_exit_ramp.osm"));

}  // namespace
}  // namespace citykiln::roads
