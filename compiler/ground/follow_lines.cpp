#include "compiler/ground/follow_lines.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/geometry/snap.h"
#include "compiler/ground/height_layer.h"

namespace citykiln::ground {
namespace {

// Shorter lines are not cut.
constexpr double kShortest_m = 2;

// By how much the ground is carved out of the terrain: the terrain's own bends have lines of their own.
Heights carved_at(const Carving& carving, Vec2 p) {
  Heights carved = heights_at(carving, p);
  const double terrain_m = map::height_m_at(carving.terrain, p);
  for (double& height : carved) height -= terrain_m;
  return carved;
}

// A place on a line.
struct Station {
  Vec2 at;
  Heights carved;
};

Station station_at(const Carving& carving, Vec2 p) { return {p, carved_at(carving, p)}; }

// How far it strays from what is straight between a and b at a share of the way, on the layer where most.
double stray_m(const Heights& a, const Heights& b, const Heights& here, double share) {
  double most_m = 0;
  for (std::size_t layer = 0; layer < here.size(); ++layer)
    most_m = std::max(most_m, std::abs(here[layer] - (a[layer] + (b[layer] - a[layer]) * share)));
  return most_m;
}

bool is_straight(const Carving& carving, const Station& a, const Station& middle, const Station& b) {
  if (stray_m(a.carved, b.carved, middle.carved, 0.5) > kFollow_m) return false;
  for (const double share : {0.25, 0.75})
    if (stray_m(a.carved, b.carved, carved_at(carving, a.at + (b.at - a.at) * share), share) > kFollow_m) return false;
  return true;
}

void add_bends(const Carving& carving, const Station& a, const Station& b, std::vector<Vec2>& bends) {
  if (distance(a.at, b.at) < kShortest_m) return;
  const Station middle = station_at(carving, snapped((a.at + b.at) * 0.5));
  if (is_straight(carving, a, middle, b)) return;
  add_bends(carving, a, middle, bends);
  bends.push_back(middle.at);
  add_bends(carving, middle, b, bends);
}

bool is_bent_already(const Surface& surface) {
  const HeightLayer layer = layer_of(surface);
  return layer == HeightLayer::kRoad || layer == HeightLayer::kCarriageway;
}

Ring bent_ring(const Ring& ring, const Carving& carving, const Box2& near) {
  Ring bent;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
    bent.push_back(a);
    if (!box_of(std::array{a, b}).touches(near)) continue;
    const std::vector<Vec2> bends = bends_along(carving, a, b);
    bent.insert(bent.end(), bends.begin(), bends.end());
  }
  return bent;
}

// Along a side of a cell, metre by metre, by how much the ground is carved out of the terrain.
struct Side {
  std::vector<Vec2> places;
  std::vector<Heights> carved;
};

Side side_from(const Carving& carving, Vec2 from, Vec2 to) {
  Side side;
  const auto count = static_cast<int>(distance(from, to));
  for (int i = 0; i <= count; ++i) {
    const Vec2 p = from + (to - from) * (static_cast<double>(i) / count);
    side.places.push_back(p), side.carved.push_back(carved_at(carving, p));
  }
  return side;
}

double bend_m(const Side& side, std::size_t first, std::size_t last) {
  double most_m = 0;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double share = static_cast<double>(i - first) / static_cast<double>(last - first);
    most_m = std::max(most_m, stray_m(side.carved[first], side.carved[last], side.carved[i], share));
  }
  return most_m;
}

void split_side(const Side& side, std::size_t first, std::size_t last, std::vector<GridPoint>& points) {
  if (last - first < 2 || bend_m(side, first, last) <= kFollow_m) return;
  const std::size_t middle = (first + last) / 2;
  split_side(side, first, middle, points);
  points.push_back(grid_point(side.places[middle]));
  split_side(side, middle, last, points);
}

}  // namespace

std::vector<Vec2> bends_along(const Carving& carving, Vec2 a, Vec2 b) {
  std::vector<Vec2> bends;
  if (distance(a, b) < kShortest_m) return bends;
  const bool is_turned = b < a;
  if (is_turned) std::swap(a, b);
  add_bends(carving, station_at(carving, a), station_at(carving, b), bends);
  if (is_turned) std::ranges::reverse(bends);
  return bends;
}

std::vector<Surface> bent_rings(std::span<const Surface> surfaces, const Carving& carving, const Box2& cell) {
  // what lies farther off cannot touch the cell
  constexpr double kNear_m = 1;
  std::vector<Surface> bent(surfaces.begin(), surfaces.end());
  for (Surface& surface : bent) {
    if (is_bent_already(surface)) continue;
    for (Ring& ring : surface.rings) ring = bent_ring(ring, carving, cell.widened(kNear_m));
  }
  return bent;
}

std::vector<GridPoint> bends_on_border(const Carving& carving, const Box2& cell) {
  std::vector<GridPoint> points;
  const Vec2 sw = cell.min, ne = cell.max, se{ne.x, sw.y}, nw{sw.x, ne.y};
  for (const auto& [from, to] : {std::pair{sw, se}, {sw, nw}, {se, ne}, {nw, ne}}) {
    const Side side = side_from(carving, from, to);
    split_side(side, 0, side.places.size() - 1, points);
  }
  return points;
}

}  // namespace citykiln::ground
