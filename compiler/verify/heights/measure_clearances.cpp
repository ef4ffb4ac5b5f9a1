#include "compiler/verify/heights/measure_clearances.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "compiler/contract/detail_tolerances.h"
#include "compiler/contract/erase_repeated.h"
#include "compiler/contract/system/for_each_slot.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/segment.h"
#include "compiler/ground/profiles/crossings/crossings.h"
#include "compiler/ground/profiles/graph/grade_rules.h"
#include "compiler/scene/graded_terrain.h"
#include "compiler/scene/land_cover.h"

namespace citykiln::verify {
namespace {

using map::LandCoverGroup;

/// The tolerance of the graded terrain: no kerbs.
constexpr double kTolerance_m = tolerances_with(Detail::kRoadSurfaces).below_m;
constexpr double kLineSample_m = 4, kWidest_m = 16, kLineBucket_m = 64;
constexpr double kFar_m = std::numeric_limits<double>::infinity();

enum class Kind { kBore, kGround, kDeck };

LandCoverGroup group_of(map::LandCoverClass surface) { return map::values_of(surface).group; }

/// The part of a ground road that a chunk holds, or a bridge or tunnel.
struct RoadLine {
  const roads::Road* road = nullptr;
  Kind kind{};
  int layer = 0;
  bool passes = true;  ///< False for corridors in buildings.

  std::pair<Kind, int> rank() const { return {kind, layer}; }
  /// False for a bridge or tunnel without a profile.
  bool has_height() const { return kind == Kind::kGround || !road->profile.empty(); }
  double half_m() const {
    return std::min(std::max(roads::widest_left_m(*road), roads::widest_right_m(*road)), kWidest_m);
  }
};

RoadLine road_line_of(const roads::Road& road) { return {&road, Kind::kGround, 0, true}; }

RoadLine road_line_of(const structures::Span& span, Kind kind) {
  const bool is_corridor = kind == Kind::kBore && group_of(span.surface) == LandCoverGroup::kPath && span.layer >= 0;
  const int default_layer = kind == Kind::kDeck ? 1 : -1;
  return {&span, kind, span.layer == 0 ? default_layer : span.layer, !is_corridor};
}

std::vector<RoadLine> road_lines_of(const scene::Chunk& chunk) {
  std::vector<RoadLine> lines;
  for (const roads::Road& road : chunk.roads) lines.push_back(road_line_of(road));
  for (const structures::Span& span : chunk.bridges) lines.push_back(road_line_of(span, Kind::kDeck));
  for (const structures::Span& span : chunk.tunnels) lines.push_back(road_line_of(span, Kind::kBore));
  return lines;
}

/// The graph of all lines; they are connected at common vertices.
struct Network {
  struct Edge {
    std::size_t from, to;
    double length_m;  ///< Weighted by the kind of line (joining_m).
    bool is_off = false;
  };
  std::vector<Vec2> places;  ///< Sorted.
  std::vector<bool> is_on_ground;
  std::vector<bool> is_deck_end, is_bore_end;  ///< If both are true, a bridge continues as a tunnel.
  std::vector<Edge> edges;                     ///< Both directions, sorted by `from`.

  std::size_t of(Vec2 p) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(places, p) - places.begin());
  }
};

double joining_m(map::LandCoverClass surface, double length_m) {
  if (group_of(surface) == LandCoverGroup::kRail) return ground::kRailJoins * length_m;
  return (ground::has_profile(surface) ? 1 : ground::kPathJoins) * length_m;
}

