#include "compiler/ground/profiles/plan_profiles.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "compiler/geometry/box_grid.h"
#include "compiler/ground/grading/road_influence.h"
#include "compiler/ground/profiles/crossings/clearances.h"
#include "compiler/ground/profiles/crossings/enforce_clearances.h"
#include "compiler/ground/profiles/crossings/ground_crossings.h"
#include "compiler/ground/profiles/crossings/lower_mouths.h"
#include "compiler/ground/profiles/cuttings.h"
#include "compiler/ground/profiles/diagnose_profiles.h"
#include "compiler/ground/profiles/known_lines.h"
#include "compiler/ground/profiles/plan_paths.h"
#include "compiler/ground/profiles/smoothing/grade_limits.h"
#include "compiler/ground/profiles/smoothing/initial_heights.h"
#include "compiler/ground/profiles/smoothing/profile_knots.h"
#include "compiler/ground/profiles/smoothing/smooth_profile.h"

namespace citykiln::ground {
namespace {

void report_free_ends(const ProfileGraph& graph, Report& report) {
  for (const GraphWay& way : graph.ways) {
    if (way.track->passage != map::Passage::kBridge) continue;
    const std::span<const Station> stations = graph.stations_of(way);
    for (const Station& end : {stations.front(), stations.back()})
      if (graph.nodes[end.node].is_free_end) report.add(Code::kBridgeWithoutGround, way.track->id.osm);
  }
}

// Ways that lie at height 0 on terrain at height 0, beyond the influence of all that does not. Long ways do not count:
// whether they have knots would depend on what is far away.
class LevelWays {
 public:
  LevelWays(const ProfileGraph& graph, const JunctionPlanes& planes, const map::Heightfield& heights)
      : graph_(graph), planes_(planes), heights_(heights) {
    std::vector<Box2> boxes;
    for (const GraphWay& way : graph.ways) {
      const std::span<const Station> stations = graph.stations_of(way);
      for (std::size_t s = 0; s + 1 < stations.size(); ++s)
        if (!is_level(stations[s].node) || !is_level(stations[s + 1].node))
          boxes.push_back(box_of(stations[s], stations[s + 1]));
    }
    raised_ = grid_of(boxes, kBucket_m);
  }

  bool contains(const GraphWay& way) const {
    const std::span<const Station> stations = graph_.stations_of(way);
    if (stations.back().at_m > kKnotStretch_m) return false;
    for (std::size_t s = 0; s + 1 < stations.size(); ++s)
      if (!is_level(stations[s].node) || !is_level(stations[s + 1].node) ||
          is_any_about(raised_, box_of(stations[s], stations[s + 1])))
        return false;
    return true;
  }

 private:
  static constexpr double kBucket_m = 64;

  bool is_level(std::uint32_t node) const {
    return planes_.z_m[node] == 0 && planes_.gradient[node] == Vec2{} &&
           height_m_at(heights_, graph_.nodes[node].at) == 0;
  }

  Box2 box_of(const Station& from, const Station& to) const {
    Box2 box;
    box.grow(graph_.nodes[from.node].at), box.grow(graph_.nodes[to.node].at);
    return box.widened(kGrading_m);
  }

