// The map beside a stretch of road: houses, land use, paths, other roads and obstacles, on either side.
//
//      houses  [####]  [###]     [####]     counted within kFront_m of the axis
//      path    ------------------------     beside the kerb, within kBesideKerb_m: a pavement mapped as its own way
//     =|=====|=====|=====|=====|=====|=>    samples every 8 m; rays square to the axis look at either side
//      <-------------------------------     a one-way street the other way, within kOncoming_m: the other carriageway
#pragma once

#include <limits>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// The greatest distance from an axis at which houses, land use and paths count.
inline constexpr double kBeside_m = 64;
/// The greatest distance from the axis of houses, the other carriageway and the point whose land use counts.
inline constexpr double kFront_m = 40, kOncoming_m = 30, kLandUse_m = 20;
/// The greatest distance from the kerb of a path that counts as the road's pavement.
inline constexpr double kBesideKerb_m = 10;
/// The greatest distance of a cross street: half a long block.
inline constexpr double kBlock_m = 60;
static_assert(kBeside_m > kBlock_m && kBlock_m > kFront_m && kFront_m > kOncoming_m && kOncoming_m > kLandUse_m);

/// Lines whose direction has this cosine with the axis, or more, run along it: less than about 37 degrees.
inline constexpr double kAlong = 0.8;

/// The distances from the axis to the kerbs.
double left_kerb_m(const map::CrossSection& section);
double right_kerb_m(const map::CrossSection& section);

/// The use of the land beside a road.
enum class LandUse : std::uint8_t {
  kNone,  ///< Nothing is mapped.
  kResidential,
  kShops,  ///< Shops, offices, schools, hospitals, churches.
  kIndustry,
  kRailway,
  kFields,
  kGreen,  ///< Parks, gardens, sports grounds.
  kWood,
  kWater,
  kParking,
  kCount
};

/// The facts of one side of a stretch.
struct SideFacts {
  double houses = 0;         ///< The share of the side along which a building stands.
  double houses_across = 0;  ///< The share of the other side.
  double streets = 0;        ///< The share of the stretch that lies within kBlock_m of a cross street.
  double path = 0;           ///< The share along which a path or a paved square runs beside the kerb.
  double oncoming = 0;       ///< The share along which a one-way street runs in the other direction.
  /// The distance from the kerb to buildings, walls and car parks, of which a quarter of the side may leave less; and
  /// what room_beside() leaves.
  double room_m = std::numeric_limits<double>::infinity();
  LandUse land{};  ///< The most frequent one.
};

/// A straight piece of a mapped line or outline.
struct MappedLine {
  enum class Kind : std::uint8_t { kBuilding, kWall, kPath, kStreet, kRail, kCarPark, kWater, kSquare };
  Vec2 a, b;
  Kind kind{};
  double half_m = 0;        ///< The greatest distance of a way's edges from its axis, mapped pavements included.
  bool is_through = false;  ///< True for streets of residential or higher class.
  Vec2 heading{};           ///< The direction of traffic of a one-way street; else 0.
  ObjectId of{};
  const map::Track* way = nullptr;  ///< The way; null for outlines and barriers.
};

/// An area with a land use.
struct MappedLand {
  const map::AreaFeature* area = nullptr;
  LandUse land{};
  bool is_square = false;
};

/// All lines and areas of a map, by place.
struct Surroundings {
  std::vector<MappedLine> lines;
  std::vector<MappedLand> areas;
  BoxGrid line_grid, area_grid;
  double widest_half_m = 0;  ///< The greatest half width of all lines.
};

/// Returns the index of a map's features on the ground; it points into them. O(n log n).
Surroundings index_surroundings(const map::Features& features);

/// Returns the most frequent land use along a line. O(length * areas near it).
LandUse land_use_along(const Surroundings& surroundings, const Polyline& line);

/// The facts of both sides of a stretch, seen along its axis.
struct BothSides {
  SideFacts left, right;
};

/// Returns the facts of a stretch: of what is mapped within kBeside_m of its axis, or kBesideKerb_m of its kerbs. The
/// order of features does not matter. O(length * lines near it).
BothSides facts_beside(const Surroundings& surroundings, const map::Track& stretch);

}  // namespace citykiln::assume
