// The scene: the recipe of every object, by tile. The manifest (.kiln) holds exactly this.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compiler/buildings/lit_windows.h"
#include "compiler/buildings/recipe.h"
#include "compiler/buildings/rulebook.h"
#include "compiler/ground/recipe.h"
#include "compiler/map/element_text.h"
#include "compiler/map/heightfield.h"
#include "compiler/map/plane.h"
#include "compiler/plants/recipe.h"
#include "compiler/plants/season.h"
#include "compiler/plants/species_texts.h"
#include "compiler/props/recipe.h"
#include "compiler/roads/junctions/junction.h"
#include "compiler/sky/recipe.h"
#include "compiler/structures/recipe.h"
#include "compiler/surroundings/recipe.h"

namespace citykiln::scene {

/// Tile (x, y) covers [x, x + 1) times [y, y + 1) tile sizes of the plane.
struct TileKey {
  std::int32_t x = 0, y = 0;
  auto operator<=>(const TileKey&) const = default;
};

/// "3_-2".
std::string to_string(TileKey tile);

/// Chunks hold the ground so far beyond their tiles: the largest distance over which neighbours influence an object
/// (plants). A whole number of metres.
inline constexpr double kHalo_m = 48;

/// What holds for the whole scene.
struct Header {
  map::LonLat origin;    ///< Of the plane.
  Box2 region;           ///< The compiled part of the plane: whole cells of map::kCell_m.
  double tile_m = 1024;  ///< A whole multiple of map::kCell_m.
  std::uint64_t seed = 0;
  double resampling_error_m = 0;  ///< Largest error of the heightfield against its sources.
  sky::Sky sky;
  std::vector<std::string> sources;            ///< File names of map and heightmaps, without folders.
  std::vector<std::string> attributions;       ///< "© OpenStreetMap contributors", then the heightmaps' credits.
  std::optional<double> snow_line_m{};         ///< Land above it, in the heights' datum, is under snow.
  std::vector<buildings::RuleText> rules{};    ///< Of the buildings' styles, sorted by name.
  std::vector<plants::SpeciesText> species{};  ///< Of the plants' species, sorted by name.
  surroundings::Surroundings around{};         ///< The land and sea beyond the region; may be empty.
  bool operator==(const Header&) const = default;
};

/// The recipes of one tile, which can be baked without any other chunk. Each vector is sorted by id.
///
/// Objects that cross a tile's border:
/// - Surfaces, roads and footprints are in every chunk that they touch, trimmed. Chunks are widened by kHalo_m for
/// this,
///   for roads by a few metres more.
/// - Junctions are in every chunk within 32 m.
/// - Bridges and tunnels are in these chunks too, whole, and in the chunk of their first point (is_anchored), which
///   alone bakes them.
/// - Trees, tree rows, hedges and power-line corridors are, whole, in every chunk that they touch widened by
///   plants::kObstacleInfluence_m.
/// - Everything else is in the chunk of its anchor alone.
struct Chunk {
  TileKey tile;
  map::Heightfield heights;
  /// Areas; footprints of buildings that are anchored in other tiles; junctions that are not in `junctions`.
  std::vector<ground::LandCoverPolygon> surfaces;
  std::vector<roads::Road> roads;
  std::vector<roads::Strip> watercourses;
  /// Sorted by first arm. Those whose arms are all in `roads`, which holds within roads::kJunctionHalo_m.
  std::vector<roads::Junction> junctions;
  std::vector<structures::Span> bridges, tunnels;
  std::vector<buildings::Building> buildings;  ///< Their footprints are not in `surfaces`.
  std::vector<plants::Tree> trees;
  std::vector<plants::Wood> woods;
  std::vector<plants::Planting> plantings;
  std::vector<plants::TreeRow> tree_rows;
  std::vector<plants::PowerLineCorridor> corridors;
  std::vector<props::Barrier> barriers;
  std::vector<props::Lamp> lamps;
  std::vector<map::ElementText> texts{};  ///< Of the elements that the recipes above are of; sorted by id.
  bool operator==(const Chunk&) const = default;
};

/// A compiled map.
struct Scene {
  Header header;
  std::vector<Chunk> chunks;  ///< Sorted by tile.
  bool operator==(const Scene&) const = default;
};

/// The month of the sky's time: plants and fields are shown as they are then.
plants::Month month_of(const Header& header);

/// The time of the week while it is dark, which says what windows are lit; none by day.
std::optional<buildings::WeekTime> night_of(const Header& header);

/// The part of the region that belongs to a tile.
Box2 box_of(const Header& header, TileKey tile);
/// Whether an object anchored at a place belongs to a tile. Places outside the region belong to the nearest tile.
bool is_anchored(const Header& header, TileKey tile, Vec2 anchor);
/// Keys of all tiles that the region touches, sorted.
std::vector<TileKey> tiles_of(const Header& header);
/// The chunk's junctions whose first place lies in its tile: no junction of a scene is in two tiles' lists.
std::vector<roads::Junction> anchored_junctions(const Header& header, const Chunk& chunk);

}  // namespace citykiln::scene
