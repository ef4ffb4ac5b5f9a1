#include "compiler/map/ways/passageways.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/line_part.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/buildings/building_classes.h"

namespace citykiln::map {
namespace {

constexpr double kPassageBucket_m = 32;
// A way nearer to a wall runs along it, not inside.
constexpr double kAlongWall_m = 0.05;
// Shorter parts of a way inside a building are doorsteps.
constexpr double kShortest_m = 0.3;
// A gap between two parts inside that is a rounding error.
constexpr double kGap_m = 0.05;
// An opening is this much wider on each side than the way, and this much higher than tagged, as surfaces are rounded.
constexpr double kPlay_m = 0.0625;
// The wall that has to remain beside an opening.
constexpr double kJamb_m = 0.5;
// An opening continues this far beyond the wall: plinths stand out.
constexpr double kBeyondWall_m = 0.5;
constexpr double kStepOut_m = 0.125;

bool is_near_wall(const Polygon& polygon, Vec2 p, double within_m) {
  return std::ranges::any_of(rings_of(polygon),
                             [&](const Ring* ring) { return distance_to_ring(*ring, p) < within_m; });
}

bool is_inside(const Polygon& polygon, Vec2 p) {
  return contains(polygon, p) && !is_near_wall(polygon, p, kAlongWall_m);
}

// The distances at which an axis crosses walls, and those of its points.
std::vector<double> places_at_walls(const Polyline& axis, const std::vector<double>& along, const Polygon& polygon) {
  std::vector<double> places(along);
  for (const Ring* ring : rings_of(polygon))
    for (std::size_t w = 0; w < ring->size(); ++w)
      for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
        const Vec2 a = (*ring)[w], b = (*ring)[(w + 1) % ring->size()];
        if (const auto shares = crossing_shares(axis[i], axis[i + 1], a, b))
          places.push_back(along[i] + (along[i + 1] - along[i]) * shares->first);
      }
  std::ranges::sort(places);
  return places;
}

std::vector<LinePart> parts_inside(const Polyline& axis, const std::vector<double>& along, const Polygon& polygon) {
  const std::vector<double> places = places_at_walls(axis, along, polygon);
  std::vector<LinePart> parts;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double from_m = places[i - 1], to_m = places[i];
    if (to_m - from_m < 1e-6 || !is_inside(polygon, point_at(axis, along, (from_m + to_m) / 2))) continue;
    if (!parts.empty() && from_m - parts.back().to_m < kGap_m)
      parts.back().to_m = to_m;
    else
      parts.push_back({from_m, to_m});
  }
  std::erase_if(parts, [](const LinePart& part) { return part.to_m - part.from_m < kShortest_m; });
  return parts;
}

// The distances of both sides of a way from its axis.
struct Sides {
  double left_m, right_m;
};

Sides kerbs_of(const CrossSection& section) { return {left_kerb_m(section), right_kerb_m(section)}; }

// With pavements and cycle tracks, without verges outside them.
Sides edges_of(const CrossSection& section) {
  Sides sides = kerbs_of(section);
  const auto first_inner = std::ranges::find(section.lanes, false, &Lane::is_raised);
  double left_m = 0, right_m = 0;
  bool is_paved = false;
  for (auto lane = section.lanes.begin(); lane != first_inner; ++lane) {
    is_paved |= lane->kind != LaneKind::kVerge;
    if (is_paved) left_m += lane->width_m;
  }
  is_paved = false;
  for (auto lane = section.lanes.rbegin(); lane != section.lanes.rend() && lane->is_raised; ++lane) {
    is_paved |= lane->kind != LaneKind::kVerge;
    if (is_paved) right_m += lane->width_m;
  }
  return {sides.left_m + left_m, sides.right_m + right_m};
}

// A place on the axis, its direction there, and the footprint.
struct Mouth {
  Vec2 at, out;
};

// How far the walls go on before a mouth, along a line beside the axis.
double wall_ahead_m(const Mouth& mouth, double side_m, double most_m, const Polygon& polygon) {
  const Vec2 from = mouth.at + left_of(mouth.out) * side_m;
  double wall_m = 0;
  for (double at_m = kStepOut_m; at_m <= most_m && at_m <= wall_m + kBeyondWall_m; at_m += kStepOut_m)
    if (contains(polygon, from + mouth.out * at_m)) wall_m = at_m;
  return wall_m;
}

