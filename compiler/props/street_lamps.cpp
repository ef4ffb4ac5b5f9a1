#include "compiler/props/street_lamps.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/geometry/snap.h"

namespace citykiln::props {
namespace {

using map::LandCoverClass;
using map::LandCoverGroup;
using roads::Road;

constexpr double kBehindKerb_m = 0.5, kBeyondEdge_m = 0.75;
// Wider carriageways than a lamp of middling height lights from one side.
constexpr double kWide_m = 9;
// A street's lamps light what is beside it as far as this: the path along it needs none of its own.
constexpr double kBesideStreet_m = 6;
// A lamp farther from every street than this lights something else.
constexpr double kFacingReach_m = 12;
constexpr Lighting kElsewhere = {0, 6, LampKind::kPostTop};

LandCoverGroup group_of(LandCoverClass surface) { return map::values_of(surface).group; }
bool is_path(const Road& road) { return group_of(road.surface) == LandCoverGroup::kPath; }
bool is_street(const Road& road) {
  return group_of(road.surface) == LandCoverGroup::kRoad && road.surface != LandCoverClass::kRunway;
}

enum class Side : std::uint8_t { kLeft, kRight };

Side lit_side(const Road& road, std::int64_t number) {
  const bool drives_left = road.side == map::DrivingSide::kLeft;
  if (width_m(road) > kWide_m) return drives_left == (number % 2 == 0) ? Side::kLeft : Side::kRight;
  const bool left = raised_left_m(road) > 0, right = raised_right_m(road) > 0;
  if (left != right) return left ? Side::kLeft : Side::kRight;
  return drives_left ? Side::kLeft : Side::kRight;
}

// What is raised on one side, from the kerb outward.
std::vector<map::Lane> raised_lanes(const Road& road, Side side) {
  std::vector<map::Lane> lanes = road.section.lanes;
  if (side == Side::kRight) std::ranges::reverse(lanes);
  lanes.erase(std::ranges::find(lanes, false, &map::Lane::is_raised), lanes.end());
  std::ranges::reverse(lanes);
  return lanes;
}

// From the axis to the foot of a lamp on that side: a raised cycle track is kept free.
double offset_m(const Road& road, Side side) {
  double edge_m = side == Side::kLeft ? left_m(road) : right_m(road);
  for (const map::Lane& lane : raised_lanes(road, side)) {
    if (lane.kind != map::LaneKind::kCycle) return edge_m + std::min(kBehindKerb_m, lane.width_m / 2);
    edge_m += lane.width_m;
  }
  return edge_m + kBeyondEdge_m;
}

// A straight piece of a road: `length_m` is what start_along_m counts it as.
struct Piece {
  Vec2 a, b;
  double start_along_m, length_m;
};

StreetLamp lamp_on(const Road& road, const Piece& piece, const Lighting& lighting, std::int64_t number) {
  const double along_m = (static_cast<double>(number) + 0.5) * lighting.spacing_m - piece.start_along_m;
  const Side side = lit_side(road, number);
  const Vec2 left = left_of(unit(piece.b - piece.a)), out = side == Side::kLeft ? left : left * -1.0;
  const Vec2 on_axis = piece.a + (piece.b - piece.a) * (along_m / piece.length_m);
  return {snapped(on_axis + out * offset_m(road, side)), out * -1.0, lighting.height_m, lighting.kind, road.id.osm};
}

// The numbers of the lamps whose places along the way lie in [from_m, to_m).
struct Numbers {
  std::int64_t first, end;
};
Numbers numbers_between(double from_m, double to_m, double spacing_m) {
  const auto number = [&](double place_m) {
    return static_cast<std::int64_t>(std::ceil(std::clamp(place_m / spacing_m - 0.5, 0.0, 0x1p53)));
  };
  return {number(from_m), number(to_m)};
}

// What of the piece may have lamps in the box: as far from the foot of its centre as its corners are.
Numbers numbers_near(const Piece& piece, const Lighting& lighting, const Box2& reach) {
  const double foot_m = dot(reach.centre() - piece.a, unit(piece.b - piece.a));
  const double around_m = length(reach.max - reach.min) / 2 + 1;
  const double from_m = std::max(0.0, foot_m - around_m), to_m = std::min(piece.length_m, foot_m + around_m);
  return numbers_between(piece.start_along_m + from_m, piece.start_along_m + to_m, lighting.spacing_m);
}

void add_lamps(std::vector<StreetLamp>& lamps, const Road& road, const Piece& piece, const Box2& box,
               const Box2& reach) {
  const Lighting lighting = lighting_of(road.surface);
  if (piece.length_m <= 0 || !box_of(std::array{piece.a, piece.b}).touches(reach)) return;
  const Numbers numbers = numbers_near(piece, lighting, reach);
  for (std::int64_t number = numbers.first; number < numbers.end; ++number)
    if (const StreetLamp lamp = lamp_on(road, piece, lighting, number); box.contains_half_open(lamp.at))
      lamps.push_back(lamp);
}

// A road that matters to what is nearer to its axis than `reach_m`, and the box where that may be.
struct Reaching {
  const Road* road;
  double reach_m;
  Box2 box;
};

Reaching reaching(const Road& road, double reach_m) { return {&road, reach_m, box_of(road.axis).widened(reach_m)}; }

// Whose lamps light paths beside them.
std::vector<Reaching> lit_streets(std::span<const Road> roads) {
  std::vector<Reaching> streets;
  for (const Road& road : roads)
    if (road.is_lit && is_street(road))
      streets.push_back(reaching(road, std::max(left_m(road), right_m(road)) + kBesideStreet_m));
  return streets;
}

// What lamps may face.
template <typename Wanted>
std::vector<Reaching> faced(std::span<const Road> roads, Wanted is_wanted) {
  std::vector<Reaching> wanted;
  for (const Road& road : roads)
    if (is_wanted(road)) wanted.push_back(reaching(road, kFacingReach_m));
  return wanted;
}

Vec2 nearest_on(Vec2 a, Vec2 b, Vec2 p) {
  const Vec2 along = b - a;
  const double square = dot(along, along);
  return square > 0 ? a + along * std::clamp(dot(p - a, along) / square, 0.0, 1.0) : a;
}

Vec2 nearest_on(const Polyline& axis, Vec2 p) {
  Vec2 nearest = axis.front();
  for (std::size_t i = 0; i + 1 < axis.size(); ++i)
    if (const Vec2 q = nearest_on(axis[i], axis[i + 1], p); distance(p, q) < distance(p, nearest)) nearest = q;
  return nearest;
}

bool is_beside(std::span<const Reaching> streets, Vec2 p) {
  return std::ranges::any_of(streets, [&](const Reaching& street) {
    return street.box.contains(p) && distance(p, nearest_on(street.road->axis, p)) < street.reach_m;
  });
}

bool is_near(std::span<const Lamp> lamps, Vec2 p, double reach_m) {
  return std::ranges::any_of(lamps, [&](const Lamp& lamp) { return distance(lamp.at, p) < reach_m; });
}

// Foot paths may be a street's pavement, mapped for itself.
bool bears_lamps(LandCoverClass surface) {
  switch (group_of(surface)) {
    case LandCoverGroup::kRoad:
    case LandCoverGroup::kRail:
    case LandCoverGroup::kWater:
    case LandCoverGroup::kBuilding:
      return false;
    case LandCoverGroup::kPath:
      return surface == LandCoverClass::kFootPath || surface == LandCoverClass::kPavedFootPath;
    default:
      return surface != LandCoverClass::kParkingLane;
  }
}

bool has_room(const ground::LandCoverIndex& map, Vec2 p) {
  const std::uint32_t top = ground::land_cover_at(map, p);
  return top == ground::kNoLandCover || bears_lamps(map.surfaces[top].surface);
}

// What a mapped lamp lights.
struct Lit {
  const Road* road = nullptr;
  Vec2 at;
};

Lit nearest_road(std::span<const Reaching> roads, Vec2 p) {
  Lit lit;
  double nearest_m = kFacingReach_m;
  for (const Reaching& near : roads) {
    if (!near.box.contains(p)) continue;
    const Vec2 at = nearest_on(near.road->axis, p);
    if (distance(p, at) >= nearest_m) continue;
    nearest_m = distance(p, at);
    lit = {near.road, at};
  }
  return lit;
}

StreetLamp standing(const Lamp& lamp, const Lit& lit) {
  const Lighting lighting = lit.road ? lighting_of(lit.road->surface) : kElsewhere;
  const Vec2 towards = lit.road ? unit(lit.at - lamp.at) : Vec2{};
  return {lamp.at, towards == Vec2{} ? Vec2{1, 0} : towards, lamp.height_m > 0 ? lamp.height_m : lighting.height_m,
          lighting.kind, lamp.id.osm};
}

}  // namespace

Lighting lighting_of(LandCoverClass surface) {
  switch (surface) {
    case LandCoverClass::kMotorwayRoad:
      return {40, 12, LampKind::kArm};
    case LandCoverClass::kPrimaryRoad:
      return {35, 10, LampKind::kArm};
    case LandCoverClass::kSecondaryRoad:
      return {32, 10, LampKind::kArm};
    case LandCoverClass::kTertiaryRoad:
      return {30, 8, LampKind::kArm};
    case LandCoverClass::kRunway:
      return {};
    default:
      break;
  }
  if (group_of(surface) == LandCoverGroup::kRoad) return {25, 6, LampKind::kPostTop};
  if (group_of(surface) == LandCoverGroup::kPath) return {20, 4, LampKind::kPostTop};
  return {};
}

std::vector<StreetLamp> lamps_along(const Road& road, const Box2& box) {
  std::vector<StreetLamp> lamps;
  if (!road.is_lit || lighting_of(road.surface).spacing_m == 0) return lamps;
  const Box2 reach = box.widened(max_offset_m(road) + kBeyondEdge_m);
  double start_along_m = road.start_along_m;
  for (std::size_t i = 0; i + 1 < road.axis.size(); ++i) {
    const double length_m = snapped(distance(road.axis[i], road.axis[i + 1]));
    add_lamps(lamps, road, {road.axis[i], road.axis[i + 1], start_along_m, length_m}, box, reach);
    start_along_m += length_m;
  }
  return lamps;
}

std::vector<StreetLamp> lamps_of_streets(std::span<const Road> roads, std::span<const Lamp> mapped,
                                         const ground::LandCoverIndex& surfaces, const Box2& box) {
  const std::vector<Reaching> streets = lit_streets(roads);
  std::vector<StreetLamp> lamps;
  for (const Road& road : roads)
    for (const StreetLamp& lamp : lamps_along(road, box)) {
      if (!has_room(surfaces, lamp.at) || is_near(mapped, lamp.at, lighting_of(road.surface).spacing_m)) continue;
      if (is_path(road) && is_beside(streets, lamp.at)) continue;
      lamps.push_back(lamp);
    }
  return lamps;
}

std::vector<StreetLamp> mapped_lamps(std::span<const Lamp> lamps, std::span<const Road> roads) {
  const auto streets = faced(roads, is_street), paths = faced(roads, is_path);
  std::vector<StreetLamp> standing_lamps;
  for (const Lamp& lamp : lamps) {
    const Lit street = nearest_road(streets, lamp.at);
    standing_lamps.push_back(standing(lamp, street.road ? street : nearest_road(paths, lamp.at)));
  }
  return standing_lamps;
}

}  // namespace citykiln::props
