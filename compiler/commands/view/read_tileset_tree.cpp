#include "compiler/commands/view/read_tileset_tree.h"

#include "exporters/tiles3d/read_tileset.h"

namespace citykiln::commands {
namespace {

TileNode node_of(const exporters::TilesetTile& tile, const std::string& folder) {
  TileNode node{.box = tile.box, .error_m = tile.error_m};
  if (!tile.content.empty()) node.path = folder + "/" + tile.content;
  for (const exporters::TilesetTile& child : tile.children) node.children.push_back(node_of(child, folder));
  return node;
}

}  // namespace

Result<TileNode> read_tileset_tree(const std::string& folder) {
  const Result<exporters::TilesetTile> root = exporters::read_tileset(folder);
  if (!root) return root.error();
  return node_of(*root, folder);
}

}  // namespace citykiln::commands
