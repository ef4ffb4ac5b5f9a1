#include "tests/compiler/parcels/made_land.h"

#include <algorithm>
#include <set>

#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/arrangement.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/ring_crossing.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"
#include "compiler/geometry/trig.h"

namespace citykiln::parcels {
namespace {

// Draws numbers in turn.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : sequence_(seed, StableId{1}, "land") {}
  double between(double low, double high) { return sequence_.between(low, high, next_++); }
  bool is(double share) { return between(0, 1) < share; }

 private:
  RandomSequence sequence_;
  std::uint32_t next_ = 0;
};

void add_grid_streets(Land& land, Draw& draw, double side_m) {
  const double step = draw.between(45, 140);
  const int count = static_cast<int>(side_m / step) + 1;
  std::vector<Vec2> nodes;
  for (int y = 0; y <= count; ++y)
    for (int x = 0; x <= count; ++x)
      nodes.push_back(
          snapped(Vec2{x * step + draw.between(-0.3, 0.3) * step, y * step + draw.between(-0.3, 0.3) * step}));
  const auto add = [&](int a, int b) {
    const Vec2 p = nodes[static_cast<std::size_t>(a)], q = nodes[static_cast<std::size_t>(b)];
    if (draw.is(0.2)) return;
    Line line = street(land.lines.size() + 1, {p, q}, draw.is(0.12) ? LineKind::kBarrier : LineKind::kStreet,
                       draw.between(1, 8));
    if (draw.is(0.4))
      line.axis.insert(line.axis.begin() + 1,
                       snapped((p + q) * 0.5 + Vec2{draw.between(-15, 15), draw.between(-15, 15)}));
    if (draw.is(0.3)) line.right_m = draw.between(0, 12);
    if (draw.is(0.1)) line.axis.push_back(line.axis.back());
    if (draw.is(0.05)) std::ranges::reverse(line.axis);
    land.lines.push_back(line);
  };
  for (int y = 0; y <= count; ++y)
    for (int x = 0; x <= count; ++x) {
      if (x < count) add(y * (count + 1) + x, y * (count + 1) + x + 1);
      if (y < count) add(y * (count + 1) + x, (y + 1) * (count + 1) + x);
    }
}

void add_wild_lines(Land& land, Draw& draw, double side_m) {
  for (int i = 0; i < 6; ++i) {
    Polyline axis = {snapped(Vec2{draw.between(0, side_m), draw.between(0, side_m)})};
    for (int k = 0; k < 4; ++k)
      axis.push_back(snapped(axis.back() + Vec2{draw.between(-60, 60), draw.between(-60, 60)}));
    if (draw.is(0.3)) axis.push_back(axis.front());
    const LineKind kinds[] = {LineKind::kStreet, LineKind::kBarrier, LineKind::kNone};
    land.lines.push_back(
        street(land.lines.size() + 1, axis, kinds[static_cast<int>(draw.between(0, 3))], draw.between(0, 6)));
  }
  if (land.lines.size() > 2 && draw.is(0.5)) {  // one line twice
    Line twice = land.lines[1];
    twice.id = StableId{land.lines.size() + 1};
    land.lines.push_back(twice);
  }
}

Ring turned_rectangle(Draw& draw, double side_m, double least_m, double most_m) {
  const Vec2 at{draw.between(0, side_m), draw.between(0, side_m)};
  const Vec2 u = direction_of(draw.between(0, 1)) * draw.between(least_m, most_m);
  const Vec2 v = unit(left_of(u)) * draw.between(least_m, most_m);
  return {snapped(at), snapped(at + u), snapped(at + u + v), snapped(at + v)};
}

std::int64_t twice_area_of_ring(const Ring& ring) {
  std::int64_t sum = 0;
  const GridPoint corner = grid_point(ring.front());
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    sum += turn(corner, grid_point(ring[j]), grid_point(ring[i]));
  return sum;
}

std::int64_t twice_area_of_polygon(const Polygon& polygon) {
  std::int64_t sum = 0;
  for (const Ring* ring : rings_of(polygon)) sum += twice_area_of_ring(*ring);
  return sum;
}

// A point well inside: beside the middle of the longest edge, half a grid step away.
Vec2 inner_point(const Polygon& polygon) {
  const Ring& ring = polygon.outer;
  std::size_t best = 0;
  const auto end_of = [&](std::size_t i) { return ring[(i + 1) % ring.size()]; };
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (distance(ring[i], end_of(i)) > distance(ring[best], end_of(best))) best = i;
  return (ring[best] + end_of(best)) * 0.5 + left_of(unit(end_of(best) - ring[best])) * 0x1p-11;
}

bool cross_properly(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const auto sign = [](Vec2 p, Vec2 q, Vec2 r) {
    const std::int64_t t = turn(grid_point(p), grid_point(q), grid_point(r));
    return t > 0 ? 1 : t < 0 ? -1 : 0;
  };
  return sign(a, b, c) * sign(a, b, d) < 0 && sign(c, d, a) * sign(c, d, b) < 0;
}

bool cross_each_other(const Ring& a, const Ring& b) {
  for (std::size_t i = 0, j = a.size() - 1; i < a.size(); j = i++)
    for (std::size_t k = 0, l = b.size() - 1; k < b.size(); l = k++)
      if (cross_properly(a[j], a[i], b[l], b[k])) return true;
  return false;
}

void expect_rings(const Polygon& polygon, const std::string& what) {
  EXPECT_GT(twice_area_of_ring(polygon.outer), 0) << what;
  for (const Ring* ring : rings_of(polygon)) {
    // quadratic: large rings of blocks are left out
    EXPECT_TRUE(ring->size() > 1500 || is_simple(*ring)) << what;
    EXPECT_TRUE(ring == &polygon.outer || twice_area_of_ring(*ring) < 0) << what;
  }
}

void expect_no_overlap(const std::vector<Lot>& lots, const std::string& what) {
  std::vector<Box2> boxes;
  for (const Lot& lot : lots) boxes.push_back(box_of(lot.polygon.outer));
  const BoxGrid grid = grid_of(boxes, 64);
  for (std::uint32_t i = 0; i < lots.size(); ++i)
    for (const std::uint32_t j : boxes_about(grid, boxes[i])) {
      if (i == j || !boxes[i].touches(boxes[j])) continue;
      const Vec2 inner = inner_point(lots[i].polygon);
      // a lot may be narrower than half a step there
      EXPECT_FALSE(contains(lots[i].polygon, inner) && contains(lots[j].polygon, inner))
          << what << " lots " << i << " " << j;
      EXPECT_FALSE(i < j && cross_each_other(lots[i].polygon.outer, lots[j].polygon.outer)) << what;
    }
}

// How far a right-of-way's edge may lie from where the line's width says: at a bend, at an end, or at a joint with
// wider lines.
double widest_joint_m(const Land& land, const Line& line) {
  double widest_m = line.left_m + line.right_m;
  for (const Line& other : land.lines)
    for (const Vec2 p : other.axis)
      if (std::ranges::find(line.axis, p) != line.axis.end())
        widest_m = std::max(widest_m, other.left_m + other.right_m);
  return widest_m;
}

// True if some edge of the lot lies on the edge of its frontage's right-of-way.
bool is_front_on_strip(const Land& land, const Lot& lot) {
  const Line& line = land.lines[lot.frontage.line];
  const double half = std::max(lot.frontage.side == Side::kLeft ? line.left_m : line.right_m, kLeastRightOfWay_m);
  const Ring& ring = lot.polygon.outer;
  double least = 1e9;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    least = std::min(least, std::abs(distance_to_polyline(line.axis, (ring[i] + ring[j]) * 0.5) - half));
  return least < widest_joint_m(land, line);
}

void expect_fronts(const Land& land, const std::vector<Lot>& lots, const std::string& what) {
  std::size_t off_strip = 0;
  for (const Lot& lot : lots) {
    EXPECT_EQ(land.lines[lot.frontage.line].kind, LineKind::kStreet) << what;
    EXPECT_GT(lot.frontage.length_m, 0) << what;
    off_strip += !is_front_on_strip(land, lot);
  }
  // rights-of-way that overlap share edges, and an edge names one of them
  EXPECT_LE(off_strip, 5 + lots.size() / 1000) << what;
}

void expect_homes(const Land& land, const Parcels& parcels, const std::string& what) {
  std::vector<int> homes(land.footprints.size(), 0);
  for (const Lot& lot : parcels.lots)
    for (const std::uint32_t f : lot.footprints) ++homes[f];
  for (const Failure& failure : parcels.failures) ++homes[failure.footprint];
  EXPECT_TRUE(std::ranges::all_of(homes, [](int count) { return count == 1; })) << what;
}

}  // namespace

