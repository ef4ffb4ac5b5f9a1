#include "compiler/things/railings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <set>

#include "compiler/contract/derived_id.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/plane/plane.h"
#include "compiler/things/free_places.h"

namespace citykiln::things {
namespace {

using ground::LandCoverPolygon;
using map::LandCoverClass;
using map::LandCoverGroup;

constexpr double kEdgeStep_m = 1.5, kShortestRailing_m = 3, kThickness_m = 0.0625;
// Ways that are less parallel to an edge than this lead across it.
constexpr double kParallel = 0.8;
constexpr double kObstacleBucket_m = 16;
// Points this near to the line between their neighbours are left out.
constexpr double kStraight_m = 0.02;
// A retaining wall that stands this high above the upper ground is a parapet.
constexpr double kParapetHeight_m = 0.8;

// A segment beside which there is no railing.
struct Obstacle {
  Vec2 a{}, b{};
  double radius_m = 0;
  OsmId way{};                  // of a way that may lead across an edge
  bool is_only_across = false;  // true for ways
  double above_foot_m = 0;      // of a retaining wall, its tagged height
};

struct Obstacles {
  std::vector<Obstacle> all;
  BoxGrid grid;
};

void add_line(const Polyline& axis, const Obstacle& traits, std::vector<Obstacle>& all) {
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
    all.push_back(traits);
    all.back().a = axis[i], all.back().b = axis[i + 1];
  }
}

void add_doors(const buildings::Building& building, std::vector<Obstacle>& all) {
  const Ring& ring = building.footprint.outer;
  for (std::size_t e = 0; e < building.facade_edges.size(); ++e)
    for (std::uint32_t slot = 0; slot < buildings::kDoorSlots; ++slot) {
      if ((building.facade_edges[e].doors >> slot & 1) == 0) continue;
      const Vec2 a = ring[e], b = ring[(e + 1) % ring.size()];
      const Vec2 at = a + (b - a) * ((slot + 0.5) / buildings::kDoorSlots);
      all.push_back({.a = at, .b = at, .radius_m = kRailingClear_m});
    }
}

Obstacles obstacles_of(const map::FeatureView& features, const RailingSurroundings& around) {
  Obstacles found;
  for (const map::Barrier& barrier : features.barriers) {
    if (barrier.kind == map::BarrierKind::kKerb) continue;
    const bool retains = barrier.kind == map::BarrierKind::kRetainingWall;
    add_line(barrier.axis, {.radius_m = kRailingClear_m, .above_foot_m = retains ? barrier.height_m : 0}, found.all);
  }
  for (const structures::Span& bridge : around.bridges)
    add_line(bridge.axis, {.radius_m = roads::max_offset_m(bridge) + kRailingClear_m}, found.all);
  for (const roads::Road& road : around.roads) {
    const double half_m = std::max(left_m(road), right_m(road));
    add_line(road.axis, {.radius_m = half_m + 0.5, .way = road.id.osm, .is_only_across = true}, found.all);
  }
  for (const buildings::Building& building : around.buildings) add_doors(building, found.all);
  std::vector<Box2> boxes;
  for (const Obstacle& o : found.all) boxes.push_back(box_of_segment(o.a, o.b).widened(o.radius_m));
  found.grid = grid_of(boxes, kObstacleBucket_m);
  return found;
}

// A place on an edge of walked land cover.
enum class EdgeState : std::uint8_t { kFlat, kDrop, kBlocked };
struct EdgePlace {
  Vec2 at, out;  // out: away from the polygon, length 1
  EdgeState state{};
};

// The data of all edges.
struct EdgePlanner {
  const map::FeatureView& features;
  const ground::GradedTerrain& ground;
  Obstacles obstacles;
  FreePlaces places;
};

bool is_blocked(const EdgePlanner& planner, const EdgePlace& place, OsmId own, double drop_m) {
  for (const std::uint32_t i : boxes_about(planner.obstacles.grid, place.at)) {
    const Obstacle& o = planner.obstacles.all[i];
    if (o.is_only_across && o.way == own) continue;
    if (distance_to_segment(o.a, o.b, place.at) > o.radius_m) continue;
    if (o.above_foot_m > 0 && o.above_foot_m < drop_m + kParapetHeight_m) continue;
    if (o.is_only_across && std::abs(cross(unit(o.b - o.a), place.out)) > kParallel) continue;
    return true;
  }
  return false;
}

// True if a way other than `own` crosses a line.
bool is_crossed(const EdgePlanner& planner, Vec2 a, Vec2 b, OsmId own) {
  return std::ranges::any_of(boxes_about(planner.obstacles.grid, box_of_segment(a, b)), [&](std::uint32_t i) {
    const Obstacle& o = planner.obstacles.all[i];
    return o.is_only_across && o.way != own && crossing_shares(a, b, o.a, o.b).has_value();
  });
}

// The height of the ground with its own layer; empty without ground that one can fall to.
std::optional<double> foot_m(EdgePlanner& planner, Vec2 p, LandCoverClass from) {
  const LandCoverPolygon* below = planner.places.polygon_at(p);
  if (below == nullptr) return land_m(planner.ground, p);
  const LandCoverGroup group = map::values_of(below->surface).group;
  if (group == LandCoverGroup::kBuilding || below->surface == LandCoverClass::kPool) return std::nullopt;
  if (group == LandCoverGroup::kRail && from == LandCoverClass::kPlatform) return std::nullopt;
  return layer_height_m(heights_at(planner.ground, p), face_height_of(*below));
}

EdgeState state_of(EdgePlanner& planner, const EdgePlace& place, const LandCoverPolygon& walked) {
  const Vec2 inside = place.at - place.out * kInsideEdge_m, beyond = place.at + place.out * kFallWithin_m;
  if (!planner.features.extent.contains(inside) || !planner.features.extent.contains(beyond)) return EdgeState::kFlat;
  const double high_m = land_m(planner.ground, inside);
  // the land first, since it is the cheaper test: no other layer is lower by more than a kerb, except water
  const LandCoverPolygon* top = planner.places.polygon_at(inside);
  if (top == nullptr || top->id != walked.id || top->surface != walked.surface) return EdgeState::kFlat;
  const std::optional<double> low_m = foot_m(planner, beyond, walked.surface);
  if (!low_m) return EdgeState::kBlocked;
  const double drop_m = high_m - *low_m;
  if (drop_m <= kGuardedDrop_m) return EdgeState::kFlat;
  return is_blocked(planner, place, walked.id.osm, drop_m) ? EdgeState::kBlocked : EdgeState::kDrop;
}

// Places on each edge, in the order of the ring, at equal distances of at most kEdgeStep_m.
std::vector<EdgePlace> places_on(EdgePlanner& planner, const Ring& ring, const LandCoverPolygon& walked) {
  std::vector<EdgePlace> places;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
    if (a == b || !planner.features.extent.touches(box_of_segment(a, b))) continue;
    const Vec2 out = left_of(unit(b - a)) * -1.0;
    const int count = std::max(1, static_cast<int>(std::ceil(distance(a, b) / kEdgeStep_m)));
    for (int k = 0; k < count; ++k) {
      EdgePlace place{a + (b - a) * ((k + 0.5) / count), out, {}};
      place.state = state_of(planner, place, walked);
      places.push_back(place);
    }
  }
  return places;
}

