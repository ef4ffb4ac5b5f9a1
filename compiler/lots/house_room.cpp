#include "compiler/lots/house_room.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "compiler/geometry/snap.h"

namespace citykiln::lots {
namespace {

constexpr double kStep_m = 0.5;

struct Interval {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  double width() const { return high - low; }
};

// The rings of a lot in its frame.
std::vector<Ring> local_rings(const Polygon& lot, const Frame& frame) {
  std::vector<Ring> rings;
  for (const Ring* ring : rings_of(lot)) {
    Ring& local = rings.emplace_back();
    for (const Vec2 p : *ring) local.push_back(frame.local(p));
  }
  return rings;
}

// The part of the line at a depth that lies in the lot and contains x = 0; without width if that is outside.
Interval inside_at(const std::vector<Ring>& rings, double y) {
  Interval inside;
  int crossings_left = 0;
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
      if ((a.y <= y) == (b.y <= y)) continue;
      const double x = a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
      if (x <= 0) ++crossings_left, inside.low = std::max(inside.low, x);
      if (x > 0) inside.high = std::min(inside.high, x);
    }
  return crossings_left % 2 == 1 ? inside : Interval{0, 0};
}

bool has_corner_in(const std::vector<Ring>& rings, const Box2& box) {
  const Box2 inner = box.widened(-0.01);
  for (const Ring& ring : rings)
    if (std::ranges::any_of(ring, [&](Vec2 p) { return inner.contains(p); })) return true;
  return false;
}

// A rectangle as wide as allowed, in the middle of an interval.
Box2 centred(Interval x, double from_y, double to_y, double most_width_m) {
  const double half_m = std::min(x.width(), most_width_m) / 2, middle = (x.low + x.high) / 2;
  return {{middle - half_m, from_y}, {middle + half_m, to_y}};
}

}  // namespace

std::optional<Box2> room_for_house(const Polygon& lot, const Frame& frame, const RoomSizes& sizes) {
  const std::vector<Ring> rings = local_rings(lot, frame);
  const double rear_m = std::max(sizes.beside_m, kLeastRear_m);
  std::optional<Box2> best;
  Interval room;
  for (double y = sizes.setback_m; y <= sizes.setback_m + sizes.most_depth_m; y += kStep_m) {
    const Interval inside = inside_at(rings, y);
    room.low = std::max(room.low, inside.low + sizes.beside_m);
    room.high = std::min(room.high, inside.high - sizes.beside_m);
    if (room.width() < kLeastHouse_m || inside_at(rings, y + rear_m).width() <= 0) break;
    const Box2 box = centred(room, sizes.setback_m, y, sizes.most_width_m);
    if (box.height() < kLeastHouse_m || has_corner_in(rings, box)) continue;
    if (!best || box.width() * box.height() > best->width() * best->height()) best = box;
  }
  return best;
}

Polygon plane_rectangle(const Frame& frame, const Box2& box) {
  const Vec2 low = box.min, high = box.max;
  Ring ring = {frame.plane(low), frame.plane({high.x, low.y}), frame.plane(high), frame.plane({low.x, high.y})};
  if (cross(frame.along, frame.inward) < 0) ring = {ring[1], ring[0], ring[3], ring[2]};
  for (Vec2& p : ring) p = snapped(p);
  return {.outer = std::move(ring), .holes = {}};
}

}  // namespace citykiln::lots
