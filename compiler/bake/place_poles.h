// Places the utility poles of a tile's streets, and hangs the wires between them. They have no recipes:
// furniture/utility_poles.h draws them from those of roads.
#pragma once

#include <vector>

#include "compiler/bake/place_furniture.h"
#include "compiler/bake/prototype_cache.h"
#include "compiler/wires/recipe.h"

namespace citykiln::bake {

/// Two poles between which wires hang.
struct PlacedPoleSpan {
  ObjectId id;
  things::Form form;  ///< The form of both poles.
  Placement from, to;
};

struct PlacedPoles {
  std::vector<PlacedThing> standing;  ///< The poles whose foot lies in the tile.
  std::vector<PlacedPoleSpan> spans;  ///< The spans whose middle lies in the tile.
};

/// Returns the poles of a tile; none without scene::Header::has_street_furniture or without the rules of poles.
/// @param land_cover  Has each road as one surface; of the tile and scene::kHalo_m about it.
/// @param graded      Covers the same box.
/// @param box         The tile.
PlacedPoles place_poles(const scene::Header& header, const scene::Chunk& chunk,
                        const ground::LandCoverIndex& land_cover, const ground::GradedTerrain& graded, const Box2& box);

/// Returns the wires of spans: one on each insulator, and a thicker cable for telephones below them.
/// @param prototypes  The cache of the run: its rules say where wires hang.
std::vector<wires::WireSpan> wires_of(std::span<const PlacedPoleSpan> spans, const PrototypeCache& prototypes);

}  // namespace citykiln::bake
