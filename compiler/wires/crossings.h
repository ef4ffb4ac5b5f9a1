// Roads and bridges that lines cross, with a spatial index.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/roads/recipe.h"
#include "compiler/structures/recipe.h"

namespace citykiln::wires {

/// The segments of roads, railways and bridges.
struct Crossings {
  struct Segment {
    Vec2 a, b;
    std::optional<double> a_m, b_m;  ///< Heights of a bridge at its ends; empty on the ground.
  };
  std::vector<Segment> segments;
  BoxGrid grid;
};
Crossings index_crossings(std::span<const roads::Road> roads, std::span<const structures::Span> bridges);

/// A place where a line crosses a road.
struct Crossing {
  double t = 0;                    ///< The share of the line.
  std::optional<double> deck_m{};  ///< The height of a bridge; empty on the ground.
};

/// Returns the crossings of the line from a to b, in no order that matters. O(segments near it).
std::vector<Crossing> crossings_of(const Crossings& crossings, Vec2 a, Vec2 b);

}  // namespace citykiln::wires
