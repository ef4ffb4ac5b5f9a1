// Writes a tree of tiles as a 3D Tiles 1.1 tileset (OGC 22-025r4), with explicit tiling.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "compiler/map/plane/plane.h"
#include "exporters/tiles3d/oriented_box.h"

namespace citykiln::exporters {

/// A tile of the tileset. When its children are shown, they replace its content.
struct TilesetTile {
  OrientedBox box;  ///< Contains the content and the children's boxes.
  /// A bound of the distance between the content and the full shape; greater than the errors of the children. The
  /// content states its own certified error, which is not larger.
  double error_m = 0;
  std::string content{};   ///< The path of its file relative to 3dtiles/; empty: no content.
  double tolerance_m = 0;  ///< The tolerance for which the content was made; 0 without content.
  std::vector<TilesetTile> children{};
};

/// True if a tile's content is another tileset.
bool is_external(const TilesetTile& tile);

/// Facts about a whole tileset.
struct TilesetFacts {
  std::array<double, 16> to_earth{};  ///< The root's transform, column-major (map::Globe::to_earth()).
  LonLat origin;
  std::string geoid{};        ///< The source of the geoid's heights; empty: none was given.
  double geoid_height_m = 0;  ///< Height of the geoid above the ellipsoid at the origin.
  /// Radius of the cylinder that the world is in, which has no place on Earth; 0: on the ellipsoid.
  double cylinder_radius_m = 0;
  std::vector<std::string> attributions;
};

/// A JSON file of a tileset.
struct TilesetFile {
  std::string name;  ///< The path relative to the run's folder: "3dtiles/tileset.json".
  std::string json;
};

/// The largest number of tiles in one file.
inline constexpr std::size_t kMostTilesInFile = 256;

/// Returns the files of a tileset: tileset.json and, if the tree has more than kMostTilesInFile tiles, external
/// tilesets for subtrees, tileset_1.json and on. A tile that refers to an external tileset has the error and the box of
/// that tileset's root.
///
/// | data                  | 3D Tiles                                                                     |
/// |-----------------------|------------------------------------------------------------------------------|
/// | error_m               | geometricError; of the tileset, the diagonal of the root's box, at least     |
/// |                       | twice the root's error                                                       |
/// | box                   | boundingVolume.box, in the frame of the run                                  |
/// | to_earth              | transform of the root                                                        |
/// | tolerance_m, error_m  | extras of the tile                                                           |
/// | attributions          | asset.extras: copyright, and cesium.credits, which CesiumJS shows            |
/// | origin, geoid         | metadata, with a schema                                                      |
///
/// Asserts that errors fall strictly from parent to child. Deterministic.
std::vector<TilesetFile> encode_tileset(TilesetTile root, const TilesetFacts& facts);

}  // namespace citykiln::exporters
