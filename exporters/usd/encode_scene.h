// USD: the layers that hold no meshes: the scene, and the levels of each tile.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "compiler/bake/place_lamps.h"
#include "exporters/usd/usd_builder.h"

namespace citykiln::exporters {

/// A level of a tile that is written.
struct UsdTileLevel {
  double tolerance_m = 0, error_m = 0, plant_error_m = 0;
  UsdBounds bounds;  ///< In the tile's frame.
};

/// A tile that is written.
struct UsdTile {
  scene::TileKey tile;
  Vec3 origin;                             ///< Plane metres.
  std::vector<UsdTileLevel> levels;        ///< Finest first; not empty.
  std::vector<bake::PlacedLamp> lights{};  ///< Written as lights of the tile (usd_lights.h), whatever the time is.
};

/// The luminance that a radiance of 1 stands for, cd/m²: that of a white surface that faces the sun at the zenith.
double usd_unit_luminance_cd_m2();

/// The layer of the land around the scene (bake/bake_surroundings.h), kUsdSurroundingsName.
struct UsdSurroundings {
  Vec3 origin;       ///< Plane metres.
  UsdBounds bounds;  ///< In the layer's frame.
};

/// Returns the layer of a tile: the prim "tile", moved to the tile's origin, with a variant of the set "level" for each
/// level, "L0" the finest and the default. Each has the level's layer as its payload, its bounds, and its tolerance and
/// error as customData. Lights are beside the variants, so that all levels have them.
std::vector<std::byte> encode_tile_layer(const UsdTile& tile, const scene::Header& header);

/// Returns the layer of the scene: a prim for each tile with the tile's layer as its payload and the bounds of its
/// finest level and its place, so that a program can show the boxes of a city before it loads a tile; the sun as a
/// DistantLight and the sky as a DomeLight of one colour.
///
/// Light: a white surface that faces the sun at the zenith reflects a radiance of 1. customData of the sun has its
/// illuminance in lux, of a clear sky: 127,500 exp(-0.21 m) for the relative air mass m. Source: IES Lighting Handbook,
/// 9th edition, 8-6; Kasten and Young, "Revised optical air mass tables", Applied Optics 28, 1989.
/// @param tiles  Sorted. @param around  Null where it is not written; a payload beside the tiles, outside of the
/// scene's bounds.
std::vector<std::byte> encode_scene(std::span<const UsdTile> tiles, const scene::Header& header,
                                    const UsdSurroundings* around = nullptr);

}  // namespace citykiln::exporters
