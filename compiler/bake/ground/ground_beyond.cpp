#include "compiler/bake/ground/ground_beyond.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "compiler/ground/plan.h"

namespace citykiln::bake {
namespace {

struct Interval {
  double from, to;
};

// The tile's own interval, then those beside it where the extent ends.
std::vector<Interval> intervals(Interval tile, Interval extent) {
  std::vector<Interval> all;
  all.reserve(3);  // g++ 12 otherwise warns of an array bound that is not passed
  all.push_back(tile);
  if (tile.from == extent.from) all.push_back({tile.from - kBeyond_m, tile.from});
  if (tile.to == extent.to) all.push_back({tile.to, tile.to + kBeyond_m});
  return all;
}

// A part of the plane beside the tile and beyond the extent.
struct Zone {
  Box2 box;
  bool is_sideways;  // west or east of the extent: the next tile beyond is north or south of it
};

std::vector<Zone> zones_beyond(const Box2& tile, const Box2& extent) {
  const std::vector<Interval> columns = intervals({tile.min.x, tile.max.x}, {extent.min.x, extent.max.x}),
                              rows = intervals({tile.min.y, tile.max.y}, {extent.min.y, extent.max.y});
  std::vector<Zone> zones;
  for (std::size_t i = 0; i < columns.size(); ++i)
    for (std::size_t j = 0; j < rows.size(); ++j)
      if (i + j > 0) zones.push_back({{{columns[i].from, rows[j].from}, {columns[i].to, rows[j].to}}, i > 0});
  return zones;
}

std::vector<Box2> footprint_boxes(const scene::Chunk& chunk) {
  std::vector<Box2> boxes;
  for (const buildings::Building& building : chunk.buildings)
    if (building.stands_on_ground) boxes.push_back(box_of(building.footprint.outer));
  for (const ground::LandCoverPolygon& surface : chunk.surfaces)
    if (map::values_of(surface.surface).group == map::LandCoverGroup::kBuilding)
      boxes.push_back(ground::box_of(surface));
  return boxes;
}

bool overlap(const Box2& a, const Box2& b) {
  return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y;
}

// The smallest odd metre that is at least v, the largest that is at most v: sides of tiles are even, so a box either
// crosses the side between two tiles or ends a metre before it, as both tiles see.
double odd_above(double v) { return 2 * std::ceil((v - 1) / 2) + 1; }
double odd_below(double v) { return 2 * std::floor((v - 1) / 2) + 1; }

// The intervals of y that boxes cover between two neighbouring x, merged where they meet.
std::vector<Interval> covered(const std::vector<Box2>& boxes, double from_x, double to_x) {
  std::vector<Interval> all;
  for (const Box2& box : boxes)
    if (box.min.x <= from_x && to_x <= box.max.x) all.push_back({box.min.y, box.max.y});
  std::ranges::sort(all, {}, &Interval::from);
  std::vector<Interval> merged;
  for (const Interval& next : all) {
    if (!merged.empty() && next.from <= merged.back().to)
      merged.back().to = std::max(merged.back().to, next.to);
    else
      merged.push_back(next);
  }
  return merged;
}

// The area of all boxes as boxes that do not overlap, from west to east. Beside a line of equal x they depend only on
// the boxes at that line.
std::vector<Box2> disjoint(const std::vector<Box2>& boxes) {
  std::vector<double> xs;
  for (const Box2& box : boxes) xs.insert(xs.end(), {box.min.x, box.max.x});
  std::ranges::sort(xs);
  xs.erase(std::unique(xs.begin(), xs.end()), xs.end());
  std::vector<Box2> all;
  for (std::size_t i = 0; i + 1 < xs.size(); ++i)
    for (const Interval& y : covered(boxes, xs[i], xs[i + 1])) {
      const auto before = std::ranges::find_if(
          all, [&](const Box2& box) { return box.max.x == xs[i] && box.min.y == y.from && box.max.y == y.to; });
      if (before != all.end())
        before->max.x = xs[i + 1];
      else
        all.push_back({{xs[i], y.from}, {xs[i + 1], y.to}});
    }
  return all;
}

bool contains(const Box2& outer, const Box2& inner) { return outer.contains(inner.min) && outer.contains(inner.max); }

Box2 transposed(const Box2& box) { return {{box.min.y, box.min.x}, {box.max.y, box.max.x}}; }

// Does the same as disjoint(), from south to north.
std::vector<Box2> disjoint_by_rows(std::vector<Box2> boxes) {
  std::ranges::transform(boxes, boxes.begin(), transposed);
  boxes = disjoint(boxes);
  std::ranges::transform(boxes, boxes.begin(), transposed);
  return boxes;
}

Box2 in_both(const Box2& a, const Box2& b) {
  return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y)},
          {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y)}};
}

}  // namespace

std::vector<Box2> ground_beyond(const scene::Header& header, const scene::Chunk& chunk) {
  std::vector<Box2> footprints = footprint_boxes(chunk);
  std::erase_if(footprints, [&](const Box2& box) { return contains(header.extent, box); });
  std::vector<Box2> all;
  for (const auto& [zone, is_sideways] : zones_beyond(scene::box_of(header, chunk.tile), header.extent)) {
    std::vector<Box2> boxes;
    for (const Box2& footprint : footprints) {
      const Box2 whole{{odd_below(footprint.min.x), odd_below(footprint.min.y)},
                       {odd_above(footprint.max.x), odd_above(footprint.max.y)}};
      if (overlap(whole, zone)) boxes.push_back(in_both(whole, zone));
    }
    std::ranges::move(is_sideways ? disjoint_by_rows(boxes) : disjoint(boxes), std::back_inserter(all));
  }
  return all;
}

}  // namespace citykiln::bake
