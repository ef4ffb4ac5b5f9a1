#include "compiler/invent/town/railway.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/segment.h"
#include "compiler/geometry/trig.h"
#include "compiler/invent/tags.h"
#include "compiler/invent/town/blocks/house_tags.h"
#include "compiler/invent/town/draws.h"
#include "compiler/invent/town/least_cost_path.h"
#include "compiler/invent/town/streets/road_curve.h"

namespace citykiln::invent {
namespace {

/// Half the straight track at a station.
constexpr double kStationHalf_m = 95;
/// Half of a bridge over the railway.
constexpr double kOverbridgeHalf_m = 30;
/// Steps of the raster of land near tracks, and its distance from them.
constexpr double kTrackLandStep_m = 6;
constexpr double kTrackLand_m = 17;

// where a line leaves the square
Vec2 end_on_border(double half_m, Vec2 from, Vec2 direction) {
  double run_m = 4 * half_m;
  if (std::abs(direction.x) > 1e-9)
    run_m = std::min(run_m, (half_m - from.x * (direction.x > 0 ? 1 : -1)) / std::abs(direction.x));
  if (std::abs(direction.y) > 1e-9)
    run_m = std::min(run_m, (half_m - from.y * (direction.y > 0 ? 1 : -1)) / std::abs(direction.y));
  const Vec2 p = from + direction * run_m;
  return {std::clamp(p.x, -half_m, half_m), std::clamp(p.y, -half_m, half_m)};
}

RoadCosts track_costs(const TownPlan& plan) {
  RoadCosts costs = road_costs(plan);
  costs.usual_grade = 0.014;
  costs.wet_cost = 8;
  return costs;
}

// draws a station and its direction; false if it is wet or too near to the border
bool draw_station(const TownPlan& plan, Railway& railway, std::uint64_t attempt) {
  Draws draws(plan.settings.seed, "railway", attempt);
  const Centre& centre = plan.centres[0];
  railway.along = direction_of(draws.unit());
  railway.town = left_of(railway.along);
  const double away_m = std::clamp(centre.radius_m * 0.42, 190.0, 650.0) * draws.between(0.85, 1.15);
  railway.station = centre.position - railway.town * away_m;
  for (const double along_m : {-100.0, -50.0, 0.0, 50.0, 100.0})
    for (const double town_m : {-16.0, 36.0}) {
      const Vec2 p = railway.at(along_m, town_m);
      const double border_m = plan.half_m() - std::max(std::abs(p.x), std::abs(p.y));
      if (border_m < 40 || plan.water.at(p) < 25 || length(plan.terrain->gradient(p)) > 0.07) return false;
    }
  return true;
}

Polyline track_axis(const TownPlan& plan, const Railway& railway) {
  const RoadCosts costs = track_costs(plan);
  const Vec2 first = railway.at(-kStationHalf_m, 0), last = railway.at(kStationHalf_m, 0);
  Polyline before = least_cost_path(costs, end_on_border(plan.half_m(), first, railway.along * -1), first);
  Polyline after = least_cost_path(costs, last, end_on_border(plan.half_m(), last, railway.along));
  if (before.size() < 2 || after.size() < 2) return {};
  before.front() = end_on_border(plan.half_m(), first, railway.along * -1);
  after.back() = end_on_border(plan.half_m(), last, railway.along);
  Polyline control = simplified_path(before, 30);
  control.back() = railway.at(-kStationHalf_m, 0);
  control.push_back(railway.at(-kStationHalf_m / 2, 0));
  control.push_back(railway.at(kStationHalf_m / 2, 0));
  Polyline rest = simplified_path(after, 30);
  rest.front() = railway.at(kStationHalf_m, 0);
  control.insert(control.end(), rest.begin(), rest.end());
  Polyline axis = with_even_steps(without_corners(control, 4), 15);
  for (Vec2& p : axis) p = on_place_grid(p);
  return axis;
}

void mark_track_land(TownPlan& plan) {
  plan.tracks = TownRaster<char>(plan.settings.side_m, kTrackLandStep_m);
  for (const Vec2 p : with_even_steps(plan.railway.axis, kTrackLandStep_m))
    for (int row = plan.tracks.row(p.y - kTrackLand_m); row <= plan.tracks.row(p.y + kTrackLand_m); ++row)
      for (int column = plan.tracks.column(p.x - kTrackLand_m); column <= plan.tracks.column(p.x + kTrackLand_m);
           ++column)
        if (distance(plan.tracks.place(column, row), p) <= kTrackLand_m)
          plan.tracks.values[plan.tracks.index(column, row)] = 1;
  for (double along_m = -104; along_m <= 104; along_m += kTrackLandStep_m / 2)
    for (double town_m = -20; town_m <= 40; town_m += kTrackLandStep_m / 2)
      plan.tracks.nearest(plan.railway.at(along_m, town_m)) = 1;
}

// the segments of a road on both sides of one, up to half a bridge; empty if there is a junction among them
std::vector<std::uint32_t> bridge_segments(const StreetGraph& graph, std::uint32_t segment, Vec2 middle) {
  std::vector<std::uint32_t> bridge = {segment};
  for (std::uint32_t at : {graph.segments()[segment].a, graph.segments()[segment].b}) {
    std::uint32_t last = segment;
    while (distance(graph.position(at), middle) < kOverbridgeHalf_m) {
      if (graph.degree(at) != 2) return {};
      const auto& both = graph.vertices()[at].segments;
      last = both[0] == last ? both[1] : both[0];
      at = graph.other_end(last, at);
      bridge.push_back(last);
    }
    if (graph.degree(at) != 2) return {};
  }
  return bridge;
}

bool wants_bridge(const TownPlan& plan, StreetClass c) {
  return c == StreetClass::kPrimary || (plan.settings.kind == TownKind::kCity && c <= StreetClass::kSecondary);
}

// the segment that crosses a piece of track, the number of segments if none
std::uint32_t road_across(const StreetGraph& graph, Vec2 a, Vec2 b, double& share) {
  for (const std::uint32_t s : graph.near(box_of(std::vector{a, b}))) {
    const StreetSegment& segment = graph.segments()[s];
    if (segment.is_bridge) continue;
    if (const auto shares = crossing_shares(a, b, graph.position(segment.a), graph.position(segment.b))) {
      share = shares->first;
      return s;
    }
  }
  return static_cast<std::uint32_t>(graph.segments().size());
}

}  // namespace

void plan_railway(TownPlan& plan) {
  if (plan.settings.kind == TownKind::kVillage || plan.settings.side_m < 650) return;
  for (std::uint64_t attempt = 0; attempt < 24; ++attempt) {
    if (!draw_station(plan, plan.railway, attempt)) continue;
    plan.railway.axis = track_axis(plan, plan.railway);
    if (plan.railway.axis.size() < 2) continue;
    plan.railway.has_station = true;
    return mark_track_land(plan);
  }
  plan.railway = {};
}

std::vector<Vec2> cross_railway(const TownPlan& plan, StreetGraph& graph) {
  std::vector<Vec2> level;
  const Polyline& axis = plan.railway.axis;
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
    double share = 0;
    for (int roads = 0; roads < 4; ++roads) {
      const std::uint32_t s = road_across(graph, axis[i], axis[i + 1], share);
      if (s == graph.segments().size()) break;
      const Vec2 p = on_place_grid(axis[i] + (axis[i + 1] - axis[i]) * share);
      if (std::ranges::find(level, p) != level.end()) break;
      const auto bridge = wants_bridge(plan, graph.street_of(s).street_class) ? bridge_segments(graph, s, p)
                                                                              : std::vector<std::uint32_t>{};
      for (const std::uint32_t part : bridge) graph.make_bridge(part);
      if (!bridge.empty()) continue;
      graph.split(s, p);
      level.push_back(p);
      break;
    }
  }
  return level;
}

