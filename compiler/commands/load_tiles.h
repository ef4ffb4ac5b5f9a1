// Loads baked tiles: by baking a manifest, or by reading .glb files or a run's folder.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/commands/tile_tree.h"
#include "compiler/contract/result.h"
#include "compiler/scene/scene.h"
#include "compiler/sky/air_settings.h"
#include "compiler/stage_timer.h"

namespace citykiln::commands {

/// The tolerance of the tiles that tell the heights of eyes: coarse enough to be quick, fine enough for the heights of
/// streets.
inline constexpr double kCoarseTile_m = 2.5;

struct LoadRequest {
  std::vector<std::string> paths;      ///< One .kiln, or one folder of a run, or .glb files.
  std::string time;                    ///< Time of the sky for baking a manifest; "": the scene's.
  sky::AirSettings air;                ///< What of it replaces the scene's.
  std::string clouds;                  ///< Of sky::read_clouds(); "": the scene's.
  std::optional<double> tolerance_m;   ///< For baking a manifest; none: 0.1 m.
  std::optional<std::size_t> level{};  ///< Of a folder's tiles; none: 0, or by tile (asks_for_levels()).
  std::vector<scene::TileKey> only;    ///< If not empty, only these tiles.
  int threads = 0;
};

struct Loaded {
  std::vector<bake::BakedTile> tiles;  ///< Sorted by tile.
  std::optional<scene::Header>
      header;  ///< Of the given manifest, or of the manifest beside the folder of the .glb files.
  std::optional<bake::BakedTile> backdrop{};  ///< The land around (bake/bake_surroundings.h), where its file was read.
  std::string manifest_path{};                ///< The manifest that the header is of; "" for none.
};

/// Whether a request asks for a run's folder, each of whose tiles has a level that suits the cameras.
bool asks_for_levels(const LoadRequest& request);

/// The tiles of a folder at all levels, and coarse tiles, from which views are found.
struct TileTree {
  TileNode root;
  std::string manifest_path;     ///< Of the folder; may be absent.
  bool is_on_ellipsoid = false;  ///< Of 3D Tiles, whose frame is not the plane.
  std::vector<std::string> coarse_paths{};
  std::vector<bake::BakedTile> coarse{};  ///< Of `coarse_paths`: of each tile the level nearest to 2.5 m.
};

/// Reads the list of a folder's .glb tiles, or its 3D Tiles where it has no other ones, and coarse tiles. Boxes of .glb
/// tiles are those of the coarse ones, wider by their errors.
/// Errors: a folder without a finished run, without tiles, or without the requested ones.
Result<TileTree> read_tile_tree(const LoadRequest& request, const OnProgress& on_progress);

/// The header of a manifest, if there is one that has one of the tiles: inner tiles of a tileset have none there.
std::optional<scene::Header> header_of(const std::string& manifest_path, std::span<const bake::BakedTile> tiles);

/// Reads contents of a tree (contents_of()); takes those that are among the coarse ones from there, and frees the
/// others.
Result<Loaded> load_contents(TileTree& tree, const std::vector<std::string>& paths, const OnProgress& on_progress);

/// Errors: files that cannot be read, a folder without the requested tiles and level, mixed kinds of input.
Result<Loaded> load_tiles(const LoadRequest& request, const OnProgress& on_progress);

}  // namespace citykiln::commands
