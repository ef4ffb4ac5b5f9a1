#include "compiler/structures/plates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/polygons/overlay.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/bridge_areas.h"
#include "compiler/structures/ribs.h"

namespace citykiln::structures {
namespace {

// Distances of corners along edges; those on the outline near a gap between walls are denser.
constexpr double kCorners_m = 4, kDenseCorners_m = 0.5;
// The width of a gap beyond the way on either side.
constexpr double kBesideWay_m = 0.25;

// A place on the outline where a way comes onto the plate.
struct PlateGap {
  Vec2 at;
  double half_m = 0;
};

struct PlatePlanner {
  const map::BridgeArea& area;
  std::vector<const Span*> carried;
  std::vector<PlateGap> gaps;
};

// ---- heights --------------------------------------------------------------------------------------------------------

struct HeightSample {
  double z_m = 0, apart_m = 0;
};

// The height of a bridge at the place of its axis that is nearest, and the distance from its road.
HeightSample height_beside(const Span& bridge, Vec2 at) {
  HeightSample best{0, std::numeric_limits<double>::infinity()};
  const std::vector<double> along = roads::distances_along(bridge);
  double best_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < bridge.axis.size(); ++i) {
    const Vec2 a = bridge.axis[i], b = bridge.axis[i + 1];
    const double share = nearest_share(a, b, at), axis_m = distance(at, a + (b - a) * share);
    if (axis_m >= best_m) continue;
    best_m = axis_m;
    const double left = cross(b - a, at - a);
    const double half_m = left > 0 ? roads::left_m(bridge) + roads::raised_left_m(bridge)
                                   : roads::right_m(bridge) + roads::raised_right_m(bridge);
    const double own_m = bridge.deck == DeckForm::kNone ? 0 : half_m;
    best = {bridge.profile.empty() ? 0 : knot_at(bridge.profile, along[i] + (along[i + 1] - along[i]) * share).z_m,
            std::max(0.0, axis_m - own_m)};
  }
  return best;
}

double plate_m(const PlatePlanner& planner, Vec2 at) {
  constexpr double kNearest_m2 = 1e-4;
  double sum_m = 0, weights = 0;
  for (const Span* bridge : planner.carried) {
    const HeightSample sample = height_beside(*bridge, at);
    const double weight = 1 / (sample.apart_m * sample.apart_m + kNearest_m2);
    sum_m += weight * sample.z_m, weights += weight;
  }
  return snapped_to(kProfileQuantum_m, sum_m / weights);
}

// ---- gaps between walls ---------------------------------------------------------------------------------------------

double half_way_m(const map::Track& track) { return map::total_width_m(track.section) / 2; }

// Calls visit(from, to) for each edge of the outline.
template <typename Visit>
void for_each_edge(const Polygon& polygon, Visit visit) {
  for (const Ring* ring : rings_of(polygon))
    for (std::size_t i = 0; i < ring->size(); ++i) visit((*ring)[i], (*ring)[(i + 1) % ring->size()]);
}

double gap_half_m(const map::Track& track, Vec2 along_way, Vec2 along_edge) {
  constexpr double kLeastSine = 0.35;
  const double sine = std::abs(cross(unit(along_way), unit(along_edge)));
  return half_way_m(track) / std::max(kLeastSine, sine) + kBesideWay_m;
}

// Where a bridge of the map crosses the outline, or ends beside it.
void add_gaps_of_carried(const map::Track& track, PlatePlanner& planner) {
  constexpr double kBeside_m = 3;
  const Polyline& axis = track.axis;
  for_each_edge(planner.area.polygon, [&](Vec2 a, Vec2 b) {
    for (std::size_t i = 0; i + 1 < axis.size(); ++i)
      if (const auto hit = crossing_shares(a, b, axis[i], axis[i + 1]))
        planner.gaps.push_back({a + (b - a) * hit->first, gap_half_m(track, axis[i + 1] - axis[i], b - a)});
    for (const auto& [end, before] : {std::pair(axis.front(), axis[1]), std::pair(axis.back(), axis[axis.size() - 2])})
      if (const Vec2 near = nearest_point(a, b, end); distance(near, end) < kBeside_m)
        planner.gaps.push_back({near, gap_half_m(track, end - before, b - a)});
  });
}

// Where another way has a node on the outline.
void add_gaps_at_nodes(const map::Track& track, PlatePlanner& planner) {
  for (const Ring* ring : rings_of(planner.area.polygon))
    for (const Vec2 corner : *ring)
      if (std::ranges::find(track.axis, corner) != track.axis.end())
        planner.gaps.push_back({corner, half_way_m(track) + kBesideWay_m});
}

void add_gaps(const map::FeatureView& features, const BoxGrid& near, PlatePlanner& planner) {
  for (const std::uint32_t t : boxes_about(near, box_of(planner.area.polygon.outer).widened(kCorners_m))) {
    const map::Track& track = features.tracks[t];
    if (track.passage == map::Passage::kTunnel) continue;
    const bool is_axis = track.id.osm == planner.area.id.osm;
    if (is_axis) continue;
    if (std::ranges::binary_search(planner.area.tracks, track.id))
      add_gaps_of_carried(track, planner);
    else
      add_gaps_at_nodes(track, planner);
  }
}

// ---- parts ----------------------------------------------------------------------------------------------------------

bool is_on_outline(const PlatePlanner& planner, Vec2 at) {
  constexpr double kOn_m = 0.01;
  return std::ranges::any_of(rings_of(planner.area.polygon),
                             [&](const Ring* ring) { return distance_to_ring(*ring, at) < kOn_m; });
}

bool is_in_gap(const PlatePlanner& planner, Vec2 at, double margin_m) {
  return std::ranges::any_of(planner.gaps,
                             [&](const PlateGap& gap) { return distance(gap.at, at) < gap.half_m + margin_m; });
}

void add_edge(const PlatePlanner& planner, Vec2 from, Vec2 to, std::vector<PlateCorner>& ring) {
  const double long_m = distance(from, to);
  const Vec2 middle = (from + to) * 0.5;
  const bool is_outer = is_on_outline(planner, middle);
  const bool is_near_gap = is_outer && is_in_gap(planner, middle, long_m / 2 + kDenseCorners_m);
  const int pieces = std::max(1, static_cast<int>(std::ceil(long_m / (is_near_gap ? kDenseCorners_m : kCorners_m))));
  for (int k = 0; k < pieces; ++k) {
    const Vec2 here = snapped(from + (to - from) * (static_cast<double>(k) / pieces));
    const Vec2 half_on = from + (to - from) * ((k + 0.5) / pieces);
    ring.push_back({{here.x, here.y, plate_m(planner, here)}, is_outer && !is_in_gap(planner, half_on, 0)});
  }
}

PlatePart plate_part_of(const PlatePlanner& planner, const Polygon& polygon, bool is_below_road) {
  PlatePart part{{}, is_below_road};
  for (const Ring* ring : rings_of(polygon)) {
    std::vector<PlateCorner>& corners = part.rings.emplace_back();
    for (std::size_t i = 0; i < ring->size(); ++i)
      add_edge(planner, (*ring)[i], (*ring)[(i + 1) % ring->size()], corners);
  }
  return part;
}

// The ground plan of a bridge's road.
Polygon road_plan_of(const Span& bridge) {
  const double left_m = roads::left_m(bridge) + roads::raised_left_m(bridge),
               right_m = roads::right_m(bridge) + roads::raised_right_m(bridge);
  const std::vector<Rib> ribs = ribs_of(bridge);
  Ring ring;
  for (const Rib& rib : ribs) ring.push_back(in_plan(point_on(rib, -right_m, 0)));
  for (auto rib = ribs.rbegin(); rib != ribs.rend(); ++rib) ring.push_back(in_plan(point_on(*rib, left_m, 0)));
  return {without_repeats(ring), {}};
}

Plate plate_of(const PlatePlanner& planner) {
  Plate plate{planner.area.id.osm, planner.area.surface, {}};
  std::vector<Polygon> roads;
  for (const Span* bridge : planner.carried)
    if (Polygon plan = road_plan_of(*bridge); bridge->deck != DeckForm::kNone && plan.outer.size() > 2)
      roads.push_back(std::move(plan));
  if (roads.empty()) {
    plate.parts.push_back(plate_part_of(planner, planner.area.polygon, false));
    return plate;
  }
  const std::vector<Polygon> beside = difference(planner.area.polygon, roads);
  for (const Polygon& polygon : beside) plate.parts.push_back(plate_part_of(planner, polygon, false));
  for (const Polygon& polygon : difference(planner.area.polygon, beside))
    plate.parts.push_back(plate_part_of(planner, polygon, true));
  return plate;
}

Span* bridge_with(std::vector<Span>& bridges, ObjectId id) {
  const auto found = std::ranges::lower_bound(bridges, id, {}, &Span::id);
  return found != bridges.end() && found->id == id ? &*found : nullptr;
}

}  // namespace

