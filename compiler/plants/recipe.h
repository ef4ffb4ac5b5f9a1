// Plants: single trees, and woods as a spacing on a surface.
#pragma once

#include <cstdint>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/vec.h"
#include "compiler/plants/species.h"

namespace citykiln::plants {

/// natural=tree.
struct Tree {
  ObjectId id;
  Vec2 at;              ///< Plane metres, snapped.
  double height_m = 0;  ///< As tagged, or drawn from the seed when 0.
  Species species{};
  bool operator==(const Tree&) const = default;
};

/// A wood: trees at even spacing on the surface of the same id, wherever nothing else covers it.
struct Wood {
  ObjectId surface;         ///< A ground::Surface of the same chunk.
  double spacing_m = 0;     ///< Least distance between trunks, measured on the ground.
  double needle_share = 0;  ///< Share of needle-leaved trees, 0 to 1, in steps of 1/255.
  double height_m = 0;      ///< Mean height.
  bool operator==(const Wood&) const = default;
};

}  // namespace citykiln::plants
