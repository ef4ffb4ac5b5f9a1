#include <gtest/gtest.h>

#include <map>
#include <utility>

#include "compiler/assume/curves/curves.h"
#include "compiler/geometry/snap.h"
#include "tests/compiler/roads/junctions/junction_claims.h"
#include "tests/compiler/roads/junctions/random_roads.h"
#include "tests/test_files.h"

namespace citykiln::roads {
namespace {

// Gives points in one place one number.
class NodeIds {
 public:
  std::int64_t operator()(Vec2 p) {
    return numbers_.try_emplace({p.x, p.y}, static_cast<std::int64_t>(numbers_.size())).first->second;
  }

 private:
  std::map<std::pair<double, double>, std::int64_t> numbers_;
};

map::Track track_of(const Road& road, NodeIds& id_of) {
  map::Track track;
  track.id = road.id, track.surface = road.surface, track.section = road.section, track.points = road.points;
  track.axis = road.axis;
  for (const Vec2 p : track.axis) track.node_ids.push_back(id_of(p));
  return track;
}

// Each road with the axis of its track.
std::vector<Road> with_curves(std::vector<Road> roads) {
  NodeIds id_of;
  map::Features features;
  for (const Road& road : roads) features.tracks.push_back(track_of(road, id_of));
  Report report;
  const std::vector<map::Track> tracks = assume::curved_tracks(features, report);
  for (std::size_t r = 0; r < roads.size(); ++r) {
    roads[r].axis = tracks[r].axis;
    roads[r].points = tracks[r].points;
  }
  return roads;
}

TEST(CurvedJunctions, AreSoundHoweverRoadsMeet) {
  const Geos geos;
  std::mt19937_64 chance(20261130);
  Faults faults;
  int curved = 0;
  for (int round = 0, rounds = quick_or_full(5000, 100000); round < rounds; ++round) {
    const std::vector<Road> straight = random_roads(chance), roads = with_curves(straight);
    if (roads == straight) continue;
    ++curved;
    Report report;
    const std::vector<Junction> junctions = plan_junctions(roads, report);
    const auto outlines = outline_junctions(junctions, roads, 1);
    for (std::size_t j = 0; j < junctions.size(); ++j)
      count_faults(junctions[j], outlines[j], beyond_reach_m(roads), faults);
    ASSERT_EQ(faults.self_crossing, 0) << "round " << round;
    ASSERT_EQ(faults.beyond_reach, 0) << "round " << round;
  }
  EXPECT_GT(curved, quick_or_full(1000, 20000));
  RecordProperty("curved", curved);
  RecordProperty("spikes", faults.spikes);
}

}  // namespace
}  // namespace citykiln::roads
