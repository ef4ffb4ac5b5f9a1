// Assumes the storeys of buildings that have neither a tagged height nor tagged levels; their heights follow from them.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/map/buildings/building_classes.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// Buildings with tagged height or levels count as neighbours within this distance, from centroid to centroid.
inline constexpr double kHeightNeighbours_m = 200;
/// The surroundings of a building are the buildings, by their centroids, and the shops within this distance of its
/// centroid.
inline constexpr double kHeightSurroundings_m = 100;
/// A building in a row uses the random draw of a building of the row at most this far away (drawing_member()).
inline constexpr double kHeightRow_m = 64;
/// Two buildings touch if at least two of their corners lie at most this far from the other building's wall.
inline constexpr double kHeightTouching_m = 0.3;

/// The land use at the centroid of a building, in the groups of storeys.inc, which are coarser than LandUse (beside.h).
/// The smallest area counts. kNoUse: nothing of the others is mapped; kCountry: fields and woods.
enum class SiteUse : std::uint8_t { kNoUse, kHomes, kTrade, kIndustry, kCountry };

/// The facts that determine the storeys of a building, together with its neighbours' tags.
struct HeightFacts {
  map::BuildingClass building_class{};
  map::CountryGroup country{};
  SiteUse use{};
  double area_m2 = 0;
  std::uint32_t touching_count = 0;  ///< The number of buildings that touch it (kHeightTouching_m).
  // of its surroundings (kHeightSurroundings_m), with the building itself
  double built_share = 0;   ///< The area of all buildings divided by the area of the circle.
  double mean_area_m2 = 0;  ///< The mean area of a building.
  double row_share = 0;     ///< The share of buildings that touch another one.
  std::uint32_t shops = 0;  ///< The number of shops.
};

/// The quartiles of the storeys of similar buildings, whole numbers: a quarter of them has at most `low`, half at most
/// `middle`, three quarters at most `high`.
struct StoreyQuartiles {
  double low = 1, middle = 1, high = 1;
  bool operator==(const StoreyQuartiles&) const = default;
};

/// Returns the quartiles by the table alone (storeys.inc); 1 if no row fits.
StoreyQuartiles storeys_by_table(const HeightFacts& facts);

/// The buildings of a map with the facts that determine their storeys. Entry i of each vector belongs to the same
/// building. Outlines have an entry, parts have none.
struct HeightIndex {
  std::vector<std::uint32_t> footprints;  ///< Indices into Features::footprints, ascending.
  std::vector<Vec2> at;                   ///< Centroids, plane metres.
  std::vector<HeightFacts> facts;
  std::vector<std::vector<std::uint32_t>> touching;  ///< The entries of the buildings that touch it, ascending.
  /// By height=* and the class's height of a storey, else by building:levels. 0: neither is tagged, or the building is
  /// off the ground or of a class without assumed storeys.
  std::vector<double> tagged_storeys;
  BoxGrid grid;  ///< Finds entries by `at`.
};

/// Returns the index of a map's buildings. O(n · buildings within kHeightSurroundings_m), n: buildings.
HeightIndex index_heights(const map::FeatureView& features);

/// Returns the quartiles for a building by the table and by its neighbours within kHeightNeighbours_m whose storeys
/// are tagged, without its own tags. A neighbour has more weight the nearer it is and the more alike its area is, if it
/// has the same class, and if it touches the building.
/// @param entry         An entry of the index.
/// @param may_use_tags  True for the neighbours whose tags may be used; empty: all.
StoreyQuartiles storeys_of(std::uint32_t entry, const HeightIndex& index,
                           const std::function<bool(std::uint32_t entry)>& may_use_tags = {});

/// Returns true if storeys are assumed for buildings of this class without tagged height or levels. Others, such as
/// garages, roofs and towers, keep the height of their class.
bool has_assumed_storeys(map::BuildingClass building_class);

/// Returns the id of the building whose random draws this building uses. The candidates are the building itself and
/// those that a chain of touching buildings connects with it, all within kHeightRow_m from centroid to centroid. The
/// one with the least random number is chosen. Two neighbours have nearly the same candidates and mostly choose the
/// same.
ObjectId drawing_member(std::uint32_t entry, const map::FeatureView& features, const HeightIndex& index,
                        std::uint64_t seed);

/// Returns the features with assumed storeys, as building:levels would give them, for all buildings without tagged
/// height or levels. Parts and uncovered pieces without a height of their own get those of their outline. A building
/// keeps the height of its class if has_assumed_storeys() is false, or if it or one of its parts begins above the
/// ground.
///
/// A random draw chooses one value of storeys_of(): `low` with a probability of 1/4, `middle` of 1/2, `high` of 1/4.
/// The draw is that of drawing_member(). The radius is kHeightNeighbours_m, from centroid to centroid, and the
/// buildings that touch those within it.
std::vector<map::Footprint> assume_heights(const map::FeatureView& features, std::uint64_t seed, Report& report);

}  // namespace citykiln::assume
