// The clay: every object's recipe, by tile. The manifest (.kiln) is this, written down, and nothing else.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compiler/buildings/recipe.h"
#include "compiler/buildings/rulebook.h"
#include "compiler/ground/recipe.h"
#include "compiler/map/heightfield.h"
#include "compiler/map/plane.h"
#include "compiler/plants/recipe.h"
#include "compiler/plants/season.h"
#include "compiler/plants/species_texts.h"
#include "compiler/props/recipe.h"
#include "compiler/roads/junctions/junction.h"
#include "compiler/sky/recipe.h"
#include "compiler/structures/recipe.h"

namespace citykiln::scene {

/// Tile (x, y) covers [x, x + 1) times [y, y + 1) tile sizes of the plane.
struct TileKey {
  std::int32_t x = 0, y = 0;
  auto operator<=>(const TileKey&) const = default;
};

/// "3_-2".
std::string to_string(TileKey tile);

/// How far beyond a tile its chunk knows the ground: the largest reach of any expansion (plants), a whole number of
/// metres.
inline constexpr double kHalo_m = 48;

struct Header {
  map::LonLat origin;    ///< Of the plane.
  Box2 region;           ///< What was compiled, whole cells of map::kCell_m.
  double tile_m = 1024;  ///< A whole multiple of map::kCell_m.
  std::uint64_t seed = 0;
  double resampling_error_m = 0;  ///< Of the heightfield against its sources.
  sky::Sky sky;
  std::vector<std::string> sources;            ///< File names of map and heightmaps, without folders.
  std::vector<std::string> attributions;       ///< "© OpenStreetMap contributors", then the heightmaps' credits.
  std::optional<double> snow_line_m{};         ///< Land above it, in the heights' datum, is under snow.
  std::vector<buildings::RuleText> rules{};    ///< Those that the buildings' styles need, sorted by name.
  std::vector<plants::SpeciesText> species{};  ///< Those that plants grow from, sorted by name.
  bool operator==(const Header&) const = default;
};

/// One tile, readable and expandable without any other. Each vector is sorted by id. What crosses a border: surfaces,
/// roads and footprints are in every chunk they touch (widened by kHalo_m, roads by some metres more), trimmed;
/// junctions in every chunk within 32 m; bridges and tunnels likewise, whole, and in the chunk of their first point, of
/// which they are part (is_anchored); trees, tree rows, hedges and lanes, whole, in every chunk they touch widened by
/// plants::kObstacleInfluence_m; everything else is in the chunk of its anchor alone.
struct Chunk {
  TileKey tile;
  map::Heightfield heights;
  std::vector<ground::LandCoverPolygon>
      surfaces;  ///< Areas, and footprints of buildings that are anchored in other tiles.
  std::vector<roads::Road> roads;
  std::vector<roads::Strip> watercourses;  ///< Running water.
  /// Sorted by first arm. All whose arms the roads can tell: those within roads::kJunctionHalo_m at least. Others that
  /// cover ground of the tile are surfaces.
  std::vector<roads::Junction> junctions;
  std::vector<structures::Span> bridges, tunnels;
  std::vector<buildings::Building> buildings;  ///< Their own footprints cover the ground too (coarse_land_cover).
  std::vector<plants::Tree> trees;
  std::vector<plants::Wood> woods;
  std::vector<plants::Planting> plantings;
  std::vector<plants::TreeRow> tree_rows;
  std::vector<plants::PowerLineCorridor> corridors;
  std::vector<props::Barrier> barriers;
  std::vector<props::Lamp> lamps;
  bool operator==(const Chunk&) const = default;
};

struct Scene {
  Header header;
  std::vector<Chunk> chunks;  ///< Sorted by tile.
  bool operator==(const Scene&) const = default;
};

/// In which plants and fields are shown: of the sky's time.
plants::Month month_of(const Header& header);

/// The part of the region that belongs to a tile.
Box2 box_of(const Header& header, TileKey tile);
/// Whether what is anchored at a place belongs to a tile; from outside the region, to the nearest one.
bool is_anchored(const Header& header, TileKey tile, Vec2 anchor);
/// Keys of all tiles that the region touches, sorted.
std::vector<TileKey> tiles_of(const Header& header);
/// The chunk's junctions whose first place lies in its tile: each of a scene's junctions that its roads can tell is in
/// one tile's.
std::vector<roads::Junction> anchored_junctions(const Header& header, const Chunk& chunk);

}  // namespace citykiln::scene