Network network_of(const scene::Scene& scene) {
  Network network;
  std::vector<RoadLine> lines;
  for (const scene::Chunk& chunk : scene.chunks)
    for (const RoadLine& line : road_lines_of(chunk)) lines.push_back(line);
  for (const RoadLine& line : lines)
    network.places.insert(network.places.end(), line.road->axis.begin(), line.road->axis.end());
  std::ranges::sort(network.places);
  network.places.erase(std::unique(network.places.begin(), network.places.end()), network.places.end());
  for (std::vector<bool>* flags : {&network.is_on_ground, &network.is_deck_end, &network.is_bore_end})
    flags->assign(network.places.size(), false);
  for (const RoadLine& line : lines) {
    const Polyline& axis = line.road->axis;
    for (std::size_t i = 0; i < axis.size(); ++i) {
      const std::size_t here = network.of(axis[i]);
      if (line.kind == Kind::kGround) network.is_on_ground[here] = true;
      const bool is_end = i == 0 || i + 1 == axis.size();
      if (is_end && line.kind == Kind::kDeck) network.is_deck_end[here] = true;
      if (is_end && line.kind == Kind::kBore) network.is_bore_end[here] = true;
      if (i == 0) continue;
      const std::size_t last = network.of(axis[i - 1]);
      const double length_m = joining_m(line.road->surface, distance(axis[i - 1], axis[i]));
      const bool is_off = line.kind != Kind::kGround;
      network.edges.push_back({last, here, length_m, is_off}), network.edges.push_back({here, last, length_m, is_off});
    }
  }
  const auto key = [](const Network::Edge& e) { return std::tuple(e.from, e.to, e.is_off); };
  std::ranges::sort(network.edges, {},
                    [](const Network::Edge& e) { return std::tuple(e.from, e.to, e.is_off, e.length_m); });
  // lines in several chunks give the same edges
  erase_repeated(network.edges, key);
  // a bridge end without another line ends on the ground
  for (std::size_t i = 0; i < network.edges.size(); ++i) {
    const std::size_t place = network.edges[i].from;
    const bool is_last = i + 1 == network.edges.size() || network.edges[i + 1].from != place;
    if (is_last && (i == 0 || network.edges[i - 1].from != place)) network.is_on_ground[place] = true;
  }
  return network;
}

/// A place on a segment of a line.
struct Place {
  const RoadLine* line = nullptr;
  std::size_t segment = 0;
  Vec2 at;

  Vec2 from() const { return line->road->axis[segment]; }
  Vec2 to() const { return line->road->axis[segment + 1]; }
};

/// Lines that a walk follows.
enum class Follow { kAll, kOnGround, kOffGround };

/// Visits the vertices connected to a place, nearest first (Dijkstra), until visit(place, run) returns false.
void walk(const Network& network, const Place& start, Follow follow,
          const std::function<bool(std::size_t, double)>& visit) {
  std::map<std::size_t, double> runs;
  std::vector<std::pair<double, std::size_t>> queue;
  const auto reach = [&](std::size_t place, double run_m) {
    const auto known = runs.find(place);
    if (run_m > ground::kJoined_m || (known != runs.end() && known->second <= run_m)) return;
    runs[place] = run_m;
    queue.emplace_back(run_m, place);
    std::ranges::push_heap(queue, std::greater<>());
  };
  for (const Vec2 end : {start.from(), start.to()})
    reach(network.of(end), joining_m(start.line->road->surface, distance(start.at, end)));
  while (!queue.empty()) {
    std::ranges::pop_heap(queue, std::greater<>());
    const auto [run_m, place] = queue.back();
    queue.pop_back();
    if (run_m > runs[place]) continue;
    if (!visit(place, run_m)) return;
    auto edge = std::ranges::lower_bound(network.edges, place, {}, &Network::Edge::from);
    for (; edge != network.edges.end() && edge->from == place; ++edge)
      if (follow == Follow::kAll || edge->is_off == (follow == Follow::kOffGround))
        reach(edge->to, run_m + edge->length_m);
  }
}

bool are_joined(const Network& network, const Place& a, const Place& b) {
  bool joined = false;
  walk(network, a, Follow::kAll, [&](std::size_t place, double run_m) {
    for (const Vec2 end : {b.from(), b.to()})
      joined |= network.places[place] == end &&
                run_m + joining_m(b.line->road->surface, distance(end, b.at)) <= ground::kJoined_m;
    return !joined;
  });
  return joined;
}

