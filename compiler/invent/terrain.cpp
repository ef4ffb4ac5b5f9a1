#include "compiler/invent/terrain.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/segment.h"

namespace citykiln::invent {

/// The boxes of river segments, lakes and parts of the sea, in buckets.
class WaterIndex {
 public:
  struct Item {
    enum class Kind { kRiver, kLake, kSea } kind;
    std::uint32_t index, segment;
  };
  std::vector<Item> items;
  BoxGrid grid;
};

namespace {

constexpr double kWaterBucket_m = 64;

struct LatticeCell {
  int column, row;
  double u, v;
};

LatticeCell cell_at(const Terrain& terrain, Vec2 p) {
  const double x = std::clamp((p.x + terrain.side_m / 2) / terrain.step_m(), 0.0, static_cast<double>(terrain.cells)),
               y = std::clamp((p.y + terrain.side_m / 2) / terrain.step_m(), 0.0, static_cast<double>(terrain.cells));
  const int column = std::min(static_cast<int>(x), terrain.cells - 1),
            row = std::min(static_cast<int>(y), terrain.cells - 1);
  return {column, row, x - column, y - row};
}

bool is_in_segment(const River& river, std::size_t i, Vec2 p) {
  const double share = nearest_share(river.axis[i], river.axis[i + 1], p);
  const double width_m = river.width_m[i] + (river.width_m[i + 1] - river.width_m[i]) * share;
  return distance(river.axis[i] + (river.axis[i + 1] - river.axis[i]) * share, p) < width_m / 2;
}

bool is_in_river(const River& river, Vec2 p) {
  for (std::size_t i = 0; i + 1 < river.axis.size(); ++i)
    if (is_in_segment(river, i, p)) return true;
  return false;
}

bool is_in_item(const Terrain& terrain, const WaterIndex::Item& item, Vec2 p) {
  using Kind = WaterIndex::Item::Kind;
  if (item.kind == Kind::kRiver) return is_in_segment(terrain.rivers[item.index], item.segment, p);
  return contains(item.kind == Kind::kLake ? terrain.lakes[item.index] : terrain.sea[item.index], p);
}

}  // namespace

double Terrain::height_m(Vec2 p) const {
  const LatticeCell at = cell_at(*this, p);
  const float* low = heights_m.data() + static_cast<std::size_t>(at.row) * (cells + 1) + at.column;
  const float* high = low + cells + 1;
  const double south = low[0] + (static_cast<double>(low[1]) - low[0]) * at.u,
               north = high[0] + (static_cast<double>(high[1]) - high[0]) * at.u;
  return south + (north - south) * at.v;
}

Vec2 Terrain::gradient(Vec2 p) const {
  const double half = step_m() / 2;
  return {(height_m({p.x + half, p.y}) - height_m({p.x - half, p.y})) / step_m(),
          (height_m({p.x, p.y + half}) - height_m({p.x, p.y - half})) / step_m()};
}

bool Terrain::is_water(Vec2 p) const {
  if (water_index) {
    for (const std::uint32_t i : boxes_about(water_index->grid, p))
      if (is_in_item(*this, water_index->items[i], p)) return true;
    return false;
  }
  const auto holds = [&](const Polygon& polygon) { return contains(polygon, p); };
  return std::ranges::any_of(sea, holds) || std::ranges::any_of(lakes, holds) ||
         std::ranges::any_of(rivers, [&](const River& river) { return is_in_river(river, p); });
}

void index_water(Terrain& terrain) {
  using Item = WaterIndex::Item;
  const auto index = std::make_shared<WaterIndex>();
  std::vector<Box2> boxes;
  const auto add = [&](Item item, const Box2& box) { index->items.push_back(item), boxes.push_back(box); };
  for (std::uint32_t r = 0; r < terrain.rivers.size(); ++r) {
    const River& river = terrain.rivers[r];
    for (std::uint32_t i = 0; i + 1 < river.axis.size(); ++i)
      add({Item::Kind::kRiver, r, i},
          box_of(std::span(river.axis).subspan(i, 2)).widened(std::max(river.width_m[i], river.width_m[i + 1]) / 2));
  }
  for (std::uint32_t i = 0; i < terrain.lakes.size(); ++i)
    add({Item::Kind::kLake, i, 0}, box_of(terrain.lakes[i].outer));
  for (std::uint32_t i = 0; i < terrain.sea.size(); ++i) add({Item::Kind::kSea, i, 0}, box_of(terrain.sea[i].outer));
  index->grid = grid_of(boxes, kWaterBucket_m);
  terrain.water_index = index;
}

}  // namespace citykiln::invent
