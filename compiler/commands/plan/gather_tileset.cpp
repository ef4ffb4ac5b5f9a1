#include "compiler/commands/plan/gather_tileset.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "exporters/tiles3d/read_tileset.h"

namespace citykiln::commands {
namespace {

using exporters::TilesetTile;

// Puts a prefix before the names of contents. Boxes grow, since their numbers in the file are rounded.
void adapt(TilesetTile& tile, const std::string& prefix) {
  if (!tile.content.empty()) tile.content = prefix + tile.content;
  tile.box.round_outwards();
  for (TilesetTile& child : tile.children) {
    adapt(child, prefix);
    tile.box.grow(child.box);
  }
  tile.box.round_outwards();
}

}  // namespace

Result<TilesetTile> read_region_tileset(const std::string& folder, const std::string& prefix) {
  Result<TilesetTile> root = exporters::read_tileset(folder);
  if (root) adapt(*root, prefix);
  return root;
}

TilesetTile joined_trees(std::vector<TilesetTile>&& trees) {
  assert(!trees.empty());
  if (trees.size() == 1) return std::move(trees.front());
  TilesetTile root;
  root.box = trees.front().box;
  for (const TilesetTile& tree : trees) {
    root.box.grow(tree.box);
    root.error_m = std::max(root.error_m, 2 * tree.error_m);
  }
  root.box.round_outwards();
  root.children = std::move(trees);
  return root;
}

}  // namespace citykiln::commands
