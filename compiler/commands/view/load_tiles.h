// Loads baked tiles: bakes a manifest (a compiled scene), or reads .glb files or the folder of a run.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/commands/view/tile_tree.h"
#include "compiler/contract/result.h"
#include "compiler/scene/scene.h"
#include "compiler/sky/air_settings.h"
#include "compiler/sky/clouds/read_clouds.h"
#include "compiler/sky/moment.h"
#include "compiler/stage_timer.h"

namespace citykiln::commands {

/// The tolerance of the tiles that give the heights of viewpoints, in metres: coarse enough to be quick, fine enough
/// for the heights of streets.
inline constexpr double kCoarseTile_m = 2.5;

/// The input of a command that needs tiles.
struct LoadRequest {
  std::vector<std::string> paths;   ///< One .kiln, one folder of a run, or several .glb files.
  std::optional<sky::Moment> time;  ///< The time of the sky for baking a manifest; empty: the scene's.
  sky::AirSettings air;             ///< The values that are set replace those of the scene.
  std::optional<std::vector<sky::CloudRequest>> clouds;  ///< Empty: the scene's clouds.
  std::optional<double> tolerance_m;                     ///< The tolerance for baking a manifest; empty: 0.1 m.
  std::optional<std::size_t> level{};  ///< For a folder; empty: 0, or chosen per tile (asks_for_levels()).
  scene::ShownRequest shown{};         ///< Baked tiles can only lose layers, and have lit lamps or not.
  std::vector<scene::TileKey> only;    ///< If not empty, only these tiles.
  int threads = 0;
};

/// The tiles of a request, and their scene's header and surroundings.
struct Loaded {
  std::vector<bake::BakedTile> tiles;         ///< Sorted by tile.
  std::optional<scene::Header> header;        ///< From the given manifest, or the one beside the .glb folder.
  std::optional<bake::BakedTile> backdrop{};  ///< The land around (bake/far/bake_surroundings.h), if it was read.
  std::string manifest_path{};                ///< The manifest of the header; "" for none.
  /// The cylinder that the tiles are in. `tiles` are in the plane nevertheless (bake::flattened()).
  std::optional<map::Cylinder> cylinder{};
};

/// Returns "OUT/scene.kiln" for "OUT", the folder of a run that wrote its manifest and no tiles; any other path
/// unchanged.
std::string manifest_without_tiles(const std::string& path);

/// True if a request is for a run's folder, where the level of each tile is chosen to suit the cameras.
bool asks_for_levels(const LoadRequest& request);

/// The tiles of a folder at all levels, and coarse tiles, from which views are found.
struct TileTree {
  TileNode root;
  std::string manifest_path;     ///< The manifest of the folder, which may be missing.
  bool is_on_ellipsoid = false;  ///< True for 3D Tiles, whose frame is not the plane.
  std::vector<std::string> coarse_paths{};
  std::optional<map::Cylinder> cylinder{};  ///< The cylinder that the tiles are in; boxes are in its frame.
  /// In the plane. The tiles of `coarse_paths`: the level of each tile nearest to 2.5 m.
  std::vector<bake::BakedTile> coarse{};
};

/// Reads the list of a folder's .glb tiles (or of its 3D Tiles, if it has no .glb tiles), and the coarse tiles. The box
/// of a .glb tile is the box of its coarse level, widened by that level's tolerance. Errors: a folder without a
/// finished run, without tiles, or without the requested ones.
Result<TileTree> read_tile_tree(const LoadRequest& request, const OnProgress& on_progress);

/// Returns the header of a manifest; empty if the file is missing or holds none of the tiles. No manifest holds the
/// inner tiles of a tileset.
std::optional<scene::Header> header_of(const std::string& manifest_path, std::span<const bake::BakedTile> tiles);

/// Reads the contents of a tree at these paths (result of contents_of()). Coarse tiles among them are reused; the other
/// coarse tiles are freed. Errors: files that cannot be read.
Result<Loaded> load_contents(TileTree& tree, const std::vector<std::string>& paths, const OnProgress& on_progress);

/// Loads the tiles of a request. Errors: files that cannot be read, a folder without the requested tiles and level,
/// mixed kinds of input.
Result<Loaded> load_tiles(const LoadRequest& request, const OnProgress& on_progress);

}  // namespace citykiln::commands
