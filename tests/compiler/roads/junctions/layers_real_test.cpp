#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <filesystem>

#include "compiler/map/locate.h"
#include "compiler/roads/junctions/layers.h"
#include "compiler/source/read_osm.h"
#include "tests/compiler/roads/junctions/junction_claims.h"
#include "tests/compiler/roads/real_map.h"
#include "tests/test_files.h"

namespace citykiln::roads {
namespace {

struct Extract {
  std::string name, path;
  std::size_t least_in_tunnels;
};

class LayersReal : public testing::TestWithParam<Extract> {};

// The number of ways that shared nodes put into another layer than their tag.
std::size_t overridden(const RoadLayer& layer, const map::Features& features) {
  return static_cast<std::size_t>(std::ranges::count_if(layer.roads, [&](const Road& road) {
    const int told = std::ranges::lower_bound(features.tracks, road.id, {}, &map::Track::id)->layer;
    return told != 0 && told != layer.layer;
  }));
}

void add_faults(const Faults& layer, Faults& all) {
  all.self_crossing += layer.self_crossing, all.spikes += layer.spikes, all.beyond_reach += layer.beyond_reach;
  all.overlap_m2 = std::max(all.overlap_m2, layer.overlap_m2);
}

TEST_P(LayersReal, JunctionsAreSimpleWithoutSpikesApartAndWithinReach) {
  const std::filesystem::path path = real_data(GetParam().path);
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "absent: " << path;
  const Geos geos;
  Report report;
  const auto real = read_real_map(path, report);
  ASSERT_TRUE(real) << to_string(real.error());
  const map::Features& features = real->features;

  const auto begin = std::chrono::steady_clock::now();
  const std::vector<RoadLayer> layers = plan_layers(features, report);
  const double took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  Faults faults;
  std::size_t on_bridges = 0, in_tunnels = 0, roads = 0, moved = 0;
  for (const RoadLayer& layer : layers) {
    add_faults(faults_of(layer.junctions, outline_junctions(layer.junctions, layer.roads, 0), layer.roads), faults);
    (layer.passage == map::Passage::kBridge ? on_bridges : in_tunnels) += layer.junctions.size();
    roads += layer.roads.size(), moved += overridden(layer, features);
    std::printf("layer %d, %s: %zu roads, %zu junctions\n", layer.layer,
                layer.passage == map::Passage::kBridge ? "bridges" : "tunnels", layer.roads.size(),
                layer.junctions.size());
  }
  EXPECT_GT(roads, 0u);
  EXPECT_GE(in_tunnels, GetParam().least_in_tunnels);
  EXPECT_EQ(faults.self_crossing, 0);
  EXPECT_EQ(faults.spikes, 0);
  EXPECT_EQ(faults.beyond_reach, 0);
  EXPECT_LT(faults.overlap_m2, 0.01);
  EXPECT_TRUE(report.balances());
  std::printf(
      "%zu roads in %zu layers, %zu not in the one they say; %zu junctions on bridges, %zu in tunnels; self-crossing "
      "%d, spikes %d, beyond reach "
      "%d, largest overlap %.6f m2; planned in %.1f ms\n",
      roads, layers.size(), moved, on_bridges, in_tunnels, faults.self_crossing, faults.spikes, faults.beyond_reach,
      faults.overlap_m2, 1e3 * took_s);
}

INSTANTIATE_TEST_SUITE_P(Extracts, LayersReal,
                         testing::Values(Extract{"chicago", "chicago-loop/chicago_loop.osm.pbf", 1},
                                         Extract{"monaco", "monaco/monaco-2023.osm.pbf", 1},
                                         Extract{"andorra", "andorra/andorra-2023.osm.pbf", 1},
                                         Extract{"neukolln", "berlin/berlin-neukolln.osm", 0},
                                         Extract{"helsinki", "helsinki/Helsinki.osm.pbf", 0},
                                         Extract{"liechtenstein", "liechtenstein/liechtenstein-2015.osm.pbf", 0},
                                         Extract{"neubrandenburg", "neubrandenburg/neubrandenburg.osm.bz2", 0},
                                         Extract{"porto", "porto-roads/porto_portugal.osm.pbf", 1}),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace citykiln::roads