/// True if a bridge or tunnel reaches the ground close to another line, or a bridge continues there as a tunnel.
bool lands_on(const Network& network, const Place& on, const RoadLine& other) {
  if (on.line->kind == Kind::kGround) return false;
  const double reach_m = on.line->half_m() + other.half_m();
  bool lands = false;
  walk(network, on, Follow::kOffGround, [&](std::size_t place, double) {
    const bool is_landing = network.is_on_ground[place] || (network.is_deck_end[place] && network.is_bore_end[place]);
    lands |= is_landing && distance_to_polyline(other.road->axis, network.places[place]) < reach_m;
    return !lands;
  });
  return lands;
}

/// True if a line on the ground goes on as a bridge or tunnel at one of these ends.
bool leads_to(const Network& network, const Place& on_ground, std::span<const Vec2> ends) {
  if (on_ground.line->kind != Kind::kGround || ends.empty()) return false;
  bool leads = false;
  walk(network, on_ground, Follow::kOnGround, [&](std::size_t place, double) {
    leads |= std::ranges::find(ends, network.places[place]) != ends.end();
    return !leads;
  });
  return leads;
}

std::optional<Vec2> intersection(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const auto shares = crossing_shares(a, b, c, d);
  if (!shares) return std::nullopt;
  return a + (b - a) * shares->first;
}

/// The largest clearance shortfall between two objects.
struct Worst {
  double shortfall_m = 0;
  Vec2 at;
};
using Pairs = std::map<std::pair<OsmId, OsmId>, Worst>;

class Measurer {
 public:
  Measurer(const scene::Header& header, const scene::Chunk& chunk, const Network& network)
      : header_(header),
        chunk_(chunk),
        network_(network),
        box_(scene::box_of(header, chunk.tile)),
        lines_(road_lines_of(chunk)) {
    std::vector<Box2> boxes;
    for (const RoadLine& line : lines_) {
      for (std::size_t i = 0; i + 1 < line.road->axis.size(); ++i) {
        segments_.push_back({&line, i, {}});
        boxes.push_back(box_of(std::span(line.road->axis).subspan(i, 2)));
      }
    }
    grid_ = grid_of(boxes, kLineBucket_m);
  }

  Pairs run() {
    for (const RoadLine& line : lines_) {
      if (line.kind == Kind::kGround || !line.passes || !line.has_height()) continue;
      cross_lines(line);
      run_along(line);
      if (line.kind == Kind::kDeck) cross_water(line);
    }
    return std::move(pairs_);
  }

 private:
  bool is_here(Vec2 p) const { return box_.min.x <= p.x && p.x < box_.max.x && box_.min.y <= p.y && p.y < box_.max.y; }

  double ground_m(Vec2 p) {
    if (!graded_) graded_.emplace(scene::graded_terrain_of(header_, chunk_, kTolerance_m));
    return ground::land_m(*graded_, p);
  }

  double height_m(const Place& place) {
    assert(place.line->has_height());
    const roads::Road& road = *place.line->road;
    if (road.profile.empty()) return ground_m(place.at);
    return knot_at(road.profile, roads::distances_along(road)[place.segment] + distance(place.from(), place.at)).z_m;
  }

  void add(OsmId upper, OsmId lower, double shortfall_m, Vec2 at) {
    const auto [pair, is_new] = pairs_.try_emplace({upper, lower}, Worst{shortfall_m, at});
    if (shortfall_m > pair->second.shortfall_m) pair->second = {shortfall_m, at};
  }

  void add(const Place& a, const Place& b) {
    if (a.line->rank() == b.line->rank() || !b.line->passes || !b.line->has_height()) return;
    const bool is_above = a.line->rank() > b.line->rank();
    const Place &upper = is_above ? a : b, &lower = is_above ? b : a;
    if (are_joined(network_, upper, lower) || passes_a_mouth(upper, lower)) return;
    const double wanted_m = ground::wanted_clearance_m(upper.line->road->surface, lower.line->road->surface);
    add(upper.line->road->id.osm, lower.line->road->id.osm, height_m(lower) + wanted_m - height_m(upper), upper.at);
  }