std::vector<Span> with_plates(std::vector<Span> bridges, const map::FeatureView& features) {
  constexpr double kBucket_m = 64;
  if (features.bridge_areas.empty()) return bridges;
  std::vector<Box2> boxes;
  for (const map::Track& track : features.tracks) boxes.push_back(box_of(track.axis));
  const BoxGrid near = grid_of(boxes, kBucket_m);
  for (const map::BridgeArea& area : features.bridge_areas) {
    PlatePlanner planner{area, {}, {}};
    for (const ObjectId id : area.tracks) {
      Span* bridge = bridge_with(bridges, id);
      if (bridge == nullptr) continue;
      if (id.osm == area.id.osm)
        bridge->deck = DeckForm::kNone;
      else if (map::share_inside(bridge->axis, area.polygon) >= map::kCarriedShare)
        bridge->deck = DeckForm::kPlate;
      planner.carried.push_back(bridge);
    }
    if (planner.carried.empty()) continue;
    add_gaps(features, near, planner);
    Plate plate = plate_of(planner);
    if (!plate.parts.empty()) bridge_with(bridges, planner.carried.front()->id)->plates.push_back(std::move(plate));
  }
  return bridges;
}

double plate_height_m(const Plate& plate, Vec2 at) {
  double z_m = 0, nearest_m = std::numeric_limits<double>::infinity();
  for (const PlatePart& part : plate.parts)
    for (const std::vector<PlateCorner>& ring : part.rings)
      for (const PlateCorner& corner : ring)
        if (const double apart_m = distance(in_plan(corner.at), at); apart_m < nearest_m)
          z_m = corner.at.z, nearest_m = apart_m;
  return z_m;
}

std::vector<BoxedPlate> boxed_plates(std::span<const Span> bridges) {
  std::vector<BoxedPlate> boxed;
  for (const Span& bridge : bridges)
    for (const Plate& plate : bridge.plates) {
      BoxedPlate& added = boxed.emplace_back(BoxedPlate{&plate, bridge.layer, {}});
      for (const PlatePart& part : plate.parts)
        for (const PlateCorner& corner : part.rings.front()) added.box.grow(in_plan(corner.at));
    }
  return boxed;
}

bool is_on_plate(const BoxedPlate& boxed, Vec2 at) { return boxed.box.contains(at) && is_on_plate(*boxed.plate, at); }

bool is_on_plate(const Plate& plate, Vec2 at) {
  return std::ranges::any_of(plate.parts, [&](const PlatePart& part) {
    int around = 0;
    for (const std::vector<PlateCorner>& ring : part.rings) {
      Ring plan;
      for (const PlateCorner& corner : ring) plan.push_back(in_plan(corner.at));
      around += winding_number(plan, at);
    }
    return around > 0;
  });
}

}  // namespace citykiln::structures
