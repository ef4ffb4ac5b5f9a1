// Unmapped land that is farmed, since farmland is mapped about it.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/map/features.h"

namespace citykiln::fields {

/// Farmland or meadows that are mapped within this distance show that unmapped land is farmed, in metres.
inline constexpr double kFarmedAbout_m = 2048;

/// Returns land of no mapped use in the country, as areas of LandCoverClass::kUnknown: one for each square of
/// kOpenSquare_m of the plane in which, or within kFarmedAbout_m of which, farmland is mapped. Other mapped things
/// in a square are not taken out of it. Ids are those of the square: OsmType::kLot with the square's number and the
/// part 0.
std::vector<map::AreaFeature> open_squares(const map::FeatureView& features);

/// The side of the squares, in metres: the land of a square is no larger than a whole face (divide_land.h).
inline constexpr double kOpenSquare_m = 1024;

/// The side of the cells of an OpenSquare, in metres.
inline constexpr double kOpenCell_m = kOpenSquare_m / 64;

/// What of a square may be farmed.
struct OpenSquare {
  Vec2 low;                               ///< Its lower left corner.
  std::array<std::uint64_t, 64> cells{};  ///< For each row of cells from the low one, bits of those that are open.
  std::vector<Polygon> below;             ///< Mapped land in the square that fields would cover. Thinned, may overlap.
};

/// Returns true if the cell at a place of the square is open.
bool is_open(const OpenSquare& square, Vec2 at);

/// Returns the area of the open cells, m².
double open_m2(const OpenSquare& square);

/// Finds what keeps unmapped land from being farmed.
class OpenLand {
 public:
  /// Refers to the features, which must outlive it. O(n log n).
  explicit OpenLand(const map::FeatureView& features);

  /// Returns a square of kOpenSquare_m. A cell is open if its centre is in no mapped area, and if the centre of the
  /// block of kSteepCells by kSteepCells about it is not steep. O(points of the areas near).
  OpenSquare square_at(Vec2 low, const std::function<bool(Vec2)>& is_steep) const;

  /// Returns the parts of a field in the square that are on no mapped area that fields would cover; none if more than
  /// one building on two hectares stands on it, or if less than half of its cells are open. Parts of less than
  /// kLeastOpen_m2 are left out. O(things near).
  std::vector<Polygon> free_parts(const OpenSquare& square, const Polygon& field) const;

 private:
  bool has_buildings(const Polygon& field) const;

  std::vector<const map::AreaFeature*> areas_;
  std::vector<Vec2> buildings_;
  BoxGrid areas_grid_, buildings_grid_;
};

/// Whether land is steep is asked once for this many cells in each direction.
inline constexpr int kSteepCells = 4;

/// The least area of a field on unmapped land.
inline constexpr double kLeastOpen_m2 = 40000;

}  // namespace citykiln::fields
