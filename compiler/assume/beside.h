// Finds what is mapped on each side of a stretch of road: houses, land use, paths, other roads and obstacles. A stretch
// is one track, or one piece of a track that was cut (cut_way.h).
//
//      houses  [####]  [###]     [####]     counted within kHouses_m of the axis
//      path    ------------------------     within kBesideKerb_m of the kerb it is the pavement, mapped as a way
//     =|=====|=====|=====|=====|=====|=>    at samples, about every 8 m, a ray goes to each side, square to the axis
//      <-------------------------------     a one-way street of the other direction within kOncoming_m is the other
//                                           carriageway
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// The largest distance from the axis of a stretch at which mapped things count, unless a kerb is more than kBeside_m -
/// kBesideKerb_m from the axis (facts_beside()). Each kind has a smaller limit.
inline constexpr double kBeside_m = 64;
/// Houses count up to the first distance from the axis, and the other carriageway up to the second. The land use of a
/// side is read at the third.
inline constexpr double kHouses_m = 40, kOncoming_m = 30, kLandUse_m = 20;
/// A path counts as the road's pavement if its nearer edge is at most this far from the kerb.
inline constexpr double kBesideKerb_m = 10;
/// A sample is near a cross street that is less than this away in a straight line: half the length of a long block.
inline constexpr double kCrossStreet_m = 60;
static_assert(kBeside_m > kCrossStreet_m && kCrossStreet_m > kHouses_m && kHouses_m > kOncoming_m &&
              kOncoming_m > kLandUse_m);

/// A line runs along the axis, in either direction, if the cosine of the angle between them is greater than this: the
/// angle is less than about 37 degrees.
inline constexpr double kAlong = 0.8;

/// The use of the land beside a road.
enum class LandUse : std::uint8_t {
  kNone,  ///< Nothing is mapped.
  kResidential,
  kShops,  ///< Shops, offices, schools, hospitals, churches.
  kIndustry,
  kRailway,
  kFarmland,
  kGreen,  ///< Parks, gardens, sports grounds.
  kWood,
  kWater,
  kParking,
  kCount
};

/// The facts of one side of a stretch. Shares are shares of the samples, from 0 to 1.
struct SideFacts {
  double houses = 0;             ///< The share with a building within kHouses_m on this side.
  double houses_across = 0;      ///< The value of `houses` of the other side.
  double near_cross_street = 0;  ///< The share near a cross street, on either side (kCrossStreet_m).
  double path = 0;               ///< The share with a path or a paved square beside the kerb.
  double oncoming = 0;           ///< The share with a one-way street of the other direction on this side.
  /// The free width beyond the kerb, metres: the smaller of room_beside() (room.h) and the lower quartile, over the
  /// samples, of the distance from the kerb to buildings, walls and car parks. Infinity if nothing is near.
  double room_m = std::numeric_limits<double>::infinity();
  LandUse land{};  ///< The most frequent land use of this side; on a tie the first enumerator.
};

/// A straight piece of a mapped line or outline, from a to b, plane metres.
struct MappedLine {
  enum class Kind : std::uint8_t { kBuilding, kWall, kPath, kStreet, kRail, kCarPark, kWater, kSquare };
  Vec2 a, b;
  Kind kind{};
  /// From a way's axis to the farther one of its edges, pavements included; half a barrier's width; 0 for outlines.
  double half_m = 0;
  bool is_town_house = false;  ///< Outlines of buildings: true if it is no cottage (is_town_house()).
  bool is_through = false;  ///< True for residential, tertiary, secondary and primary roads: these are cross streets.
  Vec2 heading{};           ///< The unit vector along the traffic of a one-way street; else zero.
  ObjectId element{};
  const map::Track* way = nullptr;  ///< The way, one of the indexed features; null for outlines and barriers.
};

/// An area with a land use.
struct MappedLand {
  const map::AreaFeature* area = nullptr;
  LandUse land{};
  bool is_square = false;  ///< True for a paved square, which has no land use.
};

/// All lines and areas of a map, with grids that find them by position.
struct Surroundings {
  std::vector<MappedLine> lines;
  std::vector<MappedLand> areas;
  BoxGrid line_grid, area_grid;  ///< Find the indexes of `lines` and `areas` by position.
  double widest_half_m = 0;      ///< The greatest MappedLine::half_m.
};

/// True for buildings of three storeys or more, or four for those tagged as houses, and for those with a public use or
/// shops. They have no gardens between a street and a wall near it.
bool is_town_house(const map::Footprint& footprint);

/// Returns the index of the features on the ground, without bridges, tunnels and what is indoors. It points into
/// `features`, which have to outlive it unchanged. O(n log n), n: points of all features.
Surroundings index_surroundings(const map::FeatureView& features);
/// Returns the index of these tracks, which have to outlive it too, and of the other features.
Surroundings index_surroundings(const map::FeatureView& features, std::span<const map::Track> tracks);

/// Returns the land use that is most frequent on a line itself, not beside it. O(length · areas near it).
LandUse land_use_along(const Surroundings& surroundings, const Polyline& line);

/// The facts of both sides of a stretch, left and right as seen along its axis.
struct BothSides {
  SideFacts left, right;
};

/// Returns the facts of a stretch. The stretch's own way (the element with its OSM id) does not count, be it another
/// piece of it or the way on the other side of a bend. The facts depend on what is mapped within kBeside_m of the axis,
/// and on paths within kBesideKerb_m and other things within kWidestStrip_m (room.h) of the kerbs where these are
/// farther away. O(length · lines near it).
BothSides facts_beside(const Surroundings& surroundings, const map::Track& stretch);

}  // namespace citykiln::assume