// How far the opening has to go on until it is outside the walls across all its width; corners of the building that
// stand in it count, too. Nothing but its margin if a wall runs along the way: that end is inside.
double overrun_m(const Mouth& mouth, const Sides& sides, const Polygon& polygon) {
  constexpr int kLines = 8;
  const double width_m = sides.left_m + sides.right_m, most_m = 2 * width_m + kBeyondWall_m;
  double clear_m = 0;
  for (int i = 0; i <= kLines; ++i)
    clear_m = std::max(clear_m, wall_ahead_m(mouth, width_m * i / kLines - sides.right_m, most_m, polygon));
  const double reach_m = clear_m + kBeyondWall_m;
  for (const Ring* ring : rings_of(polygon))
    for (const Vec2 corner : *ring) {
      const double ahead_m = dot(mouth.out, corner - mouth.at), side_m = dot(left_of(mouth.out), corner - mouth.at);
      if (side_m > -sides.right_m && side_m < sides.left_m && ahead_m < reach_m) clear_m = std::max(clear_m, ahead_m);
    }
  return clear_m + kBeyondWall_m;
}

// Continues a line of at least two points straight on at its last point.
void extend(Polyline& points, double by_m) {
  const Vec2 along = unit(points.back() - points[points.size() - 2]);
  points.back() = points.back() + along * by_m;
}

// True if parts of the footprint remain on both sides of the part of an axis.
bool remains_beside(const Polyline& axis, const Sides& sides, const Polygon& polygon, double jamb_m) {
  bool is_left = false, is_right = false;
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
    const Vec2 left = left_of(unit(axis[i + 1] - axis[i]));
    for (const double share : {0.25, 0.5, 0.75}) {
      const Vec2 at = axis[i] + (axis[i + 1] - axis[i]) * share;
      is_left |= contains(polygon, at + left * (sides.left_m + jamb_m));
      is_right |= contains(polygon, at - left * (sides.right_m + jamb_m));
    }
  }
  return is_left && is_right;
}

// ---- arcades ------------------------------------------------------------------------------------------------------

// How thick the wall beside a way may be that an arcade is open through: as tagged, and of any covered way.
constexpr double kArcadeWall_m = 3, kThinWall_m = 1;
// The share of an arcade along which its outer wall has to be so near.
constexpr double kArcadeShare = 0.6;
// Half a pillar, with a margin beside the way.
constexpr double kHalfPillar_m = 0.25;

// The distance from a place to the wall in a direction; nothing if it is beyond most_m.
std::optional<double> wall_beside_m(Vec2 at, Vec2 aside, double most_m, const Polygon& polygon) {
  for (double out_m = kStepOut_m; out_m <= most_m; out_m += kStepOut_m)
    if (!contains(polygon, at + aside * out_m)) return out_m;
  return std::nullopt;
}

// The open side of an arcade: how far it is open, and where its pillars stand; 0 if the wall is in the way itself.
struct OpenSide {
  double side_m, pillars_m;
};

// @param side   1: left, -1: right.
// @param is_free  True at places where no other building stands.
template <typename IsFree>
std::optional<OpenSide> open_side(const Polyline& line, double side, double half_m, double wall_m,
                                  const Polygon& polygon, IsFree is_free) {
  constexpr double kApart_m = 1, kFree_m = 0.5;
  int samples = 0, open = 0;
  double farthest_m = 0, nearest_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec2 aside = left_of(unit(line[i + 1] - line[i])) * side;
    const int count = std::max(1, static_cast<int>(distance(line[i], line[i + 1]) / kApart_m));
    for (int k = 0; k < count; ++k) {
      const Vec2 at = line[i] + (line[i + 1] - line[i]) * ((k + 0.5) / count);
      const auto out_m = wall_beside_m(at, aside, half_m + wall_m, polygon);
      ++samples;
      if (!out_m || !is_free(at + aside * (*out_m + kFree_m))) continue;
      ++open, farthest_m = std::max(farthest_m, *out_m), nearest_m = std::min(nearest_m, *out_m);
    }
  }
  if (open < kArcadeShare * samples) return std::nullopt;
  const double edge_m = half_m + kPlay_m;
  const double pillars_m = nearest_m < half_m ? 0 : std::max(nearest_m - kHalfPillar_m, edge_m + kHalfPillar_m);
  return OpenSide{std::max(farthest_m + kBeyondWall_m, edge_m), pillars_m};
}

LandCoverGroup group_of(const Track& track) { return values_of(track.surface).group; }

double usual_clearance_m(const Track& track) {
  const LandCoverGroup group = group_of(track);
  return group == LandCoverGroup::kRail   ? kRailClearance_m
         : group == LandCoverGroup::kPath ? kPathClearance_m
                                          : kRoadClearance_m;
}

double least_clearance_m(const Track& track) {
  const LandCoverGroup group = group_of(track);
  const double least_m = group == LandCoverGroup::kRail   ? kLeastRail_m
                         : group == LandCoverGroup::kPath ? kLeastPath_m
                                                          : kLeastRoad_m;
  return track.clear_m > 0 ? std::min(track.clear_m, least_m) : least_m;
}

