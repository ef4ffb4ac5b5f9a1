// One ground cell of a tile, baked for a viewpoint.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/bake/ground_meshes.h"
#include "compiler/bake/prototype_cache.h"
#include "compiler/props/street_lamps.h"

namespace citykiln::bake {

/// Plants of one prototype, which is kept by the cache and by no cell.
struct PlacedPrototype {
  const BakedPrototype* prototype;
  InstancedMesh instances;  ///< Without primitives.
};

/// What a cell shows at one level.
struct BakedCellPart {
  /// Without plants, marking atlas, material textures and attributes. Its origin is the tile's.
  BakedTile tile;
  std::vector<PlacedPrototype> plants{};
};

/// A cell as parts by level, finest first; parts that hold nothing are left out.
struct BakedCell {
  std::vector<BakedCellPart> parts;
  std::shared_ptr<const Markings> markings;  ///< Of the tile.
  double texture_m = 0;                      ///< The tolerance of material textures.
};

/// What a cell takes from its tile while it is baked: sizes that prototypes have for the whole tile, and the place for
/// its plants.
struct CellBaking {
  const std::map<plants::Prototype, double>& tallest_plants_m;  ///< By merged variant.
  const std::map<props::LampKind, double>& tallest_lamps_m;
  std::vector<PlacedPrototype>& plants;
};

}  // namespace citykiln::bake
