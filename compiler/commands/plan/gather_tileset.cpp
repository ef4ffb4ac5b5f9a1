#include "compiler/commands/plan/gather_tileset.h"

#include <algorithm>
#include <cassert>
#include <nlohmann/json.hpp>
#include <utility>

#include "exporters/file.h"
#include "exporters/run_files.h"

namespace citykiln::commands {
namespace {

using Json = nlohmann::json;
using exporters::TilesetTile;

// Box, error and extras stand as doubles in the file and are read back as they were.
exporters::OrientedBox outward_box_of(const Json& tile) {
  const auto numbers = tile.at("boundingVolume").at("box").get<std::array<double, 12>>();
  const auto vector_at = [&](std::size_t i) { return Vec3{numbers[i], numbers[i + 1], numbers[i + 2]}; };
  exporters::OrientedBox box({unit(vector_at(3)), unit(vector_at(6)), unit(vector_at(9))});
  for (std::size_t i = 0; i < 3; ++i) {
    const double middle = dot(box.axes[i], vector_at(0)), half = length(vector_at(3 + 3 * i));
    box.low[i] = middle - half, box.high[i] = middle + half;
  }
  // the numbers are rounded
  box.round_outwards();
  return box;
}

/// Reads the files of a tileset. Throws Json::exception.
class TilesetReader {
 public:
  TilesetReader(const std::string& folder, const std::string& prefix) : folder_(folder), prefix_(prefix) {}

  TilesetTile read(const std::string& name) const {
    const auto bytes = exporters::read_file(folder_ + "/" + name);
    if (!bytes) throw Json::other_error::create(501, "cannot be read", nullptr);
    const char* text = reinterpret_cast<const char*>(bytes->data());
    return tile_of(Json::parse(text, text + bytes->size()).at("root"));
  }

 private:
  TilesetTile tile_of(const Json& json) const {
    const std::string uri = json.contains("content") ? json.at("content").at("uri").get<std::string>() : "";
    if (uri.ends_with(".json")) return read(uri);
    TilesetTile tile{.box = outward_box_of(json), .error_m = json.at("geometricError")};
    if (!uri.empty()) {
      tile.content = prefix_ + uri;
      tile.tolerance_m = json.at("extras").at("tolerance_m");
      tile.plant_error_m = json.at("extras").at("plant_error_m");
    }
    if (json.contains("children"))
      for (const Json& child : json.at("children")) {
        tile.children.push_back(tile_of(child));
        tile.box.grow(tile.children.back().box);
      }
    tile.box.round_outwards();
    return tile;
  }

  const std::string &folder_, &prefix_;
};

}  // namespace

Result<TilesetTile> read_tileset(const std::string& folder, const std::string& prefix) {
  try {
    return TilesetReader(folder, prefix).read(exporters::kTilesetName);
  } catch (const Json::exception&) {
    return Error{folder + "/" + exporters::kTilesetName, "is not a tileset written by citykiln"};
  }
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
