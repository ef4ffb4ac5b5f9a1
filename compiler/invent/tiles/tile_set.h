// Tile sets: the squares of which a tile city is made, as text.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/geometry/polygon.h"
#include "compiler/invent/invented_map.h"

namespace citykiln::invent {

enum class ContentKind : std::uint8_t { kLine, kArea, kPoint, kCover };

/// A tag of a tile, with one or several values; each square draws one.
struct TagChoice {
  std::string key;
  std::vector<std::string> values;
};

/// One object of a tile. Points are from the square's south-west corner, 0 to 1, x east, y north; a cover fills the
/// square.
struct TileContent {
  ContentKind kind{};
  std::vector<TagChoice> tags;
  Polyline points;
};

/// The sides of a square, counter-clockwise.
enum Side : std::uint8_t { kNorth, kWest, kSouth, kEast };
inline constexpr int kSides = 4;

struct Tile {
  std::string name;
  double weight = 1;
  int turns = 1;                             ///< How many turned copies differ: 1, 2 (equal after half a turn) or 4.
  double low_noise = -1, high_noise = 1;     ///< 8 times as frequent where the noise is in this range.
  std::array<std::uint8_t, kSides> sides{};  ///< Indices into TileSet::labels.
  std::vector<TileContent> content;
};

/// A tile, turned counter-clockwise.
struct TurnedTile {
  std::uint16_t tile = 0;
  std::uint8_t turn = 0;
  std::array<std::uint8_t, kSides> sides{};
};

/// Squares that may lie side by side where the labels of their common side are equal (Wang tiles).
struct TileSet {
  double cell_m = 40;
  std::vector<std::string> labels;
  std::vector<std::uint8_t> roads;  ///< Labels of sides that roads cross; the first one connects parts.
  std::vector<Tile> tiles;
  std::vector<TurnedTile> turned;  ///< At most kMostTurned; all turns of all tiles.
};

inline constexpr std::size_t kMostTurned = 128;
inline constexpr std::size_t kMostLabels = 16;

/// Reads a tile set. Its notation is described in compiler/invent/tiles/tile_sets.md. Errors name the line.
/// @param where  The name of the file, for errors.
Result<TileSet> read_tile_set(std::string_view text, const std::string& where);

/// Returns the text of the tile set that is used if none is given.
std::string_view shipped_tile_set();

}  // namespace citykiln::invent
