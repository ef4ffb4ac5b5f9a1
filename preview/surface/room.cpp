#include "preview/surface/room.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compiler/geometry/trig.h"
#include "preview/surface/microfacet.h"

namespace citykiln::preview {
namespace {

// Reflectances of plaster, wood and white paint.
constexpr Rgb kWall = {0.58, 0.56, 0.52}, kFloor = {0.20, 0.17, 0.14}, kCeiling = {0.75, 0.74, 0.71};

// A box in the pane's frame: x across, y up, z inward from the pane's corner.
struct Room {
  Vec3 low, high;
};

// A surface of a room.
struct Spot {
  Vec3 at, normal;
  Rgb albedo;
};

// A number in [0, 1) by the pane's place, to a decimetre.
double share_of(const Pane& pane, Vec3 origin, std::uint64_t salt) {
  const Vec3 p = pane.corner + origin;
  std::uint64_t h = salt * 0x9e3779b97f4a7c15u;
  for (const double v : {p.x, p.y, p.z}) {
    // off the grid of positions, so that both triangles of a pane, which round differently, agree
    constexpr double kOff = 0.3123;
    h ^= static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(v * 10 + kOff)));
    h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u, h = (h ^ (h >> 27)) * 0x94d049bb133111ebu, h ^= h >> 31;
  }
  return static_cast<double>(h >> 11) * 0x1p-53;
}

Room room_behind(const Pane& pane, Vec3 origin) {
  constexpr double kSill_m = 0.9, kLintel_m = 0.3, kDoorHeight_m = 1.8;
  const double left = 0.2 + 1.2 * share_of(pane, origin, 1), right = 0.2 + 1.2 * share_of(pane, origin, 2);
  const double deep = std::max(3 + 2.5 * share_of(pane, origin, 3), 1.5 * pane.height_m);
  const double below = pane.height_m > kDoorHeight_m ? 0.05 : kSill_m;
  return {{-left, -below, 0}, {pane.width_m + right, pane.height_m + kLintel_m, deep}};
}

Vec3 in_pane(const Pane& pane, Vec3 v) { return {dot(v, pane.across), dot(v, pane.up), dot(v, pane.inward)}; }
Vec3 out_of_pane(const Pane& pane, Vec3 v) { return pane.across * v.x + pane.up * v.y + pane.inward * v.z; }

// Where a ray from inside meets the box.
Spot spot_on(const Room& room, Vec3 from, Vec3 direction) {
  const double at[3] = {from.x, from.y, from.z}, d[3] = {direction.x, direction.y, direction.z};
  const double low[3] = {room.low.x, room.low.y, room.low.z}, high[3] = {room.high.x, room.high.y, room.high.z};
  int nearest = 2;
  double distance = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    if (d[axis] == 0) continue;
    const double to = ((d[axis] > 0 ? high[axis] : low[axis]) - at[axis]) / d[axis];
    if (to < distance) distance = std::max(0.0, to), nearest = axis;
  }
  const double sign = d[nearest] > 0 ? -1 : 1;
  const Vec3 normal{nearest == 0 ? sign : 0, nearest == 1 ? sign : 0, nearest == 2 ? sign : 0};
  return {from + direction * distance, normal, nearest != 1 ? kWall : sign > 0 ? kFloor : kCeiling};
}

Vec3 scattered(const Spot& spot, UnitPair chance) {
  const double r = std::sqrt(chance.u), turn = 2 * kPi * chance.v;
  return frame_about(spot.normal).out_of({r * std::cos(turn), r * std::sin(turn), std::sqrt(1 - chance.u)});
}

bool is_on_pane(const Pane& pane, const Spot& spot) {
  return spot.normal.z > 0 && spot.at.x > 0 && spot.at.y > 0 && spot.at.x < pane.width_m && spot.at.y < pane.height_m;
}

}  // namespace

