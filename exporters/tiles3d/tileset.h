// Writes tile trees as tilesets of 3D Tiles 1.1 (OGC 22-025r4), with explicit tiling.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "compiler/map/plane.h"
#include "exporters/tiles3d/oriented_box.h"

namespace citykiln::exporters {

/// A tile: its content stands for those of its children, which replace it.
struct TilesetTile {
  OrientedBox box;           ///< Contains the content and the children's boxes.
  double error_m = 0;        ///< Certified: of the content against the full shape. > the children's.
  std::string content{};     ///< A file, relative to 3dtiles/; empty for a tile without content.
  double tolerance_m = 0;    ///< That the content was made for; 0 without content.
  double plant_error_m = 0;  ///< Stated, not certified.
  std::vector<TilesetTile> children{};
};

/// Whether a tile's content is another tileset.
bool is_external(const TilesetTile& tile);

/// What holds for a whole tileset.
struct TilesetFacts {
  std::array<double, 16> to_earth{};  ///< The root's transform, column by column (map::Globe::to_earth()).
  map::LonLat origin;
  std::string geoid{};        ///< Where heights of the geoid are from; empty: none was given.
  double geoid_height_m = 0;  ///< At the origin.
  std::vector<std::string> attributions;
};

/// A JSON file of a tileset.
struct TilesetFile {
  std::string name;  ///< Relative to the run's folder: "3dtiles/tileset.json".
  std::string json;
};

/// The most tiles of one file.
inline constexpr std::size_t kMostTilesInFile = 256;

/// Returns tileset.json and, where the tree has more than kMostTilesInFile tiles, external tilesets for subtrees, named
/// by their numbers. A tile that refers to an external tileset has the error and the box of its root, whose content
/// it shows.
///
/// | data                  | 3D Tiles                                                                     |
/// |-----------------------|------------------------------------------------------------------------------|
/// | error_m               | geometricError; of the tileset, the diagonal of its box                      |
/// | box                   | boundingVolume.box, in the frame of the run                                  |
/// | to_earth              | transform of the root                                                        |
/// | tolerance_m, errors   | extras of the tile                                                           |
/// | attributions          | asset.extras: copyright, and cesium.credits, which CesiumJS shows            |
/// | origin, geoid         | metadata, with a schema                                                      |
///
/// Asserts that errors fall strictly from parent to child. Same input, same bytes.
std::vector<TilesetFile> encode_tileset(TilesetTile root, const TilesetFacts& facts);

}  // namespace citykiln::exporters
