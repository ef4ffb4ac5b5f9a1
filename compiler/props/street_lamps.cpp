#include "compiler/props/street_lamps.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"

namespace citykiln::props {
namespace {

using map::LandCoverClass;
using map::LandCoverGroup;
using roads::Road;

constexpr double kBehindKerb_m = 0.5, kBeyondEdge_m = 0.75;
// Wider carriageways are lit from both sides.
constexpr double kMaxOneSided_m = 9;
// Paths this near to the edge of a lit street need no lamps of their own.
constexpr double kBesideStreet_m = 6;
// Mapped lamps farther from all roads do not face any.
constexpr double kMaxFacing_m = 12;
constexpr Lighting kWithoutRoad = {.spacing_m = 0, .height_m = 6, .kind = LampKind::kPostTop};

LandCoverGroup group_of(LandCoverClass surface) { return map::values_of(surface).group; }
bool is_path(const Road& road) { return group_of(road.surface) == LandCoverGroup::kPath; }
bool is_street(const Road& road) { return map::is_street(road.surface); }

enum class Side : std::uint8_t { kLeft, kRight };

Side lit_side(const Road& road, std::int64_t number) {
  const bool drives_left = road.side == map::DrivingSide::kLeft;
  if (width_m(road) > kMaxOneSided_m) return drives_left == (number % 2 == 0) ? Side::kLeft : Side::kRight;
  const bool left = raised_left_m(road) > 0, right = raised_right_m(road) > 0;
  if (left != right) return left ? Side::kLeft : Side::kRight;
  return drives_left ? Side::kLeft : Side::kRight;
}

// The raised lanes of one side, from the kerb outwards.
std::vector<map::Lane> raised_lanes(const Road& road, Side side) {
  std::vector<map::Lane> lanes = road.section.lanes;
  if (side == Side::kRight) std::ranges::reverse(lanes);
  lanes.erase(std::ranges::find(lanes, false, &map::Lane::is_raised), lanes.end());
  std::ranges::reverse(lanes);
  return lanes;
}

// The distance from the axis to the foot of a lamp at a distance along the way.
double offset_m(const Road& road, Side side, double along_m) {
  const double drift = drift_m(road, along_m);
  double edge_m = side == Side::kLeft ? left_m(road) + drift : right_m(road) - drift;
  for (const map::Lane& lane : raised_lanes(road, side)) {
    if (lane.kind != map::LaneKind::kCycle) return edge_m + std::min(kBehindKerb_m, lane.width_m / 2);
    edge_m += lane.width_m;
  }
  return edge_m + kBeyondEdge_m;
}

// A straight piece of a road. length_m is snapped, as in the road's start_along_m.
struct Piece {
  Vec2 a, b;
  double start_along_m, length_m;
};

StreetLamp lamp_on(const Road& road, const Piece& piece, const Lighting& lighting, std::int64_t number) {
  const double along_m = (static_cast<double>(number) + 0.5) * lighting.spacing_m - piece.start_along_m;
  const Side side = lit_side(road, number);
  const Vec2 left = left_of(unit(piece.b - piece.a)), out = side == Side::kLeft ? left : left * -1.0;
  const Vec2 on_axis = piece.a + (piece.b - piece.a) * (along_m / piece.length_m);
  return {.at = snapped(on_axis + out * offset_m(road, side, piece.start_along_m + along_m)),
          .facing = out * -1.0,
          .height_m = lighting.height_m,
          .kind = lighting.kind,
          .feature = road.id.osm,
          .light = luminaire_of(lighting.kind, lighting.height_m)};
}

// The numbers of the lamps at distances in [from_m, to_m) along the way.
struct Numbers {
  std::int64_t first, end;
};
Numbers numbers_between(double from_m, double to_m, double spacing_m) {
  const auto number = [&](double place_m) {
    return static_cast<std::int64_t>(std::ceil(std::clamp(place_m / spacing_m - 0.5, 0.0, 0x1p53)));
  };
  return {number(from_m), number(to_m)};
}

// The lamps of a piece that may be in a box: those within its circumradius of the projection of its centre.
Numbers numbers_near(const Piece& piece, const Lighting& lighting, const Box2& box) {
  const double foot_m = dot(box.centre() - piece.a, unit(piece.b - piece.a));
  const double around_m = length(box.max - box.min) / 2 + 1;
  const double from_m = std::max(0.0, foot_m - around_m), to_m = std::min(piece.length_m, foot_m + around_m);
  return numbers_between(piece.start_along_m + from_m, piece.start_along_m + to_m, lighting.spacing_m);
}

void add_lamps(std::vector<StreetLamp>& lamps, const Road& road, const Piece& piece, const Box2& box,
               const Box2& widened) {
  const Lighting lighting = lighting_of(road.surface);
  if (piece.length_m <= 0 || !box_of_segment(piece.a, piece.b).touches(widened)) return;
  const Numbers numbers = numbers_near(piece, lighting, widened);
  for (std::int64_t number = numbers.first; number < numbers.end; ++number)
    if (const StreetLamp lamp = lamp_on(road, piece, lighting, number); box.contains_half_open(lamp.at))
      lamps.push_back(lamp);
}

// A road with an influence radius around its axis, and the box of that area.
struct RoadArea {
  const Road* road;
  double radius_m;
  Box2 box;
};

RoadArea area_around(const Road& road, double radius_m) {
  return {&road, radius_m, box_of(road.axis).widened(radius_m)};
}

// The streets whose lamps light paths beside them.
std::vector<RoadArea> lit_streets(std::span<const Road> roads) {
  std::vector<RoadArea> streets;
  for (const Road& road : roads)
    if (road.is_lit && is_street(road))
      streets.push_back(area_around(road, std::max(widest_left_m(road), widest_right_m(road)) + kBesideStreet_m));
  return streets;
}

// The roads of a kind that mapped lamps may face.
template <typename IsKind>
std::vector<RoadArea> faced_roads(std::span<const Road> roads, IsKind is_kind) {
  std::vector<RoadArea> faced;
  for (const Road& road : roads)
    if (is_kind(road)) faced.push_back(area_around(road, kMaxFacing_m));
  return faced;
}

Vec2 nearest_on(const Polyline& axis, Vec2 p) {
  Vec2 nearest = axis.front();
  for (std::size_t i = 0; i + 1 < axis.size(); ++i)
    if (const Vec2 q = nearest_point(axis[i], axis[i + 1], p); distance(p, q) < distance(p, nearest)) nearest = q;
  return nearest;
}

bool is_beside(std::span<const RoadArea> streets, Vec2 p) {
  return std::ranges::any_of(streets, [&](const RoadArea& street) {
    return street.box.contains(p) && distance(p, nearest_on(street.road->axis, p)) < street.radius_m;
  });
}

bool is_near(std::span<const Lamp> lamps, Vec2 p, double radius_m) {
  return std::ranges::any_of(lamps, [&](const Lamp& lamp) { return distance(lamp.at, p) < radius_m; });
}

// Foot paths may be the pavements of a street that are mapped separately. Things may stand where lamps may, and in
// pedestrian streets too (things/free_places.cpp): their lamps stand beside them.
bool may_have_lamps(LandCoverClass surface) {
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

bool has_room(const ground::LandCoverIndex& index, Vec2 p) {
  const std::uint32_t top = ground::land_cover_at(index, p);
  return top == ground::kNoLandCover || may_have_lamps(index.surfaces[top].surface);
}

// The road that a mapped lamp faces, and the nearest point of its axis.
struct FacedRoad {
  const Road* road = nullptr;
  Vec2 at;
};

FacedRoad nearest_road(std::span<const RoadArea> roads, Vec2 p) {
  FacedRoad faced;
  double nearest_m = kMaxFacing_m;
  for (const RoadArea& near : roads) {
    if (!near.box.contains(p)) continue;
    const Vec2 at = nearest_on(near.road->axis, p);
    if (distance(p, at) >= nearest_m) continue;
    nearest_m = distance(p, at);
    faced = {near.road, at};
  }
  return faced;
}

StreetLamp street_lamp(const Lamp& lamp, const FacedRoad& faced) {
  const Lighting lighting = faced.road ? lighting_of(faced.road->surface) : kWithoutRoad;
  const Vec2 towards = faced.road ? unit(faced.at - lamp.at) : Vec2{};
  const double height_m = lamp.height_m > 0 ? lamp.height_m : lighting.height_m;
  const LampKind kind = kind_of(lamp.light.mount, lighting.kind);
  return {.at = lamp.at,
          .facing = towards == Vec2{} ? Vec2{1, 0} : towards,
          .height_m = height_m,
          .kind = kind,
          .feature = lamp.id.osm,
          .light = luminaire_of(kind, height_m, lamp.light)};
}

}  // namespace

Lighting lighting_of(LandCoverClass surface) {
  switch (surface) {
    case LandCoverClass::kMotorwayRoad:
      return {40, kTallestStreetLamp_m, LampKind::kArm};
    case LandCoverClass::kPrimaryRoad:
      return {35, 10, LampKind::kArm};
    case LandCoverClass::kSecondaryRoad:
      return {32, 10, LampKind::kArm};
    case LandCoverClass::kTertiaryRoad:
      return {30, 8, LampKind::kArm};
    case LandCoverClass::kRunway:
      return {};
    default:
      return group_of(surface) == LandCoverGroup::kRoad   ? Lighting{25, 6, LampKind::kPostTop}
             : group_of(surface) == LandCoverGroup::kPath ? Lighting{20, 4, LampKind::kPostTop}
                                                          : Lighting{};
  }
}

std::vector<StreetLamp> lamps_along(const Road& road, const Box2& box) {
  std::vector<StreetLamp> lamps;
  if (!road.is_lit || lighting_of(road.surface).spacing_m == 0) return lamps;
  const Box2 widened = box.widened(max_offset_m(road) + kBeyondEdge_m);
  double start_along_m = road.start_along_m;
  for (std::size_t i = 0; i + 1 < road.axis.size(); ++i) {
    const double length_m = snapped(distance(road.axis[i], road.axis[i + 1]));
    add_lamps(lamps, road, {road.axis[i], road.axis[i + 1], start_along_m, length_m}, box, widened);
    start_along_m += length_m;
  }
  return lamps;
}

std::vector<StreetLamp> lamps_of_streets(std::span<const Road> roads, std::span<const Lamp> mapped,
                                         const ground::LandCoverIndex& index, const Box2& box) {
  const std::vector<RoadArea> streets = lit_streets(roads);
  std::vector<StreetLamp> lamps;
  for (const Road& road : roads)
    for (const StreetLamp& lamp : lamps_along(road, box)) {
      if (!has_room(index, lamp.at) || is_near(mapped, lamp.at, lighting_of(road.surface).spacing_m)) continue;
      if (is_path(road) && is_beside(streets, lamp.at)) continue;
      lamps.push_back(lamp);
    }
  return lamps;
}

std::vector<StreetLamp> mapped_lamps(std::span<const Lamp> lamps, std::span<const Road> roads) {
  const auto streets = faced_roads(roads, is_street), paths = faced_roads(roads, is_path);
  std::vector<StreetLamp> street_lamps;
  for (const Lamp& lamp : lamps) {
    const FacedRoad street = nearest_road(streets, lamp.at);
    street_lamps.push_back(street_lamp(lamp, street.road ? street : nearest_road(paths, lamp.at)));
  }
  return street_lamps;
}

}  // namespace citykiln::props
