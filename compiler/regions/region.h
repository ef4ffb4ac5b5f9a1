// Regions: squares of whole tiles that are compiled apart. Nothing ends at their sides.
#pragma once

#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/geometry/box.h"
#include "compiler/scene/scene.h"

namespace citykiln::regions {

/// Region (x, y) covers [x, x + 1) times [y, y + 1) region sizes of the plane.
struct RegionKey {
  std::int32_t x = 0, y = 0;
  auto operator<=>(const RegionKey&) const = default;
};

/// "3_-2".
std::string to_string(RegionKey region);

/// The regions of an extent.
struct RegionGrid {
  Box2 extent;              ///< Whole cells of map::kCell_m.
  double tile_m = 1024;     ///< A whole multiple of map::kCell_m.
  double region_m = 16384;  ///< A whole multiple of tile_m.
  double halo_m = 0;        ///< Data around a region that are compiled with it.
};

/// Errors: a size that is not a whole multiple of the tile's.
Result<Done> is_sound(const RegionGrid& grid);

/// All regions that the extent touches, sorted.
std::vector<RegionKey> regions_of(const RegionGrid& grid);

/// The part of the extent that belongs to a region.
Box2 box_of(const RegionGrid& grid, RegionKey region);

/// The tiles of a region that the extent touches, sorted.
std::vector<scene::TileKey> tiles_of(const RegionGrid& grid, RegionKey region);

/// The region that owns a place of the plane: the one that it lies in, or, of a place outside the extent, the nearest.
RegionKey owner_of(const RegionGrid& grid, Vec2 place);

/// Calls visit(index) for each region whose box, widened by the halo, touches a box; the index is that in
/// regions_of(). O(regions touched).
template <typename Visit>
void for_each_region_near(const RegionGrid& grid, const Box2& box, Visit visit);

/// The indices of the columns and rows of regions that a range touches, clamped to those of the extent.
struct RegionRange {
  std::int32_t first_x, last_x, first_y, last_y;  ///< Both ends belong to it; empty if last < first.
  std::int32_t low_x, low_y, rows;                ///< Of the extent.
};
RegionRange range_near(const RegionGrid& grid, const Box2& box);

template <typename Visit>
void for_each_region_near(const RegionGrid& grid, const Box2& box, Visit visit) {
  const RegionRange r = range_near(grid, box);
  for (std::int32_t x = r.first_x; x <= r.last_x; ++x)
    for (std::int32_t y = r.first_y; y <= r.last_y; ++y)
      visit(static_cast<std::uint32_t>((x - r.low_x) * r.rows + (y - r.low_y)));
}

}  // namespace citykiln::regions
