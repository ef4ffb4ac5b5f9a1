// The scene: the recipes of all objects, divided by tile. The manifest (.kiln) holds exactly this.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compiler/buildings/lit_windows.h"
#include "compiler/buildings/recipe.h"
#include "compiler/buildings/styles/rulebook.h"
#include "compiler/cars/recipe.h"
#include "compiler/climate/climate_field.h"
#include "compiler/ground/landforms/recipe.h"
#include "compiler/ground/recipe.h"
#include "compiler/lots/recipe.h"
#include "compiler/map/element_text.h"
#include "compiler/map/plane/heightfield.h"
#include "compiler/map/plane/plane.h"
#include "compiler/people/recipe.h"
#include "compiler/pitches/recipe.h"
#include "compiler/plants/recipe.h"
#include "compiler/plants/season.h"
#include "compiler/plants/species_texts.h"
#include "compiler/props/recipe.h"
#include "compiler/roads/junctions/junction.h"
#include "compiler/scene/clip.h"
#include "compiler/scene/shown.h"
#include "compiler/sky/recipe.h"
#include "compiler/structures/recipe.h"
#include "compiler/surroundings/recipe.h"
#include "compiler/things/recipe.h"
#include "compiler/wires/recipe.h"

namespace citykiln::scene {

/// The key of a tile. In the plane, tile (x, y) covers [x, x + 1) times [y, y + 1) times the tile size.
struct TileKey {
  std::int32_t x = 0, y = 0;
  auto operator<=>(const TileKey&) const = default;
};

/// Returns the key as a text, such as "3_-2".
std::string to_string(TileKey tile);

/// The width of the margin around its tile from which a chunk holds recipes, in whole metres. It is the largest
/// distance over which neighbours influence an object (plants).
inline constexpr double kHalo_m = 48;
/// The distance beyond its tile up to which a chunk holds roads: the arms of every junction of the tile are among them.
inline constexpr double kRoadHalo_m = 56;

/// The properties of the whole scene.
struct Header {
  LonLat origin;                        ///< The origin of the plane.
  Box2 extent;                          ///< The compiled part of the plane: whole cells of map::kCell_m.
  double tile_m = map::kDefaultTile_m;  ///< A whole multiple of map::kCell_m.
  std::uint64_t seed = 0;
  double resampling_error_m = 0;  ///< The largest vertical error of the heightfield against the heightmaps.
  sky::Sky sky;
  std::vector<std::string> sources;            ///< File names of map and heightmaps, without folders.
  std::vector<std::string> attributions;       ///< "© OpenStreetMap contributors", then the heightmaps' credits.
  std::optional<double> snow_line_m{};         ///< Land above this height, in the heightmaps' datum, is under snow.
  std::vector<buildings::RuleText> rules{};    ///< The rule files of the buildings' styles, sorted by name.
  std::vector<plants::SpeciesText> species{};  ///< The files of the plants' species, sorted by name.
  /// Rows of the table of things that the scene uses, each under its name, and their rule files. Sorted by name.
  std::vector<buildings::RuleText> things{};
  surroundings::Surroundings around{};  ///< The land and sea beyond the extent; may be empty.
  climate::ClimateField climate = climate::uniform_climate(climate::ClimateClass::kCfb);
  bool has_wild_slopes = true;  ///< Steep land that is not mapped is taken to be scrub and rock (--assume surfaces).
  cars::CarShare cars = cars::kNoCars;  ///< How many parking places have a car.
  /// Pavements have benches, bins and signs where none are mapped (--assume roadsides).
  bool has_street_furniture = false;
  people::PeopleShare people = people::kNobody;  ///< How many people are in the streets.
  cars::CarShare traffic = cars::kNoCars;        ///< How many slots of lanes have a moving car.
  Shown shown{};                                 ///< The recipes that tiles show, and how.
  Clip clip{};                                   ///< Beyond it there is no ground; empty: nothing is clipped.
  bool operator==(const Header&) const = default;
};

/// The recipes of one tile, which can be baked without any other chunk. Each vector is sorted by id.
///
/// Objects that cross a tile's border:
/// - Surfaces, roads, watercourses, landforms and footprints are in every chunk whose tile, widened by kHalo_m
///   (kRoadHalo_m), they touch. They are trimmed to it, except areas of landforms.
/// - Sports pitches and yards are whole in every chunk whose tile, widened by kHalo_m, they touch.
/// - Junctions are in every chunk whose tile is within 32 m (roads::kJunctionHalo_m).
/// - Bridges and tunnels are whole in every chunk whose tile, widened by kHalo_m, they can grade. They are also in the
///   chunk of their first point, which alone bakes them (baking_tile: another one if that tile lies beyond the clip).
/// - Trees, and every tree row, hedge and power-line corridor of which a segment is there, are whole in every chunk
///   whose tile is within plants::kObstacleInfluence_m.
///   Hedges are also in the chunk of their first point.
/// - Woods and plantings are in every chunk that has their surface.
/// - Buildings are only in the chunk of the tile that bakes them (baking_tile), which the middle of their box decides.
/// - Other barriers, lamps, things and wires are only in the chunk of their anchor.
struct Chunk {
  TileKey tile;
  map::Heightfield heights;
  // the recipes of each kind: std::vector<buildings::Building> buildings and so on
#define ELEMENT(type, member) std::vector<type> member{};
#define PART(type, member) std::vector<type> member{};
#include "compiler/scene/kinds.inc"
  std::vector<map::ElementText> texts{};  ///< Texts of the elements of these recipes; sorted by id.
  bool operator==(const Chunk&) const = default;
};

/// A compiled map.
struct Scene {
  Header header;
  std::vector<Chunk> chunks;  ///< Sorted by tile.
  bool operator==(const Scene&) const = default;
};

/// Returns the month of the sky's time, by the climate of the origin. Plants and fields are shown as they are in this
/// month; without a time as in midsummer.
plants::Month month_of(const Header& header);

/// Returns the same month without the climate, which decides how much grass is straw.
climate::LocalMonth local_month_of(const Header& header);

/// Returns the time of the week of the sky, in mean solar time. Without a date it is a Wednesday: noon, or 20:00 where
/// it is dark.
buildings::WeekTime week_time_of(const Header& header);

/// Returns the time of the week if it is dark, which decides which windows are lit; empty by day.
std::optional<buildings::WeekTime> night_of(const Header& header);

/// True if street lamps are lit under a sky, which need not be the header's.
bool are_lamps_lit(const Shown& shown, const sky::Sky& sky);

/// True if the tiles of a scene show a layer.
inline bool shows(const Header& header, SceneLayer layer) { return !has(header.shown.left_out, layer); }

/// Returns the cylinder in which the world is; empty if it is not in one. Recipes are in the plane in either case.
std::optional<map::Cylinder> cylinder_of(const Header& header);

/// Returns the part of the extent that belongs to a tile.
Box2 box_of(const Header& header, TileKey tile);
/// True if an object belongs to a tile because the tile contains its anchor. An anchor outside the extent belongs to
/// the nearest tile.
/// @param anchor  The place of the object that decides: its centroid or first point, plane metres.
bool is_anchored(const Header& header, TileKey tile, Vec2 anchor);
/// Returns the one tile that bakes an object: that of its anchor (is_anchored()). If less than 1 m² of it is in the
/// clip, it is the first tile by x, then y, that the object's box touches and of which 1 m² is in the clip; if there is
/// none, it stays that of the anchor. Cost: touches_clip() (scene/clip.h), once or once for each of these tiles.
TileKey baking_tile(const Header& header, Vec2 anchor, const Box2& box);
/// Returns the tile that bakes a bridge or tunnel, which is anchored at its first point.
TileKey baking_tile(const Header& header, const structures::Span& span);
/// Returns the keys of all tiles that the extent touches, sorted; a scene lacks those without ground in its clip.
std::vector<TileKey> tiles_of(const Header& header);
/// Returns the chunk's junctions whose first node lies in its tile. Each junction of a scene belongs to exactly one
/// chunk in this way; to none if its first node is outside of the extent's tiles.
std::vector<roads::Junction> anchored_junctions(const Header& header, const Chunk& chunk);

}  // namespace citykiln::scene
