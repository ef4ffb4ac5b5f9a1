// Open land: land without a mapped use that is taken as farmed, since farmland is mapped near it.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/map/features.h"

namespace citykiln::fields {

/// The distance in metres within which mapped farmland or a mapped meadow shows that unmapped land
/// is farmed.
inline constexpr double kFarmedAbout_m = 2048;

/// Returns the squares of open land that touch the extent, as areas of LandCoverClass::kUnknown.
/// The plane is divided into squares of kOpenSquare_m; a square has open land if its box, widened
/// by kFarmedAbout_m, touches the box of farmland or of a meadow of at least 5000 m². An area is
/// the whole square, with the mapped land in it. Its id is that of OsmType::kLot with the square's
/// number, part 0. O(n log n) and O(squares of the extent).
std::vector<map::AreaFeature> open_squares(const map::FeatureView& features);

/// The side of the squares, in metres. It is less than kWholeFace_m, so that a square is not cut
/// into quarters (divide_land.h).
inline constexpr double kOpenSquare_m = 1024;

/// The side in metres of the cells of a square, 64 x 64.
inline constexpr double kOpenCell_m = kOpenSquare_m / 64;

/// A square of open land, with what may be farmed in it.
struct OpenSquare {
  Vec2 low;  ///< The south-western corner, plane metres.
  /// For each row of cells, from south to north, a bit for each column from west, the lowest first:
  /// 1 if the cell is open.
  std::array<std::uint64_t, 64> cells{};
  /// Outlines of mapped land that fields would cover, as its class has no higher priority. They are
  /// thinned within a few metres, or are boxes of yards, are cut about 1 m beyond the square, and
  /// may overlap.
  std::vector<Polygon> below;
};

/// Returns true if the cell at a place is open; false outside of the square.
bool is_open(const OpenSquare& square, Vec2 at);

/// Returns the area of the open cells, m².
double open_m2(const OpenSquare& square);

/// Finds the mapped areas, buildings and steep land that keep unmapped land from being farmed.
class OpenLand {
 public:
  /// Builds indexes of the features, which must outlive this object. O(n log n).
  explicit OpenLand(const map::FeatureView& features);

  /// Returns the square of kOpenSquare_m with the south-western corner `low`. A cell is open if its
  /// centre is in no mapped area of any class, no building has its middle in it or in a cell beside
  /// it, and its block of kSteepCells by kSteepCells cells is not steep. O(points of the areas near).
  /// @param is_steep  True for a place in plane metres that is too steep for fields. It is called
  ///                  for the centres of blocks, at most 256 times.
  OpenSquare square_at(Vec2 low, const std::function<bool(Vec2)>& is_steep) const;

  /// Returns the parts of a field that are outside of OpenSquare::below, each of at least
  /// kLeastOpen_m2. The result is empty if less than half of the field's cells are open, or if more
  /// than one building on two hectares stands on it. O(things near).
  std::vector<Polygon> free_parts(const OpenSquare& square, const Polygon& field) const;

 private:
  bool has_buildings(const Polygon& field) const;

  std::vector<const map::AreaFeature*> areas_;
  std::vector<Vec2> buildings_;
  BoxGrid areas_grid_, buildings_grid_;
};

/// The side, in cells, of the blocks whose steepness is tested once.
inline constexpr int kSteepCells = 4;

/// The least area in m² of a part of a field on open land.
inline constexpr double kLeastOpen_m2 = 40000;

}  // namespace citykiln::fields
