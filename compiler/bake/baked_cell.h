// One cell of a tile, baked for a viewpoint.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/bake/ground/ground_meshes.h"
#include "compiler/bake/prototype_cache.h"
#include "compiler/props/street_lamps.h"

namespace citykiln::bake {

/// Plants of one prototype. The cache owns the prototype.
struct PlacedPrototype {
  const BakedPrototype* prototype;
  InstancedMesh instances;  ///< Without primitives.
};

/// The meshes and plants of a cell at one level.
struct BakedCellPart {
  /// All but plants, marking atlas, material textures and attributes. Its origin is the tile's.
  BakedTile tile;
  std::vector<PlacedPrototype> plants{};
};

/// A cell as parts by level, finest first, without empty parts.
struct BakedCell {
  std::vector<BakedCellPart> parts;
  std::shared_ptr<const Markings> markings;  ///< The markings of the whole tile.
  double texture_m = 0;                      ///< The tolerance of material textures.
};

/// Data for baking a cell: the sizes of prototypes, which are equal in the whole tile, and the cell's plants (output).
struct CellBaking {
  const std::map<plants::Prototype, double>& tallest_plants_m;  ///< Height of the tallest plant, by merged variant.
  const std::map<props::LampKind, double>& tallest_lamps_m;
  std::vector<PlacedPrototype>& plants;
};

}  // namespace citykiln::bake
