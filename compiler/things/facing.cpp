#include "compiler/things/facing.h"

#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/trig.h"

namespace citykiln::things {
namespace {

using map::LandCoverGroup;

constexpr double kAxisBucket_m = 32;
constexpr Vec2 kSouth{0, -1};

bool is_of_kind(LandCoverGroup group, AxisKind kind) {
  if (group == LandCoverGroup::kRoad) return true;
  return group == (kind == AxisKind::kRoadsAndRails ? LandCoverGroup::kRail : LandCoverGroup::kPath) &&
         kind != AxisKind::kRoads;
}

Vec2 towards_axis(const Axes& axes, Vec2 p, AxisKind kind) {
  const std::optional<NearestAxis> near = nearest_axis(axes, p, kind);
  if (!near) return kSouth;
  const Vec2 to = unit(near->at - p);
  return to == Vec2{} ? left_of(near->along) : to;
}

// On the side of the axis on which traffic drives, this traffic sees the thing.
Vec2 against_near_traffic(const Axes& axes, Vec2 p) {
  const std::optional<NearestAxis> near = nearest_axis(axes, p, AxisKind::kRoads);
  if (!near) return kSouth;
  const bool is_left = cross(near->along, p - near->at) > 0;
  const bool is_along = is_left == (near->side == map::DrivingSide::kLeft);
  return is_along ? near->along * -1.0 : near->along;
}

Vec2 of_bearing(double bearing_deg) { return citykiln::direction_of((90 - bearing_deg) / 360); }

Vec2 random_direction(const map::ThingFeature& thing, std::uint64_t seed) {
  return citykiln::direction_of(RandomSequence(seed, stable_id(thing.id), "facing").unit(0));
}

}  // namespace

Vec2 unit_vector(std::uint16_t direction) { return citykiln::direction_of(direction / double{kDirections}); }

std::uint16_t nearest_direction(Vec2 v) {
  if (v == Vec2{}) return 0;
  const bool is_below = v.y < 0 || (v.y == 0 && v.x < 0);
  const Vec2 upper = is_below ? v * -1.0 : v;
  std::uint16_t least = 0, end = kDirections / 2;
  while (end - least > 1) {
    const auto middle = static_cast<std::uint16_t>((least + end) / 2);
    (cross(unit_vector(middle), upper) >= 0 ? least : end) = middle;
  }
  const bool is_end_nearer = dot(unit_vector(end), upper) > dot(unit_vector(least), upper);
  return static_cast<std::uint16_t>(((is_end_nearer ? end : least) + (is_below ? kDirections / 2 : 0)) % kDirections);
}

Axes axes_of(std::span<const roads::Road> roads) {
  Axes axes;
  std::vector<Box2> boxes;
  for (const roads::Road& road : roads) {
    const LandCoverGroup group = map::values_of(road.surface).group;
    for (std::size_t i = 0; i + 1 < road.axis.size(); ++i) {
      axes.segments.push_back({road.axis[i], road.axis[i + 1], group, road.side});
      boxes.push_back(box_of_segment(road.axis[i], road.axis[i + 1]).widened(kMaxFacing_m));
    }
  }
  axes.grid = grid_of(boxes, kAxisBucket_m);
  return axes;
}

std::optional<NearestAxis> nearest_axis(const Axes& axes, Vec2 p, AxisKind kind) {
  std::optional<NearestAxis> nearest;
  double nearest_m = kMaxFacing_m;
  for (const std::uint32_t i : boxes_about(axes.grid, p)) {
    const Axes::Segment& segment = axes.segments[i];
    if (!is_of_kind(segment.group, kind) || segment.a == segment.b) continue;
    const Vec2 at = nearest_point(segment.a, segment.b, p);
    if (distance(at, p) >= nearest_m) continue;
    nearest_m = distance(at, p);
    nearest = NearestAxis{at, unit(segment.b - segment.a), segment.side};
  }
  return nearest;
}

Vec2 traffic_of(const map::ThingFeature& thing) {
  const bool is_along = thing.facing != 0 ? thing.facing > 0 : thing.way.is_oneway || thing.way.is_nearer_to_end;
  return is_along ? thing.way.along : thing.way.along * -1.0;
}

namespace {

Vec2 facing_without_outline(const map::ThingFeature& thing, map::Facing facing, Vec2 p, const Axes& axes,
                            std::uint64_t seed) {
  if (thing.bearing_deg) return of_bearing(*thing.bearing_deg);
  const bool has_way = thing.way.along != Vec2{};
  const bool is_for_traffic = facing == map::Facing::kAlong || facing == map::Facing::kArms;
  if (has_way && (thing.facing != 0 || is_for_traffic)) return traffic_of(thing) * -1.0;
  switch (facing) {
    case map::Facing::kTag:
      return kSouth;
    case map::Facing::kStreet:
      return towards_axis(axes, p, AxisKind::kRoadsAndPaths);
    case map::Facing::kPlatform:
      return towards_axis(axes, p, AxisKind::kRoadsAndRails);
    case map::Facing::kAlong:
    case map::Facing::kArms:
      return against_near_traffic(axes, p);
    default:
      return random_direction(thing, seed);
  }
}

}  // namespace

Vec2 facing_of(const map::ThingFeature& thing, map::Facing facing, Vec2 p, const Axes& axes, std::uint64_t seed) {
  const Vec2 wanted = facing_without_outline(thing, facing, p, axes, seed);
  if (!thing.along) return wanted;
  const Vec2 front = left_of(*thing.along);
  return dot(front, wanted) >= 0 ? front : front * -1.0;
}

}  // namespace citykiln::things