// A single level place between two drops belongs to them, since corners of polygons make such places.
void close_gaps(std::vector<EdgePlace>& places) {
  const std::vector<EdgePlace> before = places;
  for (std::size_t i = 1; i + 1 < places.size(); ++i)
    if (before[i].state == EdgeState::kFlat && before[i - 1].state == EdgeState::kDrop &&
        before[i + 1].state == EdgeState::kDrop && distance(before[i - 1].at, before[i + 1].at) <= 2 * kEdgeStep_m)
      places[i].state = EdgeState::kDrop;
}

std::array<double, 2> square_of(Vec2 p) {
  return {std::floor(p.x / kRailingSquare_m), std::floor(p.y / kRailingSquare_m)};
}

Vec2 inside_of(const EdgePlace& place) { return snapped_to(map::kMapStep_m, place.at - place.out * kInsideEdge_m); }

// The corner of a railing between two edges; nothing where it would be far away.
std::optional<Vec2> corner_between(const EdgePlace& a, const EdgePlace& b) {
  const Vec2 p = inside_of(a), q = inside_of(b), along_a = left_of(a.out), along_b = left_of(b.out);
  const double area = cross(along_a, along_b);
  if (std::abs(area) < 0.1) return std::nullopt;
  const double s = cross(q - p, along_b) / area;
  if (s < 0 || s > 2 * kEdgeStep_m) return std::nullopt;
  return snapped_to(map::kMapStep_m, p + along_a * s);
}

