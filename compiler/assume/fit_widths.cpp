#include "compiler/assume/fit_widths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/lanes/narrowest_lanes.h"

namespace citykiln::assume {
namespace {

constexpr double kThingBucket_m = 32;
// Lines are sampled at this distance.
constexpr double kApart_m = 2;
// A line that comes nearer to the axis crosses the way.
constexpr double kCrosses_m = 1;

// A mapped thing: a point, or a line as points.
struct Thing {
  std::vector<Vec2> places;
  double from_kerb_m = 0;
};

// Nodes of a way are mapped on its axis, wherever they stand.
bool stands_beside(const map::ThingFeature& thing) {
  return !thing.is_in_way && thing.way.id.osm.type == OsmType::kNone;
}

std::vector<Vec2> places_along(const Polyline& axis) {
  std::vector<Vec2> places;
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
    const int pieces = std::max(1, static_cast<int>(std::ceil(distance(axis[i], axis[i + 1]) / kApart_m)));
    for (int k = 0; k <= pieces; ++k)
      places.push_back(axis[i] + (axis[i + 1] - axis[i]) * (static_cast<double>(k) / pieces));
  }
  return places;
}

std::vector<Thing> things_of(const map::FeatureView& features) {
  std::vector<Thing> things;
  for (const map::PointFeature& point : features.points)
    if (point.kind == map::PointKind::kTree) things.push_back({{point.at}, kTreeFromKerb_m});
  for (const map::ThingFeature& thing : features.things)
    if (stands_beside(thing)) things.push_back({{thing.at}, kThingFromKerb_m});
  for (const map::TreeRow& row : features.tree_rows) things.push_back({places_along(row.axis), kTreeFromKerb_m});
  // guard rails stand on the road
  for (const map::Barrier& barrier : features.barriers)
    if (barrier.kind != map::BarrierKind::kGuardRail && barrier.kind != map::BarrierKind::kKerb)
      things.push_back({places_along(barrier.axis), kThingFromKerb_m + barrier.width_m / 2});
  return things;
}

// All things, by place.
struct ThingIndex {
  std::vector<Thing> things;
  BoxGrid grid;
};

ThingIndex index_things(const map::FeatureView& features) {
  ThingIndex index{things_of(features), {}};
  std::vector<Box2> boxes;
  for (const Thing& thing : index.things) boxes.push_back(box_of(thing.places));
  index.grid = grid_of(boxes, kThingBucket_m);
  return index;
}

// The distance from an axis to the left, < 0 to the right; none beyond its ends.
std::optional<double> offset_m(const Polyline& axis, Vec2 p) {
  double least_m = std::numeric_limits<double>::infinity();
  std::optional<double> offset;
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
    const double share = nearest_share(axis[i], axis[i + 1], p);
    const double away_m = distance(p, axis[i] + (axis[i + 1] - axis[i]) * share);
    if (away_m >= least_m) continue;
    least_m = away_m;
    const bool is_beyond = (i == 0 && share == 0) || (i + 2 == axis.size() && share == 1);
    const double side = twice_area(axis[i], axis[i + 1], p);
    offset = is_beyond ? std::nullopt : std::optional(std::copysign(away_m, side));
  }
  return offset;
}

// How far the kerbs may be from the axis for one thing; both at least 0.
struct KerbRoom {
  double left_m = std::numeric_limits<double>::infinity(), right_m = std::numeric_limits<double>::infinity();
};

// The room that a thing leaves for the carriageway; unlimited if the thing is not beside the way or crosses it.
KerbRoom kerb_room(const Thing& thing, const Polyline& axis, double half_m) {
  KerbRoom room;
  for (const Vec2 p : thing.places) {
    const std::optional<double> offset = offset_m(axis, p);
    if (!offset || std::abs(*offset) > half_m + thing.from_kerb_m) continue;
    if (std::abs(*offset) < std::max(kCrosses_m, thing.from_kerb_m)) return {};
    double& side_m = *offset > 0 ? room.left_m : room.right_m;
    side_m = std::min(side_m, std::abs(*offset) - thing.from_kerb_m);
  }
  return room;
}

// The rooms of all things beside a track, without those that leave it unchanged.
std::vector<KerbRoom> rooms_beside(const map::Track& track, const ThingIndex& index, double half_m) {
  std::vector<KerbRoom> rooms;
  const Box2 box = box_of(track.axis).widened(half_m + kTreeFromKerb_m);
  for (const std::uint32_t i : boxes_about(index.grid, box)) {
    const KerbRoom room = kerb_room(index.things[i], track.axis, half_m);
    if (std::isfinite(room.left_m) || std::isfinite(room.right_m)) rooms.push_back(room);
  }
  return rooms;
}

