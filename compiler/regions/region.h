// Regions: squares of whole tiles that are compiled by separate tasks. Objects that cross the border of a region are
// not cut: each region is compiled with all data within a distance of its border (RegionGrid::halo_m).
#pragma once

#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/geometry/box.h"
#include "compiler/scene/scene.h"

namespace citykiln::regions {

/// The key of a region. In the plane, region (x, y) covers [x, x + 1) times [y, y + 1) times the region size.
struct RegionKey {
  std::int32_t x = 0, y = 0;
  auto operator<=>(const RegionKey&) const = default;
};

/// Returns the key as a text, such as "3_-2".
std::string to_string(RegionKey region);

/// The division of an extent (the box that is compiled) into regions and tiles.
struct RegionGrid {
  Box2 extent;                          ///< All sides lie on multiples of map::kCell_m.
  double tile_m = map::kDefaultTile_m;  ///< The side of a tile: a whole multiple of map::kCell_m.
  double region_m = 16384;              ///< The side of a region: a whole multiple of tile_m.
  double halo_m = 0;                    ///< The width of the data around a region that are compiled with it.
  scene::Clip clip{};                   ///< Tiles without ground inside are of no region; empty: all are.
};

/// Returns an error if region_m is not a whole multiple of tile_m. Other members are not checked.
Result<Done> check_grid(const RegionGrid& grid);

/// Returns all regions that the extent touches, sorted.
std::vector<RegionKey> regions_of(const RegionGrid& grid);

/// Returns the part of the extent that belongs to a region.
Box2 box_of(const RegionGrid& grid, RegionKey region);

/// Returns the tiles of a region that the extent touches and that have ground inside of the clip, sorted.
std::vector<scene::TileKey> tiles_of(const RegionGrid& grid, RegionKey region);

/// Returns the region that owns a place of the plane: the region around it, or the nearest region if the place is
/// outside the extent.
RegionKey owner_of(const RegionGrid& grid, Vec2 place);

/// Calls visit(index) for each region whose square, not clipped to the extent and widened by the halo, touches `box`.
/// The index is the position in regions_of(). O(regions touched).
template <typename Visit>
void for_each_region_near(const RegionGrid& grid, const Box2& box, Visit visit);

/// A range of columns and rows of regions, clamped to those of the extent.
struct RegionRange {
  std::int32_t first_x, last_x, first_y, last_y;  ///< Both ends are included; empty if last < first.
  std::int32_t low_x, low_y, rows;                ///< The extent's first column, first row and number of rows.
};
/// Returns the regions whose square, not clipped to the extent and widened by the halo, touches `box`.
RegionRange range_near(const RegionGrid& grid, const Box2& box);

template <typename Visit>
void for_each_region_near(const RegionGrid& grid, const Box2& box, Visit visit) {
  const RegionRange r = range_near(grid, box);
  for (std::int32_t x = r.first_x; x <= r.last_x; ++x)
    for (std::int32_t y = r.first_y; y <= r.last_y; ++y)
      visit(static_cast<std::uint32_t>((x - r.low_x) * r.rows + (y - r.low_y)));
}

}  // namespace citykiln::regions