bool can_lead_through(const Track& track) {
  const LandCoverGroup group = group_of(track);
  const bool is_way =
      group == LandCoverGroup::kRoad || group == LandCoverGroup::kPath || group == LandCoverGroup::kRail;
  if (!is_way || track.passage != Passage::kGround || track.is_indoor) return false;
  return track.surface != LandCoverClass::kRunway && (track.is_covered || track.layer <= 0);
}

bool can_be_led_through(const Footprint& footprint, const Track& track) {
  const bool is_open = footprint.building_class == static_cast<std::uint8_t>(BuildingClass::kRoof);
  return !is_open && !footprint.has_parts && footprint.polygon.outer.size() >= 3 &&
         footprint.min_height_m < kLeastPath_m && footprint.min_height_m < usual_clearance_m(track);
}

// The nodes at which several ways meet.
std::vector<std::int64_t> shared_nodes(std::span<const Track> tracks) {
  std::vector<std::int64_t> nodes, shared;
  for (const Track& track : tracks)
    for (const std::int64_t end : {track.node_ids.front(), track.node_ids.back()}) nodes.push_back(end);
  std::ranges::sort(nodes);
  for (std::size_t i = 1; i < nodes.size(); ++i)
    if (nodes[i] == nodes[i - 1] && (shared.empty() || shared.back() != nodes[i])) shared.push_back(nodes[i]);
  return shared;
}

// A way with what all its passageways share.
struct Way {
  const Track& track;
  std::vector<double> along_m;
  Sides kerbs, edges;
  bool goes_on_before, goes_on_after;  // other ways continue at its ends
};

Way way_of(const Track& track, std::span<const std::int64_t> shared) {
  const auto goes_on = [&](std::int64_t node) { return std::ranges::binary_search(shared, node); };
  return {track,
          distances_on(track.axis),
          kerbs_of(track.section),
          edges_of(track.section),
          goes_on(track.node_ids.front()),
          goes_on(track.node_ids.back())};
}

// True if a way without a tag crosses the walls at both ends of a part.
bool crosses(const Way& way, const LinePart& part, const Polygon& polygon) {
  const Polyline& axis = way.track.axis;
  const auto is_at_wall = [&](Vec2 p) { return is_near_wall(polygon, p, kAlongWall_m); };
  const bool enters = part.from_m > 0 || (way.goes_on_before && is_at_wall(axis.front()));
  const bool leaves = part.to_m < way.along_m.back() || (way.goes_on_after && is_at_wall(axis.back()));
  return enters && leaves;
}

// Continues a line at its last point: out of the wall there, a little where another way continues inside, or not at all
// where the way ends inside.
void extend_mouth(Polyline& line, bool is_end_of_way, bool goes_on, const Sides& sides, const Polygon& polygon) {
  const Vec2 out = unit(line.back() - line[line.size() - 2]);
  if (!is_end_of_way || is_near_wall(polygon, line.back(), kEndAtWall_m))
    extend(line, overrun_m({line.back(), out}, sides, polygon));
  else if (goes_on)
    extend(line, std::max(sides.left_m, sides.right_m));
}

// Opens the outer sides of an arcade. It is as long as four pillars at least, since short passages have side walls.
template <typename IsFree>
void open_arcade(const Track& track, const Polyline& line, const Sides& sides, const Polygon& polygon, IsFree is_free,
                 Passageway& passageway) {
  constexpr double kShortestArcade_m = 12;
  if (!track.is_covered || (!track.is_arcade && length_m(line) < kShortestArcade_m)) return;
  const double wall_m = track.is_arcade ? kArcadeWall_m : kThinWall_m;
  if (const auto left = open_side(line, 1, sides.left_m, wall_m, polygon, is_free))
    passageway.left_m = snapped(left->side_m), passageway.pillars_left_m = snapped(left->pillars_m);
  if (const auto right = open_side(line, -1, sides.right_m, wall_m, polygon, is_free))
    passageway.right_m = snapped(right->side_m), passageway.pillars_right_m = snapped(right->pillars_m);
}

template <typename IsFree>
Passageway passageway_of(const Way& way, const Footprint& footprint, const LinePart& part, IsFree is_free) {
  const Track& track = way.track;
  Polyline line = points_of(track.axis, way.along_m, part);
  const bool has_room = remains_beside(line, way.edges, footprint.polygon, kJamb_m);
  const Sides sides = has_room ? way.edges : way.kerbs;
  const Polyline inside = line;
  extend_mouth(line, part.to_m == way.along_m.back(), way.goes_on_after, sides, footprint.polygon);
  std::ranges::reverse(line);
  extend_mouth(line, part.from_m == 0, way.goes_on_before, {sides.right_m, sides.left_m}, footprint.polygon);
  std::ranges::reverse(line);
  const double clear_m = track.clear_m > 0 ? track.clear_m : usual_clearance_m(track);
  Passageway passageway{.building = footprint.id,
                        .way = track.id,
                        .axis = snapped_line(line),
                        .left_m = snapped(sides.left_m + kPlay_m),
                        .right_m = snapped(sides.right_m + kPlay_m),
                        .clear_m = snapped(clear_m + kPlay_m),
                        .least_m = least_clearance_m(track)};
  open_arcade(track, inside, sides, footprint.polygon, is_free, passageway);
  return passageway;
}

