// The distances that trees of woods and plantings keep from mapped trees and trees of rows.
#pragma once

#include <span>

#include "compiler/geometry/box_grid.h"
#include "compiler/plants/recipe.h"

namespace citykiln::plants {

/// The place of a mapped tree or of a tree of a row, and the distance that woods keep from it.
struct TreeClearance {
  Vec2 at;
  double radius_m = 0;  ///< The clearance to trunks of woods: half of the crown's width, and room for another crown.
};
/// Returns TreeClearance::radius_m for a plant, at most kMostClearance_m.
double crown_clearance_m(const SpeciesValues& species, double height_m);
inline constexpr double kMostClearance_m = 7;

/// The clearances of trees, with a spatial index.
struct TreeClearanceIndex {
  std::span<const TreeClearance> all;
  BoxGrid grid;
};
/// Builds the index.
TreeClearanceIndex index_tree_clearances(std::span<const TreeClearance> all);
/// True if a position is nearer to a tree than its radius.
bool is_near_tree(const TreeClearanceIndex& trees, Vec2 p);

}  // namespace citykiln::plants