  const ProfileGraph& graph_;
  const JunctionPlanes& planes_;
  const map::Heightfield& heights_;
  BoxGrid raised_;  // of pieces off height 0
};

// Heights by node, before and after crossings move lines.
struct SolvedHeights {
  std::vector<double> ground_m;
  JunctionPlanes planes;
};

SolvedHeights solve(const ProfileGraph& graph, const map::FeatureView& features, std::span<const Crossing> crossings,
                    const map::Heightfield& heights, std::span<const double> lines_m) {
  JunctionPlanes planes = fit_junction_planes(graph, smooth_heights(graph, lines_m, heights.longer_sample_step_m()));
  std::vector<double> ground_m = limit_grades(graph, planes.z_m);
  const std::vector<double> mouths_m = lower_mouths(graph, features, heights, ground_m);
  planes = fit_junction_planes(graph, clear_crossings(graph, crossings, &heights, mouths_m));
  planes.z_m = limit_grades(graph, planes.z_m);
  planes.z_m = enforce_clearances(graph, crossings, ground_m, planes.z_m);
  return {std::move(ground_m), std::move(planes)};
}

// The profiles of the lines of a graph, without the last step.
LineProfiles profiles_on(const ProfileGraph& graph, const map::FeatureView& features,
                         std::span<const roads::Road> roads, const TerrainWithoutRoads& terrain, Report& report) {
  assert(graph.limit_scale > 0);
  const map::Heightfield& heights = terrain.heights;
  const LandformIndex landforms = index_landforms(terrain.landforms);
  const std::vector<Crossing> crossings = find_crossings(
      graph, features, {terrain.streams, terrain.waters, [&](Vec2 p) { return height_m_at(heights, p); }});
  const std::vector<double> lines_m = initial_heights(graph, heights, landforms);
  const auto [ground_m, planes] = solve(graph, features, crossings, heights, lines_m);

  Profiles profiles{{roads.begin(), roads.end()}, {}, {}};
  profiles.off_ground.resize(static_cast<std::size_t>(std::ranges::count_if(features.tracks, leaves_ground)));
  const LevelWays level(graph, planes, heights);
  std::vector<std::vector<roads::Cutting>> cuttings = cuttings_of(graph, ground_m, planes.z_m);
  for (std::size_t w = 0; w < graph.ways.size(); ++w) {
    const GraphWay& way = graph.ways[w];
    if (way.road == kNone) {
      profiles.off_ground[way.off_ground] = knots_of(graph, way, planes);
    } else if (!level.contains(way)) {
      profiles.roads[way.road].profile = knots_of(graph, way, planes);
      profiles.roads[way.road].cuttings = std::move(cuttings[w]);
    }
  }
  diagnose_profiles(graph, lines_m, planes.z_m, report);
  diagnose_steps(graph, ground_crossings(graph.ways), planes.z_m, report);
  report_free_ends(graph, report);
  return {std::move(profiles), known_lines(graph, ground_m, planes.z_m, heights, landforms)};
}

}  // namespace

const Profile& profile_of(const Profiles& profiles, const GraphWay& way) {
  return way.road == kNone ? profiles.off_ground[way.off_ground] : profiles.roads[way.road].profile;
}

double height_m_of(const Profiles& profiles, const GraphWay& way, double at_m) {
  const Profile& profile = profile_of(profiles, way);
  return profile.empty() ? 0 : knot_at(profile, at_m).z_m;
}

LineProfiles plan_line_profiles(const map::FeatureView& features, std::span<const roads::Road> roads,
                                std::span<const roads::Junction> junctions, std::span<const roads::Strip> streams,
                                std::span<const LandCoverPolygon> waters, const map::Heightfield& heights,
                                Report& report, std::span<const Landform> landforms) {
  return profiles_on(graph_of(features, roads, junctions), features, roads, {streams, waters, heights, landforms},
                     report);
}

Profiles plan_profiles(const map::FeatureView& features, std::span<const roads::Road> roads,
                       std::span<const roads::Junction> junctions, std::span<const roads::Strip> streams,
                       std::span<const LandCoverPolygon> waters, const map::Heightfield& heights, Report& report,
                       std::span<const Landform> landforms) {
  return plan_profiles_on(graph_of(features, roads, junctions), features, roads, streams, waters, heights, report,
                          landforms);
}

Profiles plan_profiles_on(const ProfileGraph& graph, const map::FeatureView& features,
                          std::span<const roads::Road> roads, std::span<const roads::Strip> streams,
                          std::span<const LandCoverPolygon> waters, const map::Heightfield& heights, Report& report,
                          std::span<const Landform> landforms) {
  const TerrainWithoutRoads terrain{streams, waters, heights, landforms};
  return plan_paths(features, profiles_on(graph, features, roads, terrain, report).profiles, terrain, report);
}

}  // namespace citykiln::ground