Land random_land(std::uint64_t seed, double side_m) {
  Draw draw(seed);
  Land land;
  land.extent = {{0, 0}, {side_m, side_m}};
  if (draw.is(0.3)) land.extent = {{7.5, -3.25}, {side_m - 20.125, side_m - 11}};
  add_grid_streets(land, draw, side_m);
  add_wild_lines(land, draw, side_m);
  for (int i = 0; i < 3; ++i) land.taken.push_back({turned_rectangle(draw, side_m, 5, 70), {}});
  const int count = static_cast<int>(draw.between(0, side_m * side_m / 900));
  for (int i = 0; i < count; ++i)
    land.footprints.push_back({StableId{static_cast<std::uint64_t>(1000 + i)}, turned_rectangle(draw, side_m, 3, 22)});
  land.split_empty = draw.is(0.5);
  return land;
}

void expect_properties(const Land& land, const Parcels& parcels, const std::string& what) {
  std::int64_t blocks = 0, parts = 0;
  for (const Block& block : parcels.blocks) {
    expect_rings(block.polygon, what + " block");
    blocks += twice_area_of_polygon(block.polygon);
  }
  std::set<StableId> ids;
  for (const Lot& lot : parcels.lots) {
    expect_rings(lot.polygon, what + " lot");
    parts += twice_area_of_polygon(lot.polygon);
    EXPECT_TRUE(ids.insert(lot.id).second) << what;
    ASSERT_LT(lot.block, parcels.blocks.size());
    EXPECT_TRUE(contains(parcels.blocks[lot.block].polygon, inner_point(lot.polygon))) << what;
  }
  for (const Polygon& rest : parcels.rest) {
    expect_rings(rest, what + " rest");
    parts += twice_area_of_polygon(rest);
  }
  EXPECT_EQ(blocks, parts) << what;
  expect_fronts(land, parcels.lots, what);
  expect_no_overlap(parcels.lots, what);
  expect_homes(land, parcels, what);
}

}  // namespace citykiln::parcels