void join_station(const TownPlan& plan, StreetGraph& graph) {
  if (!plan.railway.has_station) return;
  const Vec2 square = plan.railway.at(0, 40);
  std::uint32_t best = kNoStreetVertex;
  double least_m = 260;
  const std::uint32_t end = graph.add_vertex(square);
  for (const std::uint32_t s : graph.near(box_of(std::vector{square}).widened(least_m)))
    for (const std::uint32_t v : {graph.segments()[s].a, graph.segments()[s].b}) {
      const double away_m = distance(graph.position(v), square);
      const Vec2 back = unit(square - graph.position(v));
      const bool is_plain = graph.degree(v) == 2 && !graph.segments()[s].is_bridge && !graph.street_of(s).is_roundabout;
      if (!is_plain || away_m >= least_m || away_m < 12 || dot(back, plan.railway.town) > -0.5) continue;
      if (std::abs(dot(graph.direction_from(v, s), back)) > 0.64 || !graph.is_clear(end, v)) continue;
      least_m = away_m;
      best = v;
    }
  if (best == kNoStreetVertex) return;
  graph.streets.push_back({StreetClass::kResidential, "Bahnhofstraße"});
  graph.add_segment(best, end, static_cast<std::uint32_t>(graph.streets.size() - 1));
}

namespace {

/// A rectangle beside the station's track.
Ring beside_track(const Railway& railway, double from_m, double to_m, double near_m, double far_m) {
  Ring ring = {on_place_grid(railway.at(from_m, near_m)), on_place_grid(railway.at(to_m, near_m)),
               on_place_grid(railway.at(to_m, far_m)), on_place_grid(railway.at(from_m, far_m))};
  if (signed_area_m2(ring) < 0) std::ranges::reverse(ring);
  return ring;
}

Tags track_tags() {
  return tags_of({{"railway", "rail"},
                  {"usage", "main"},
                  {"electrified", "contact_line"},
                  {"gauge", "1435"},
                  {"maxspeed", "120"}});
}

// the axis with vertices at level crossings
Polyline axis_with_crossings(const Polyline& axis, const std::vector<Vec2>& crossings) {
  Polyline line;
  for (std::size_t i = 0; i < axis.size(); ++i) {
    line.push_back(axis[i]);
    if (i + 1 == axis.size()) break;
    std::vector<std::pair<double, Vec2>> here;
    for (const Vec2 p : crossings)
      if (distance_to_segment(axis[i], axis[i + 1], p) < 0.1 && p != axis[i] && p != axis[i + 1])
        here.push_back({distance(axis[i], p), p});
    std::ranges::sort(here);
    for (const auto& [at_m, p] : here) line.push_back(p);
  }
  return line;
}

// cuts the axis where it goes onto water and off it: these parts are bridges
void add_track_lines(const TownPlan& plan, const Polyline& axis, InventedMap& map) {
  Polyline part;
  bool is_bridge = false;
  const auto flush = [&] {
    Tags tags = track_tags();
    if (is_bridge) {
      set_tag(tags, "bridge", "yes");
      set_tag(tags, "layer", "1");
    }
    if (part.size() > 1) map.lines.push_back({part, std::move(tags)});
  };
  for (std::size_t i = 0; i < axis.size(); ++i) {
    part.push_back(axis[i]);
    const bool is_wet_next = i + 1 < axis.size() && (plan.water.at(axis[i]) < 8 || plan.water.at(axis[i + 1]) < 8);
    if (i + 1 == axis.size() || is_wet_next == is_bridge) continue;
    flush();
    part = {axis[i]};
    is_bridge = is_wet_next;
  }
  flush();
}

bool has_vertex(const Polyline& axis, Vec2 p) { return std::ranges::find(axis, p) != axis.end(); }

// the vertex of the axis nearest to a place
Vec2 vertex_near(const Polyline& axis, Vec2 p) {
  return *std::ranges::min_element(axis, {}, [&](Vec2 q) { return distance(p, q); });
}

void add_siding(const Railway& railway, InventedMap& map) {
  const Polyline siding = {vertex_near(railway.axis, railway.at(-88, 0)), on_place_grid(railway.at(-62, -4.5)),
                           on_place_grid(railway.at(62, -4.5)), vertex_near(railway.axis, railway.at(88, 0))};
  Tags tags = track_tags();
  set_tag(tags, "service", "siding");
  set_tag(tags, "usage", "");
  if (has_vertex(railway.axis, siding.front())) map.lines.push_back({siding, std::move(tags)});
}

void add_platform(const Railway& railway, double near_m, double far_m, InventedMap& map) {
  map.areas.push_back(
      {{beside_track(railway, -60, 60, near_m, far_m), {}},
       tags_of({{"railway", "platform"}, {"public_transport", "platform"}, {"surface", "paving_stones"}})});
  const double middle_m = (near_m + far_m) / 2;
  for (int i = -4; i <= 4; ++i) {
    const char* what = i % 2 ? "bench" : "waste_basket";
    map.points.push_back({on_place_grid(railway.at(i * 12 + 3, middle_m)), tags_of({{"amenity", what}})});
    map.points.push_back({on_place_grid(railway.at(i * 13, middle_m)), tags_of({{"highway", "street_lamp"}})});
  }
  for (const double along_m : {-25.0, 25.0})
    map.points.push_back({on_place_grid(railway.at(along_m, middle_m)), tags_of({{"amenity", "shelter"}})});
}

void add_station(const TownPlan& plan, InventedMap& map) {
  const Railway& railway = plan.railway;
  Draws draws(plan.settings.seed, "station", 0);
  add_siding(railway, map);
  add_platform(railway, 1.9, 5.2, map);
  add_platform(railway, -9.6, -6.4, map);
  Tags tags = tags_of({{"building", "train_station"},
                       {"building:levels", "2"},
                       {"roof:shape", "hipped"},
                       {"roof:levels", "1"},
                       {"roof:colour", "#8f4a36"},
                       {"name", "Bahnhof"}});
  paint_walls(tags, draws);
  map.areas.push_back({{beside_track(railway, -21, 21, 6.5, 18), {}}, std::move(tags)});
  map.areas.push_back({{beside_track(railway, -32, 32, 19, 34), {}},
                       tags_of({{"highway", "pedestrian"},
                                {"area", "yes"},
                                {"surface", "paving_stones"},
                                {"place", "square"},
                                {"name", "Bahnhofsplatz"}})});
  for (const double along_m : {-26.0, -18.0, 18.0, 26.0})
    map.points.push_back(
        {on_place_grid(railway.at(along_m, 28)), tags_of({{"leaf_type", "broadleaved"}, {"natural", "tree"}})});
  map.points.push_back({on_place_grid(railway.at(10, 24)), tags_of({{"amenity", "clock"}})});
  map.points.push_back({on_place_grid(railway.at(-10, 31)), tags_of({{"amenity", "bicycle_parking"}})});
  map.areas.push_back(
      {{beside_track(railway, 38, 92, 12, 32), {}}, tags_of({{"amenity", "parking"}, {"surface", "asphalt"}})});
}

}  // namespace

void add_railway(const TownPlan& plan, const std::vector<Vec2>& level_crossings, InventedMap& map) {
  if (plan.railway.axis.size() < 2) return;
  add_track_lines(plan, axis_with_crossings(plan.railway.axis, level_crossings), map);
  for (const Vec2 p : level_crossings)
    map.points.push_back({p, tags_of({{"railway", "level_crossing"}, {"crossing:barrier", "half"}})});
  if (plan.railway.has_station) add_station(plan, map);
}

}  // namespace citykiln::invent