template <typename IsFree>
void add_passageways(const Way& way, const Footprint& footprint, IsFree is_free, std::vector<Passageway>& passageways,
                     Report& report) {
  for (const LinePart& part : parts_inside(way.track.axis, way.along_m, footprint.polygon)) {
    if (!way.track.is_covered) {
      const Polyline line = points_of(way.track.axis, way.along_m, part);
      if (!crosses(way, part, footprint.polygon) || !remains_beside(line, way.kerbs, footprint.polygon, 0)) continue;
      report.add(Code::kPassageAssumed, way.track.id.osm, part.to_m - part.from_m);
    }
    passageways.push_back(passageway_of(way, footprint, part, is_free));
  }
}

// Footprints by place.
struct FootprintIndex {
  std::span<const Footprint> footprints;
  std::vector<Box2> boxes;
  BoxGrid grid;
};

FootprintIndex index_footprints(std::span<const Footprint> footprints) {
  FootprintIndex index{footprints, {}, {}};
  for (const Footprint& footprint : footprints) index.boxes.push_back(box_of(footprint.polygon.outer));
  index.grid = grid_of(index.boxes, kPassageBucket_m);
  return index;
}

// The outlines near a line that are no open roofs.
std::vector<std::uint32_t> closed_near(const FootprintIndex& index, const Polyline& line) {
  std::vector<std::uint32_t> near;
  const Box2 box = box_of(line);
  for (const std::uint32_t i : boxes_about(index.grid, box))
    if (index.boxes[i].touches(box) && index.footprints[i].polygon.outer.size() >= 3 &&
        index.footprints[i].building_class != static_cast<std::uint8_t>(BuildingClass::kRoof))
      near.push_back(i);
  return near;
}

bool is_only_in_buildings(const Track& track, const FootprintIndex& index) {
  const std::vector<double> along = distances_on(track.axis);
  if (along.back() > kLongestPassage_m) return false;
  const std::vector<std::uint32_t> near = closed_near(index, track.axis);
  const auto is_any = [&](auto holds) {
    return std::ranges::any_of(near, [&](std::uint32_t i) { return holds(index.footprints[i].polygon); });
  };
  const auto ends_at_wall = [&](Vec2 p) {
    return is_any([&](const Polygon& polygon) { return distance_to_ring(polygon.outer, p) < kEndAtWall_m; });
  };
  if (!ends_at_wall(track.axis.front()) || !ends_at_wall(track.axis.back())) return false;
  const int samples = std::max(8, static_cast<int>(along.back()));
  int inside = 0;
  for (int i = 0; i < samples; ++i) {
    const Vec2 p = point_at(track.axis, along, (i + 0.5) / samples * along.back());
    inside += is_any([&](const Polygon& polygon) { return contains(polygon, p); });
  }
  return inside >= kInsideShare * samples;
}

}  // namespace

std::vector<Track> with_passages_on_ground(std::vector<Track> tracks, const std::vector<Footprint>& footprints) {
  const FootprintIndex index = index_footprints(footprints);
  for (Track& track : tracks) {
    const bool may_be =
        track.passage == Passage::kTunnel && !track.has_tagged_layer && !track.is_rail && !track.is_indoor;
    if (may_be && is_only_in_buildings(track, index))
      track.passage = Passage::kGround, track.is_covered = track.is_through_building = true;
  }
  return tracks;
}

std::vector<Passageway> plan_passageways(const FeatureView& features, Report& report) {
  const FootprintIndex index = index_footprints(features.footprints);
  const std::vector<std::int64_t> shared = shared_nodes(features.tracks);
  std::vector<Passageway> passageways;
  for (const Track& track : features.tracks) {
    if (!can_lead_through(track)) continue;
    const std::vector<std::uint32_t> near = closed_near(index, track.axis);
    if (near.empty()) continue;
    const Way way = way_of(track, shared);
    const auto is_free = [&](Vec2 p) {
      return std::ranges::none_of(boxes_about(index.grid, p), [&](std::uint32_t i) {
        return index.boxes[i].contains(p) && contains(index.footprints[i].polygon, p);
      });
    };
    for (const std::uint32_t i : near)
      if (can_be_led_through(index.footprints[i], track))
        add_passageways(way, index.footprints[i], is_free, passageways, report);
  }
  std::ranges::stable_sort(passageways, {}, [](const Passageway& p) { return std::pair(p.building, p.way); });
  return passageways;
}

}  // namespace citykiln::map