Vec3 out_of_plane(Vec3 normal, Vec3 at) {
  constexpr double kWide_m = 1.5, kHigh_m = 1.8, kMost = 0.005;
  if (std::abs(normal.z) > 0.7) return normal;
  const Vec3 across = unit(Vec3{-normal.y, normal.x, 0}), up = cross(normal, across);
  const double x = dot(at, across) / kWide_m, y = dot(at, up) / kHigh_m;
  const double column = std::floor(x), row = std::floor(y);
  Pane pane;
  pane.corner = {column, row, std::floor(dot(at, normal))};
  const auto off = [&](std::uint64_t salt, double part) {
    return kMost * (2 * share_of(pane, {}, salt) - 1 + 2 * (part - 0.5));
  };
  return unit(normal + across * off(5, x - column) + up * off(6, y - row));
}

std::optional<Pane> pane_of(const Vec3 (&triangle)[3]) {
  constexpr double kLeast_m = 0.2, kUpright = 0.1, kOff_m = 0.02;
  const Vec3 normal = unit(cross(triangle[1] - triangle[0], triangle[2] - triangle[0]));
  if (!(dot(normal, normal) > 0) || std::abs(normal.z) > kUpright) return std::nullopt;
  Pane pane{.across = unit(Vec3{-normal.y, normal.x, 0}), .inward = normal * -1};
  pane.up = cross(normal, pane.across);
  constexpr double kFar = std::numeric_limits<double>::infinity();
  double left = kFar, right = -kFar, low = kFar, high = -kFar;
  for (const Vec3& p : triangle) {
    const double x = dot(p - triangle[0], pane.across), y = dot(p - triangle[0], pane.up);
    left = std::min(left, x), right = std::max(right, x), low = std::min(low, y), high = std::max(high, y);
  }
  pane.width_m = right - left, pane.height_m = high - low;
  pane.corner = triangle[0] + pane.across * left + pane.up * low;
  const auto is_corner = [&](const Vec3& p) {
    const double x = dot(p - pane.corner, pane.across), y = dot(p - pane.corner, pane.up);
    return std::min(x, pane.width_m - x) < kOff_m && std::min(y, pane.height_m - y) < kOff_m;
  };
  const bool is_half = std::ranges::all_of(triangle, is_corner);
  return is_half && std::min(pane.width_m, pane.height_m) >= kLeast_m ? std::optional(pane) : std::nullopt;
}

RoomWay way_through_room(const Pane& pane, Vec3 origin, Vec3 at, Vec3 direction, PathDraw& draw) {
  const Room room = room_behind(pane, origin);
  Spot spot = spot_on(room, in_pane(pane, at - pane.corner), in_pane(pane, direction));
  RoomWay way{.seen_at = pane.corner + out_of_pane(pane, spot.at),
              .albedo = spot.albedo,
              .normal = out_of_pane(pane, spot.normal)};
  // half of the ways go by one more surface
  const UnitPair choice = draw.next();
  Rgb weight = spot.albedo * 2;
  if (choice.u < 0.5) {
    spot = spot_on(room, spot.at + spot.normal * 1e-4, scattered(spot, {2 * choice.u, choice.v}));
    // light straight through the pane is the other half's
    if (is_on_pane(pane, spot)) return way;
    weight = weight * spot.albedo;
  }
  const UnitPair on_pane = draw.next();
  const Vec3 opening{on_pane.u * pane.width_m, on_pane.v * pane.height_m, 0}, to = opening - spot.at;
  const double distance2 = dot(to, to), here = dot(to, spot.normal), there = -to.z;
  if (here <= 0 || there <= 0) return way;
  const double area = pane.width_m * pane.height_m;
  way.weight = weight * (here * there * area / (kPi * distance2 * distance2));
  way.from = pane.corner + out_of_pane(pane, opening), way.direction = unit(out_of_pane(pane, to));
  return way;
}

}  // namespace citykiln::preview
