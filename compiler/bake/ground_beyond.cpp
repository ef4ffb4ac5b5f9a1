#include "compiler/bake/ground_beyond.h"

#include <algorithm>
#include <array>
#include <cmath>

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

std::vector<Box2> zones_beyond(const Box2& tile, const Box2& extent) {
  const std::vector<Interval> columns = intervals({tile.min.x, tile.max.x}, {extent.min.x, extent.max.x}),
                              rows = intervals({tile.min.y, tile.max.y}, {extent.min.y, extent.max.y});
  std::vector<Box2> zones;
  for (std::size_t i = 0; i < columns.size(); ++i)
    for (std::size_t j = 0; j < rows.size(); ++j)
      if (i + j > 0) zones.push_back({{columns[i].from, rows[j].from}, {columns[i].to, rows[j].to}});
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

// Adds a box; boxes that overlap become the box around both.
void add(std::vector<Box2>& boxes, Box2 box) {
  for (auto other = boxes.begin(); other != boxes.end();) {
    if (!overlap(*other, box)) {
      ++other;
      continue;
    }
    box.grow(other->min), box.grow(other->max);
    boxes.erase(other);
    other = boxes.begin();
  }
  boxes.push_back(box);
}

Box2 in_both(const Box2& a, const Box2& b) {
  return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y)},
          {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y)}};
}

}  // namespace

std::vector<Box2> ground_beyond(const scene::Header& header, const scene::Chunk& chunk) {
  std::vector<Box2> all;
  const std::vector<Box2> footprints = footprint_boxes(chunk);
  for (const Box2& zone : zones_beyond(scene::box_of(header, chunk.tile), header.region)) {
    std::vector<Box2> boxes;
    for (const Box2& footprint : footprints) {
      if (!overlap(footprint, zone)) continue;
      const Box2 whole{{std::floor(footprint.min.x), std::floor(footprint.min.y)},
                       {std::ceil(footprint.max.x), std::ceil(footprint.max.y)}};
      add(boxes, in_both(whole, zone));
    }
    all.insert(all.end(), boxes.begin(), boxes.end());
  }
  return all;
}

}  // namespace citykiln::bake
