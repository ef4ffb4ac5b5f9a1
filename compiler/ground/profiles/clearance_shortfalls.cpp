#include "compiler/ground/profiles/clearance_shortfalls.h"

#include <algorithm>
#include <tuple>

#include "compiler/contract/erase_repeated.h"
#include "compiler/ground/profiles/grade_rules.h"

namespace citykiln::ground {
namespace {

Vec2 place_along(const ProfileGraph& graph, const GraphWay& way, double at_m) {
  const std::uint32_t i = station_before(graph, way, at_m);
  const Station &a = graph.stations[way.first + i], &b = graph.stations[way.first + i + 1];
  const Vec2 from = graph.nodes[a.node].at, to = graph.nodes[b.node].at;
  return from + (to - from) * std::clamp((at_m - a.at_m) / (b.at_m - a.at_m), 0.0, 1.0);
}

struct WrittenHeights {
  const ProfileGraph& graph;
  const Profiles& profiles;
  const BelowBridges& below;

  double height_m(std::uint32_t w, double at_m) const {
    const GraphWay& way = graph.ways[w];
    const Profile& profile = profile_of(profiles, way);
    if (!profile.empty()) return knot_at(profile, at_m).z_m;
    // roads without profile lie at 0, paths without on the ground
    return is_graded(way.track->surface) || way.road == kNone ? 0 : below.ground_m(place_along(graph, way, at_m));
  }

  double shortfall_m(const Crossing& c) const {
    const double lower_m = c.lower == kNone ? c.lower_z_m : height_m(c.lower, c.lower_at_m);
    const double upper_m = c.upper == kNone ? c.upper_z_m : height_m(c.upper, c.upper_at_m);
    return lower_m + c.wanted_m - upper_m;
  }
};

}  // namespace

std::vector<ClearanceShortfall> find_shortfalls(const ProfileGraph& graph, const map::Features& features,
                                                const Profiles& profiles, const BelowBridges& below) {
  const WrittenHeights heights{graph, profiles, below};
  const auto id_of = [&](std::uint32_t way, OsmId outside) {
    return way == kNone ? outside : graph.ways[way].track->id.osm;
  };
  std::vector<ClearanceShortfall> all;
  for (const Crossing& c : find_crossings(graph, features, below))
    all.push_back({id_of(c.upper, c.outside), id_of(c.lower, c.outside), heights.shortfall_m(c), c.is_contradictory});
  // the largest of a pair first
  std::ranges::sort(all, {}, [](const ClearanceShortfall& s) { return std::tuple(s.upper, s.lower, -s.shortfall_m); });
  erase_repeated(all, [](const ClearanceShortfall& s) { return std::pair(s.upper, s.lower); });
  return all;
}

}  // namespace citykiln::ground