void add_point(Polyline& axis, Vec2 p) {
  if (!axis.empty() && axis.back() == p) return;
  if (axis.size() > 1 && distance_to_segment(axis[axis.size() - 2], p, axis.back()) < kStraight_m) axis.pop_back();
  axis.push_back(p);
}

// Adds the railing along places; it ends at the sides of squares and at ways that it would cross.
void add_run(const EdgePlanner& planner, std::span<const EdgePlace> run, ObjectId id,
             std::vector<props::Barrier>& railings) {
  if (distance(run.front().at, run.back().at) < kShortestRailing_m) return;
  Polyline axis;
  const auto end = [&] {
    if (length_m(axis) >= kEdgeStep_m / 2)
      railings.push_back({.id = derived_id({id.osm, 0}, 0),
                          .axis = axis,
                          .kind = map::BarrierKind::kRailing,
                          .height_m = kAssumedRailing_m,
                          .width_m = kThickness_m});
    axis.clear();
  };
  const auto go_on_to = [&](Vec2 p) {
    if (!axis.empty() && is_crossed(planner, axis.back(), p, id.osm)) end();
    add_point(axis, p);
  };
  for (std::size_t i = 0; i < run.size(); ++i) {
    if (i > 0 && run[i].out != run[i - 1].out)
      if (const auto corner = corner_between(run[i - 1], run[i])) go_on_to(*corner);
    go_on_to(inside_of(run[i]));
    if (i + 1 < run.size() && square_of(run[i].at) != square_of(run[i + 1].at)) {
      go_on_to(inside_of(run[i + 1]));
      end();
    }
  }
  end();
}

// Adds the runs of drops of a ring. A ring begins anywhere, so runs begin after a place that is not a drop.
void add_ring(const EdgePlanner& planner, std::vector<EdgePlace> places, ObjectId id,
              std::vector<props::Barrier>& railings) {
  const auto is_no_drop = [](const EdgePlace& place) { return place.state != EdgeState::kDrop; };
  auto first = std::ranges::find_if(places, is_no_drop);
  if (first == places.end())
    first = std::ranges::min_element(places, {}, [](const EdgePlace& place) { return place.at; });
  std::rotate(places.begin(), first, places.end());
  close_gaps(places);
  for (std::size_t i = 0; i < places.size();) {
    std::size_t end = i;
    const auto follows = [&] {
      return end < places.size() && !is_no_drop(places[end]) &&
             (end == i || distance(places[end - 1].at, places[end].at) <= 2 * kEdgeStep_m);
    };
    while (follows()) ++end;
    if (end > i) add_run(planner, std::span(places).subspan(i, end - i), id, railings);
    i = std::max(end, i + 1);
  }
}

// True for land cover on which people walk at leisure; not for piers, at which boats moor, and paths in the open.
bool is_walked_on(LandCoverClass surface) {
  switch (surface) {
    case LandCoverClass::kPavement:
    case LandCoverClass::kPavedFootPath:
    case LandCoverClass::kPedestrianStreet:
    case LandCoverClass::kSquare:
    case LandCoverClass::kPlatform:
      return true;
    default:
      return false;
  }
}

}  // namespace

std::vector<props::Barrier> assumed_railings(const map::FeatureView& features, const RailingSurroundings& around,
                                             Report& report) {
  EdgePlanner planner{features, around.ground, obstacles_of(features, around), FreePlaces(around.cover)};
  std::vector<props::Barrier> railings;
  for (const LandCoverPolygon& polygon : around.cover) {
    if (!is_walked_on(polygon.surface)) continue;
    for (const Ring& ring : polygon.rings)
      if (std::vector<EdgePlace> places = places_on(planner, ring, polygon); !places.empty())
        add_ring(planner, std::move(places), polygon.id, railings);
  }
  std::ranges::sort(railings, {}, [](const props::Barrier& b) { return std::pair(b.id, b.axis); });
  std::set<OsmId> elements;
  Account account;
  for (const props::Barrier& railing : railings) {
    const OsmId element = railing.id.osm;
    if (elements.insert(element).second) report.count_assumed(Assumption::kRailings, element);
    const bool counts = report.counts(element);
    account.in += counts, account.out += counts;
  }
  report.account("things", "railing") = account;
  return railings;
}

}  // namespace citykiln::things
