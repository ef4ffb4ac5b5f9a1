// Unmapped land that is farmed, since farmland is mapped about it.
#pragma once

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

/// Finds what keeps unmapped land from being farmed.
class OpenLand {
 public:
  /// Refers to the features, which must outlive it. O(n log n).
  explicit OpenLand(const map::FeatureView& features);

  /// Returns the parts of a field on unmapped land that are on no mapped area that fields would cover; none if
  /// buildings stand on it, more than one on two hectares, or if less than half of it, or less than kLeastOpen_m2,
  /// would be left. O(things near).
  std::vector<Polygon> free_parts(const Polygon& field) const;

 private:
  std::vector<const map::AreaFeature*> areas_;
  std::vector<Vec2> buildings_;
  BoxGrid areas_grid_, buildings_grid_;
};

/// The least area of a field on unmapped land.
inline constexpr double kLeastOpen_m2 = 40000;

}  // namespace citykiln::fields
