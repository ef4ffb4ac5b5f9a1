// Decides whether the courts of closed blocks are green or paved, by what is mapped about them.
#pragma once

#include <optional>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/lots/recipe.h"
#include "compiler/map/features.h"

namespace citykiln::lots {

/// The distance from a place within which mapped areas count, by the middles of their boxes, in metres: about a block.
inline constexpr double kCourtRadius_m = 100;
/// Larger areas are no courts: parks, sports grounds, large car parks. Smaller ones are planters.
inline constexpr double kLeastCourt_m2 = 20, kLargestCourt_m2 = 4000;

/// The mapped areas of a map that may lie in courts.
struct CourtGreen {
  struct Area {
    Vec2 middle;
    double area_m2 = 0;
    bool is_green = false;
    ObjectId id{};
  };
  std::vector<Area> all;
  BoxGrid grid;
};

/// Returns the index of a map. O(n).
CourtGreen index_court_green(const map::FeatureView& features);

/// True for classes of green ground in courts, such as grass and gardens; false for paved ones, such as car parks;
/// empty for all others.
std::optional<bool> is_green_court(map::LandCoverClass surface);

/// Returns the share of green of the mapped areas within kCourtRadius_m, by size; each counts as 400 m2 at most. Empty
/// if none is mapped. O(areas near).
/// @param without  An area that does not count.
std::optional<double> green_share(const CourtGreen& green, Vec2 p, ObjectId without = {});

/// The shares of green from which on courts are green, and up to which they are paved.
inline constexpr double kGreenCourtShare = 0.6, kPavedCourtShare = 0.4;

/// Returns kGreenCourt, kPavedCourt, or kPerimeter between the shares and where nothing is mapped.
LotKind court_of(const CourtGreen& green, Vec2 p);

}  // namespace citykiln::lots
