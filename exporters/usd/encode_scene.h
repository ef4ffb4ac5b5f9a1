// Writes the USD layers without meshes: the scene, and for each tile the layer that lists its levels.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "compiler/bake/place_lamps.h"
#include "exporters/usd/usd_builder.h"

namespace citykiln::exporters {

/// A level of a tile (the tile at one tolerance), as the layers state it.
struct UsdTileLevel {
  double tolerance_m = 0, error_m = 0, plant_error_m = 0;
  UsdBounds bounds;  ///< Metres from the tile's origin.
};

/// A tile, as the layers state it.
struct UsdTile {
  scene::TileKey tile;
  Vec3 origin;                             ///< Plane metres.
  std::vector<UsdTileLevel> levels;        ///< Finest first; not empty.
  std::vector<bake::PlacedLamp> lights{};  ///< Lamps to write as lights, at any time of day.
};

/// The layer kUsdSurroundingsName, which holds the land around the scene (bake/far/bake_surroundings.h).
struct UsdSurroundings {
  Vec3 origin;       ///< Plane metres.
  UsdBounds bounds;  ///< Metres from `origin`.
};

/// Returns the layer of a tile. Its prim "tile" is moved to the tile's origin and has a variant set "level" with a
/// variant for each level. "L0" is the finest and the default. A variant has the level's layer as its payload, its
/// bounds, and its tolerance and errors as customData. Lights are outside the variants, so all levels have them.
std::vector<std::byte> encode_tile_layer(const UsdTile& tile, const scene::Header& header);

/// Returns the layer of the scene. It has a prim for each tile, with the tile's layer as its payload, its place, and
/// the bounds of its finest level, so that a program can show the boxes of a city before it loads a tile. The sun is a
/// DistantLight and the sky a DomeLight of one colour.
///
/// Light: a white surface that faces the sun at the zenith reflects a radiance of 1. customData of the sun has its
/// illuminance in lux under a clear sky: 127,500 exp(-0.21 m) for the relative air mass m. Source: IES Lighting
/// Handbook, 9th edition, 8-6; Kasten and Young, "Revised optical air mass tables", Applied Optics 28, 1989.
/// @param tiles    Sorted.
/// @param around  The land around the scene, a payload outside of the scene's bounds; null: none.
std::vector<std::byte> encode_scene(std::span<const UsdTile> tiles, const scene::Header& header,
                                    const UsdSurroundings* around = nullptr);

}  // namespace citykiln::exporters