// The room that all things leave. While it is less than least_m, the thing nearest to the axis is ignored.
KerbRoom room_between(const std::vector<KerbRoom>& rooms, double least_m) {
  std::vector<double> left, right;
  for (const KerbRoom& room : rooms) left.push_back(room.left_m), right.push_back(room.right_m);
  std::ranges::sort(left), std::ranges::sort(right);
  std::size_t l = 0, r = 0;
  const auto at = [](const std::vector<double>& sides, std::size_t i) {
    return i < sides.size() ? sides[i] : std::numeric_limits<double>::infinity();
  };
  while (at(left, l) + at(right, r) < least_m) at(left, l) < at(right, r) ? ++l : ++r;
  return {at(left, l), at(right, r)};
}

// The width of the carriageway and its part to the left of the axis.
struct Fit {
  double width_m, left_m;
};

Fit fit_between(const KerbRoom& room, double left_m, double right_m, double least_m, bool may_move) {
  const double width_m = left_m + right_m;
  if (!may_move) {
    const double share = std::min({1.0, room.left_m / left_m, room.right_m / right_m});
    return {std::max(least_m, width_m * share), std::max(least_m, width_m * share) * (left_m / width_m)};
  }
  const double fitted_m = std::clamp(room.left_m + room.right_m, least_m, width_m);
  const double wanted_m = fitted_m * left_m / width_m;
  return {fitted_m, std::min(std::max(wanted_m, fitted_m - room.right_m), room.left_m)};
}

// Takes a length from lanes in proportion to what each can give; returns what is left of it.
double narrow(map::Track& track, double taken_m, bool is_of_soft) {
  double most_m = 0;
  const auto spare_m = [&](const map::Lane& lane) {
    const bool counts = !lane.is_raised && map::is_soft(lane.kind) == is_of_soft;
    return counts ? std::max(0.0, lane.width_m - map::narrowest_m(lane, track.surface)) : 0;
  };
  for (const map::Lane& lane : track.section.lanes) most_m += spare_m(lane);
  if (most_m <= 0) return taken_m;
  const double share = std::min(1.0, taken_m / most_m);
  double given_m = 0;
  for (map::Lane& lane : track.section.lanes) {
    const double narrower_m = snapped(lane.width_m - share * spare_m(lane));
    given_m += lane.width_m - narrower_m, lane.width_m = narrower_m;
  }
  return taken_m - given_m;
}

bool can_be_fitted(const map::Track& track) {
  // the whole way of a piece is longer than kLongestFitted_m
  if (track.section.axis_drift != 0 || track.is_piece) return false;
  return map::family_of(track.surface) == map::Family::kStreet && track.passage == map::Passage::kGround &&
         !track.has_tagged_width && length_m(track.axis) <= kLongestFitted_m;
}

double narrowest_m(const map::Track& track) {
  double sum_m = 0;
  for (const map::Lane& lane : track.section.lanes)
    if (!lane.is_raised) sum_m += std::min(lane.width_m, map::narrowest_m(lane, track.surface));
  return sum_m;
}

map::Track fitted(map::Track track, const ThingIndex& index) {
  const double width_m = carriageway_width_m(track.section), left_m = track.section.axis_offset_m;
  const double right_m = width_m - left_m, least_m = narrowest_m(track);
  const std::vector<KerbRoom> rooms = rooms_beside(track, index, std::max(left_m, right_m));
  const KerbRoom room = room_between(rooms, least_m);
  if (room.left_m >= left_m && room.right_m >= right_m) return track;
  const Fit fit = fit_between(room, left_m, right_m, least_m, !track.has_tagged_placement);
  const double rest_m = narrow(track, width_m - fit.width_m, true);
  narrow(track, rest_m, false);
  constexpr double kHalfQuantum_m = kQuantum_m / 2;
  // rounded lanes may be narrower than the fit
  track.section.axis_offset_m =
      std::clamp(snapped_to(kHalfQuantum_m, fit.left_m), 0.0, carriageway_width_m(track.section));
  return track;
}

}  // namespace

std::vector<map::Track> fit_assumed_widths(const map::FeatureView& features) {
  std::vector<map::Track> tracks(features.tracks.begin(), features.tracks.end());
  const ThingIndex index = index_things(features);
  if (index.things.empty()) return tracks;
  for (map::Track& track : tracks)
    if (can_be_fitted(track)) track = fitted(std::move(track), index);
  return tracks;
}

}  // namespace citykiln::assume
