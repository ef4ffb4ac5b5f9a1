// One cell of a tile (a 128 m square of ground with the objects on it), baked for a viewpoint.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/bake/ground/ground_meshes.h"
#include "compiler/bake/prototype_cache.h"
#include "compiler/props/street_lamps.h"

namespace citykiln::bake {

/// Plants that share one mesh, the prototype. A cache owns it.
struct PlacedPrototype {
  const BakedPrototype* prototype;
  InstancedMesh instances;  ///< Places of the plants; without primitives.
};

/// The meshes and plants of a cell that have one tolerance.
struct BakedCellPart {
  /// Everything except plants, marking atlas, material textures and attributes. Its origin is the tile's.
  BakedTile tile;
  std::vector<PlacedPrototype> plants{};
};

/// A cell as parts by tolerance, finest first, without empty parts.
struct BakedCell {
  std::vector<BakedCellPart> parts;
  std::shared_ptr<const Markings> markings;  ///< The markings of the whole tile.
  double texture_m = 0;                      ///< The tolerance of material textures.
};

/// Data for baking a cell: the largest sizes of plants and lamps in the whole tile, which decide the meshes that cells
/// share, and the cell's plants as output.
struct CellBaking {
  const std::map<plants::Prototype, double>&
      tallest_plants_m;  ///< Height of the tallest plant by prototype, with merged variants.
  const std::map<props::LampKind, double>& tallest_lamps_m;
  std::vector<PlacedPrototype>& plants;  ///< Receives the plants of the cell.
};

}  // namespace citykiln::bake
