// Assumes the storeys of buildings without tagged height or levels.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/map/buildings/building_classes.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// The radius within which buildings with tagged heights count, from centroid to centroid.
inline constexpr double kHeightNeighbours_m = 200;
/// The radius within which buildings and shops count as a building's surroundings.
inline constexpr double kHeightSurroundings_m = 100;
/// Buildings of one row that lie within this distance have equal random draws, mostly.
inline constexpr double kHeightRow_m = 64;
/// The largest distance of a corner to another building's wall at which the two touch.
inline constexpr double kHeightTouching_m = 0.3;

/// Land use under a building: groups of land cover classes.
enum class SiteUse : std::uint8_t { kNoUse, kHomes, kTrade, kIndustry, kCountry };

/// The facts that the storeys of a building follow from, apart from its neighbours' tags.
struct HeightFacts {
  map::BuildingClass building_class{};
  map::CountryGroup country{};
  SiteUse use{};
  double area_m2 = 0;
  std::uint32_t touching = 0;  ///< Buildings that share a wall with it.
  /// Within kHeightSurroundings_m: area of buildings by area of the circle, mean area of a building, share of buildings
  /// that touch others, count of shops.
  double built_share = 0, mean_area_m2 = 0, row_share = 0;
  std::uint32_t shops = 0;
};

/// Storeys of buildings that are alike: a quarter have at most `low`, half at most `middle`, three quarters at most
/// `high`.
struct Storeys {
  double low = 1, middle = 1, high = 1;
  bool operator==(const Storeys&) const = default;
};

/// Returns the storeys by the table alone (storeys.inc).
Storeys storeys_by_table(const HeightFacts& facts);

/// The buildings of a map with what their heights follow from, and an index of their places. All vectors have one entry
/// a building: an outline, no part.
struct HeightIndex {
  std::vector<std::uint32_t> footprints;  ///< Indices into Features::footprints, ascending.
  std::vector<Vec2> at;                   ///< Centroids.
  std::vector<HeightFacts> facts;
  std::vector<std::vector<std::uint32_t>> touching;  ///< Entries of the buildings that share a wall with it.
  std::vector<double> tagged_storeys;                ///< By levels, else by height; 0: neither is tagged.
  BoxGrid grid;                                      ///< The index of `at`.
};

/// Returns the index of a map's buildings. O(n times buildings within kHeightSurroundings_m).
HeightIndex index_heights(const map::Features& features);

/// Returns the storeys of a building by the table and by its neighbours within kHeightNeighbours_m whose storeys are
/// tagged. They weigh by distance, class and area.
/// @param entry     An entry of the index.
/// @param is_known  Whether an entry's tags may be used; empty: all may. To leave tags out and guess them again.
Storeys storeys_of(std::uint32_t entry, const HeightIndex& index,
                   const std::function<bool(std::uint32_t entry)>& is_known = {});

/// True for buildings whose storeys are assumed where no tag states a height. Others, such as garages, roofs and
/// towers, keep the height of their class.
bool has_assumed_storeys(map::BuildingClass building_class);

/// Returns the building whose random numbers a building in a row uses: the member with the least random number among
/// those that are linked to it by shared walls and lie within kHeightRow_m. Neighbours mostly choose the same one.
ObjectId drawing_member(std::uint32_t entry, const map::Features& features, const HeightIndex& index,
                        std::uint64_t seed);

/// Sets the storeys of all buildings without tagged height or levels, as building:levels would, and those of the parts
/// and pieces that follow their outline. A building keeps the height of its class if it or one of its parts begins
/// above the ground.
///
/// The storeys are drawn from storeys_of(): a quarter of the buildings has the lower quartile, half the median, a
/// quarter the upper quartile. The draw of a building in a row is that of one member within kHeightRow_m, so buildings
/// of a row mostly have equal draws.
map::Features assume_heights(map::Features features, std::uint64_t seed, Report& report);

}  // namespace citykiln::assume