  void cross_lines(const RoadLine& line) {
    const Polyline& axis = line.road->axis;
    for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
      for (const std::uint32_t s : boxes_about(grid_, box_of(std::span(axis).subspan(i, 2)))) {
        const Place& other = segments_[s];
        if (other.line == &line) continue;
        const auto at = intersection(axis[i], axis[i + 1], other.from(), other.to());
        if (at && is_here(*at)) add({&line, i, *at}, {other.line, other.segment, *at});
      }
    }
  }

  void run_along(const RoadLine& line) {
    const Polyline& axis = line.road->axis;
    for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
      const int pieces = std::max(1, static_cast<int>(std::ceil(distance(axis[i], axis[i + 1]) / kLineSample_m)));
      for (int k = 0; k <= pieces; ++k) {
        const Place here{&line, i, axis[i] + (axis[i + 1] - axis[i]) * (static_cast<double>(k) / pieces)};
        if (is_here(here.at)) look_about(here);
      }
    }
  }

  void look_about(const Place& here) {
    Box2 box;
    box.grow(here.at);
    for (const std::uint32_t s : boxes_about(grid_, box.widened(here.line->half_m() + kWidest_m))) {
      const Place& other = segments_[s];
      if (other.line == here.line || is_a_path_of_ground(*other.line)) continue;
      const Place foot{other.line, other.segment, nearest_point(other.from(), other.to(), here.at)};
      const double apart_m = distance(here.at, foot.at);
      if (apart_m >= here.line->half_m() + other.line->half_m()) continue;
      if (are_side_by_side(*here.line, *other.line, apart_m)) continue;
      if (lands_on(network_, here, *other.line) || lands_on(network_, foot, *here.line)) continue;
      if (!leads_to(network_, foot, twin_ends(*here.line))) add(here, foot);
    }
  }

  /// True for two bridges or two tunnels that overlap if neither axis is over the other's carriageway.
  static bool are_side_by_side(const RoadLine& a, const RoadLine& b, double apart_m) {
    return a.kind == b.kind && apart_m >= std::max(a.half_m(), b.half_m());
  }

  /// Returns the ends of other bridges or tunnels of the same kind and layer that lie beside a line.
  std::vector<Vec2> twin_ends(const RoadLine& beside) const {
    std::vector<Vec2> ends;
    for (const RoadLine& line : lines_)
      if (&line != &beside && line.kind != Kind::kGround && line.rank() == beside.rank())
        for (const Vec2 end : {line.road->axis.front(), line.road->axis.back()})
          if (distance_to_polyline(beside.road->axis, end) < kWidest_m) ends.push_back(end);
    return ends;
  }

  static bool passes_a_mouth(const Place& upper, const Place& lower) {
    const Polyline& axis = lower.line->road->axis;
    return lower.line->kind == Kind::kBore && is_a_path_of_ground(*upper.line) &&
           std::min(distance(axis.front(), lower.at), distance(axis.back(), lower.at)) < ground::kMouth_m;
  }

  static bool is_a_path_of_ground(const RoadLine& line) {
    return line.kind == Kind::kGround && !ground::has_profile(line.road->surface);
  }

  void cross_water(const RoadLine& line) {
    const Polyline& axis = line.road->axis;
    for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
      for (const roads::Strip& stream : chunk_.watercourses) cross_stream({&line, i, {}}, stream);
      for (const ground::LandCoverPolygon& water : chunk_.surfaces)
        if (water.level_m) cross_standing({&line, i, {}}, water);
    }
  }

  void cross_stream(Place place, const roads::Strip& stream) {
    const std::vector<double> along = roads::distances_along(stream.axis, stream.start_along_m);
    for (std::size_t i = 0; i + 1 < stream.axis.size(); ++i) {
      const auto at = intersection(place.from(), place.to(), stream.axis[i], stream.axis[i + 1]);
      if (!at || !is_here(*at)) continue;
      place.at = *at;
      const double water_m = stream.profile.empty()
                                 ? height_m_at(chunk_.heights, *at)
                                 : knot_at(stream.profile, along[i] + distance(stream.axis[i], *at)).z_m;
      const double wanted_m = ground::wanted_clearance_over_water_m(stream.left_m + stream.right_m);
      add(place.line->road->id.osm, stream.id.osm, water_m + wanted_m - height_m(place), *at);
    }
  }

  void cross_standing(Place place, const ground::LandCoverPolygon& water) {
    const int pieces = std::max(1, static_cast<int>(std::ceil(distance(place.from(), place.to()) / kLineSample_m)));
    for (int k = 0; k <= pieces; ++k) {
      place.at = place.from() + (place.to() - place.from()) * (static_cast<double>(k) / pieces);
      int winding = 0;
      for (const Ring& ring : water.rings) winding += is_here(place.at) ? winding_number(ring, place.at) : 0;
      if (winding > 0)
        add(place.line->road->id.osm, water.id.osm, *water.level_m + ground::kClearanceOverWater_m - height_m(place),
            place.at);
    }
  }

  const scene::Header& header_;
  const scene::Chunk& chunk_;
  const Network& network_;
  Box2 box_;
  std::vector<RoadLine> lines_;
  std::vector<Place> segments_;
  BoxGrid grid_;
  std::optional<ground::GradedTerrain> graded_;
  Pairs pairs_;
};

}  // namespace

