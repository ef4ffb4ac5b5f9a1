#include "compiler/invent/town/water_distance.h"

#include <algorithm>

#include "compiler/geometry/segment.h"

namespace citykiln::invent {
namespace {

// marks the points of a row that lie in a polygon
void fill_row(TownRaster<double>& wet, const Polygon& polygon, int row) {
  const double y = wet.place(0, row).y;
  std::vector<double> crossings;
  for (const Ring* ring : rings_of(polygon))
    for (std::size_t i = 0, j = ring->size() - 1; i < ring->size(); j = i++) {
      const Vec2 a = (*ring)[j], b = (*ring)[i];
      if ((a.y <= y) != (b.y <= y)) crossings.push_back(a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)));
    }
  std::ranges::sort(crossings);
  const double west = -wet.side_m / 2;
  for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
    const int first = std::max(0, static_cast<int>(std::ceil((crossings[k] - west) / wet.step_m)));
    const int last = std::min<int>(wet.cells, static_cast<int>(std::floor((crossings[k + 1] - west) / wet.step_m)));
    for (int column = first; column <= last; ++column) wet.values[wet.index(column, row)] = 0;
  }
}

void fill_polygon(TownRaster<double>& wet, const Polygon& polygon) {
  const Box2 box = box_of(polygon.outer);
  if (box.is_empty()) return;
  for (int row = wet.row(box.min.y); row <= wet.row(box.max.y); ++row) fill_row(wet, polygon, row);
}

// marks the points within half a width of a piece of a river
void fill_reach(TownRaster<double>& wet, Vec2 a, Vec2 b, double half_m) {
  Box2 box;
  box.grow(a);
  box.grow(b);
  box = box.widened(half_m);
  if (box.max.x < -wet.side_m / 2 || box.min.x > wet.side_m / 2) return;
  for (int row = wet.row(box.min.y); row <= wet.row(box.max.y); ++row)
    for (int column = wet.column(box.min.x); column <= wet.column(box.max.x); ++column)
      if (distance_to_segment(a, b, wet.place(column, row)) <= half_m) wet.values[wet.index(column, row)] = 0;
}

void fill_river(TownRaster<double>& wet, const River& river) {
  for (std::size_t i = 0; i + 1 < river.axis.size(); ++i) {
    const double widest_m = std::max(river.width_m[i], river.width_m[i + 1]);
    fill_reach(wet, river.axis[i], river.axis[i + 1], std::max(widest_m / 2, wet.step_m * 0.7));
  }
}

// one pass of the chamfer transform; sign is 1 from the south-west, -1 from the north-east
void pass_distances(TownRaster<double>& wet, int sign) {
  const int n = wet.cells;
  const auto relax = [&](double& value, int column, int row, double cost) {
    if (column >= 0 && column <= n && row >= 0 && row <= n)
      value = std::min(value, wet.values[wet.index(column, row)] + cost * wet.step_m);
  };
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const int column = sign > 0 ? i : n - i, row = sign > 0 ? j : n - j;
      double& value = wet.values[wet.index(column, row)];
      relax(value, column - sign, row, 1);
      relax(value, column, row - sign, 1);
      relax(value, column - sign, row - sign, 1.414);
      relax(value, column + sign, row - sign, 1.414);
    }
}

}  // namespace

WaterDistance water_distance(const Terrain& terrain, double side_m) {
  WaterDistance water{TownRaster<double>(side_m, std::max(4.0, side_m / 1250))};
  std::ranges::fill(water.distance_m.values, kFarFromWater_m);
  for (const Polygon& lake : terrain.lakes) fill_polygon(water.distance_m, lake);
  for (const Polygon& sea : terrain.sea) fill_polygon(water.distance_m, sea);
  for (const River& river : terrain.rivers) fill_river(water.distance_m, river);
  pass_distances(water.distance_m, 1);
  pass_distances(water.distance_m, -1);
  return water;
}

}  // namespace citykiln::invent
