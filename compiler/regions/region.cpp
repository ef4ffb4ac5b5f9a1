#include "compiler/regions/region.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace citykiln::regions {
namespace {

bool is_multiple(double of, double size) { return of >= size && std::floor(of / size) * size == of; }

std::int32_t down(double v, double size) { return static_cast<std::int32_t>(std::floor(v / size)); }
std::int32_t last_below(double v, double size) { return static_cast<std::int32_t>(std::ceil(v / size)) - 1; }

}  // namespace

std::string to_string(RegionKey region) { return fmt::format("{}_{}", region.x, region.y); }

Result<Done> check_grid(const RegionGrid& grid) {
  if (is_multiple(grid.region_m, grid.tile_m)) return Done{};
  return Error{"--region", fmt::format("expected a whole multiple of the tile's side, {} m, such as {}", grid.tile_m,
                                       grid.tile_m * 16)};
}

RegionRange range_near(const RegionGrid& grid, const Box2& box) {
  const double m = grid.region_m;
  const std::int32_t low_x = down(grid.extent.min.x, m), low_y = down(grid.extent.min.y, m),
                     high_x = last_below(grid.extent.max.x, m), high_y = last_below(grid.extent.max.y, m);
  RegionRange range{.first_x = low_x,
                    .last_x = low_x - 1,
                    .first_y = low_y,
                    .last_y = low_y - 1,
                    .low_x = low_x,
                    .low_y = low_y,
                    .rows = high_y - low_y + 1};
  const Box2 wide = box.widened(grid.halo_m);
  if (wide.is_empty() || !wide.touches(grid.extent.widened(2 * grid.halo_m + m))) return range;
  const auto within = [](std::int32_t v, std::int32_t low, std::int32_t high) {
    return std::clamp(v, low - 1, high + 1);
  };
  range.first_x = std::max(low_x, within(last_below(wide.min.x, m), low_x, high_x));
  range.last_x = std::min(high_x, within(down(wide.max.x, m), low_x, high_x));
  range.first_y = std::max(low_y, within(last_below(wide.min.y, m), low_y, high_y));
  range.last_y = std::min(high_y, within(down(wide.max.y, m), low_y, high_y));
  return range;
}

std::vector<RegionKey> regions_of(const RegionGrid& grid) {
  RegionGrid bare = grid;
  bare.halo_m = 0;
  const RegionRange r = range_near(bare, grid.extent);
  std::vector<RegionKey> regions;
  for (std::int32_t x = r.low_x; x <= last_below(grid.extent.max.x, grid.region_m); ++x)
    for (std::int32_t y = r.low_y; y < r.low_y + r.rows; ++y) regions.push_back({x, y});
  return regions;
}

Box2 box_of(const RegionGrid& grid, RegionKey region) {
  const Vec2 min{region.x * grid.region_m, region.y * grid.region_m};
  return {{std::max(min.x, grid.extent.min.x), std::max(min.y, grid.extent.min.y)},
          {std::min(min.x + grid.region_m, grid.extent.max.x), std::min(min.y + grid.region_m, grid.extent.max.y)}};
}

RegionKey owner_of(const RegionGrid& grid, Vec2 place) {
  const auto along = [&](double v, double low, double high) {
    return std::clamp(down(std::clamp(v, low, high), grid.region_m), down(low, grid.region_m),
                      last_below(high, grid.region_m));
  };
  return {along(place.x, grid.extent.min.x, grid.extent.max.x), along(place.y, grid.extent.min.y, grid.extent.max.y)};
}

std::vector<scene::TileKey> tiles_of(const RegionGrid& grid, RegionKey region) {
  const Box2 box = box_of(grid, region);
  std::vector<scene::TileKey> tiles;
  for (std::int32_t x = down(box.min.x, grid.tile_m); x <= last_below(box.max.x, grid.tile_m); ++x)
    for (std::int32_t y = down(box.min.y, grid.tile_m); y <= last_below(box.max.y, grid.tile_m); ++y)
      tiles.push_back({x, y});
  if (!grid.clip.empty())
    std::erase_if(tiles, [&](scene::TileKey tile) {
      const Vec2 min{tile.x * grid.tile_m, tile.y * grid.tile_m};
      const Box2 own{{std::max(min.x, box.min.x), std::max(min.y, box.min.y)},
                     {std::min(min.x + grid.tile_m, box.max.x), std::min(min.y + grid.tile_m, box.max.y)}};
      return !scene::touches_clip(grid.clip, own);
    });
  return tiles;
}

}  // namespace citykiln::regions