Clearances measure_clearances(const scene::Scene& scene, int threads) {
  const Network network = network_of(scene);
  const auto of_tiles = for_each_slot<Pairs>(scene.chunks.size(), threads, [&](std::size_t i) {
    return Measurer(scene.header, scene.chunks[i], network).run();
  });
  Pairs all;
  for (const Pairs& pairs : of_tiles) {
    for (const auto& [pair, worst] : pairs) {
      const auto [known, is_new] = all.try_emplace(pair, worst);
      if (worst.shortfall_m > known->second.shortfall_m) known->second = worst;
    }
  }
  Clearances sum;
  sum.crossings = all.size();
  for (const auto& [pair, worst] : all)
    if (worst.shortfall_m > ground::kShortfallMargin_m)
      sum.shortfalls.push_back({worst.shortfall_m, pair.first, pair.second, worst.at});
  std::ranges::stable_sort(sum.shortfalls, std::ranges::greater{}, &ClearanceShortfall::missing_m);
  return sum;
}

Clearances with_findings(Clearances clearances, std::span<const outputs::Finding> findings) {
  std::map<std::pair<OsmId, OsmId>, const outputs::Finding*> by_pair;
  for (const outputs::Finding& finding : findings) {
    const Diagnosis& d = finding.diagnosis;
    if (d.code == Code::kClearanceNotMet || d.code == Code::kLayersContradict) by_pair[{d.object, d.other}] = &finding;
  }
  std::vector<ClearanceShortfall> all = std::exchange(clearances.shortfalls, {});
  for (ClearanceShortfall& s : all) {
    const auto found = by_pair.find({s.upper, s.lower});
    const bool is_known = found != by_pair.end();
    if (is_known) s.tags = found->second->tags;
    const bool is_contradictory = is_known && found->second->diagnosis.code == Code::kLayersContradict;
    (is_contradictory ? clearances.contradictions : clearances.shortfalls).push_back(std::move(s));
  }
  return clearances;
}

std::uint64_t Clearances::count_over(double missing_m) const {
  return static_cast<std::uint64_t>(
      std::ranges::count_if(shortfalls, [&](const ClearanceShortfall& s) { return s.missing_m > missing_m; }));
}

}  // namespace citykiln::verify
