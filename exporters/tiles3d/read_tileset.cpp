#include "exporters/tiles3d/read_tileset.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "exporters/file.h"
#include "exporters/run_files.h"

namespace citykiln::exporters {
namespace {

using Json = nlohmann::json;

// A tree over the whole Earth has 32 levels above its tiles.
constexpr int kMostDepth = 64;

// Thrown for a property of a file that no tileset written by citykiln has.
struct TilesetFault {
  std::string what;  // "has a negative error"
};
void demand_tileset(bool holds, const char* otherwise) {
  if (!holds) throw TilesetFault{otherwise};
}

OrientedBox box_in(const Json& tile) {
  const auto numbers = tile.at("boundingVolume").at("box").get<std::vector<double>>();
  demand_tileset(numbers.size() == 12, "has a box without twelve numbers");
  const auto vector_at = [&](std::size_t i) { return Vec3{numbers[i], numbers[i + 1], numbers[i + 2]}; };
  OrientedBox box({unit(vector_at(3)), unit(vector_at(6)), unit(vector_at(9))});
  for (std::size_t i = 0; i < 3; ++i) {
    const double middle = dot(box.axes[i], vector_at(0)), half = length(vector_at(3 + 3 * i));
    box.low[i] = middle - half, box.high[i] = middle + half;
  }
  return box;
}

void read_content(const Json& json, TilesetTile& tile) {
  tile.content = json.at("content").at("uri").get<std::string>();
  demand_tileset(!tile.content.empty() && tile.content.front() != '/' && tile.content.find("..") == std::string::npos,
                 "refers to a content outside its folder");
  if (is_external(tile)) return;
  demand_tileset(tile.content.ends_with(".glb"), "refers to a content that is neither .glb nor .json");
  tile.tolerance_m = json.at("extras").at("tolerance_m");
}

TilesetTile tile_in(const Json& json, int depth) {
  demand_tileset(depth < kMostDepth, "has too many levels");
  // the root must state it, others inherit it
  demand_tileset(json.value("refine", depth == 0 ? "" : "REPLACE") == "REPLACE", "refines tiles by addition");
  demand_tileset(depth == 0 || !json.contains("transform"), "moves a tile");
  TilesetTile tile{.box = box_in(json), .error_m = json.at("geometricError")};
  demand_tileset(tile.error_m >= 0, "has a negative error");
  if (json.contains("content")) read_content(json, tile);
  if (!json.contains("children")) return tile;
  demand_tileset(!json["children"].empty(), "has children without a tile");
  for (const Json& child : json["children"]) tile.children.push_back(tile_in(child, depth + 1));
  return tile;
}

ReadTileset tileset_in(const Json& json) {
  const Json &asset = json.at("asset"), &root = json.at("root");
  demand_tileset(asset.at("version") == "1.1", "has another version than 1.1");
  return {.root = tile_in(root, 0),
          .error_m = json.value("geometricError", 0.0),
          .transform = root.value("transform", std::vector<double>()),
          .attribution = asset.value("extras", Json::object()).value("copyright", "")};
}

/// Reads a tileset and the tilesets that it refers to, each once.
class TilesetFiles {
 public:
  explicit TilesetFiles(const std::string& folder) : folder_(folder) {}

  Result<TilesetTile> read(const std::string& name, int depth) {
    const std::string path = folder_ + "/" + name;
    if (!read_.insert(name).second || depth == kMostDepth)
      return Error{path, "is referred to twice or nested too deep"};
    const auto bytes = read_file(path);
    if (!bytes) return bytes.error();
    Result<ReadTileset> file = decode_tileset({reinterpret_cast<const char*>(bytes->data()), bytes->size()}, path);
    if (!file) return file.error();
    if (const Result<Done> done = embed(file->root, depth); !done) return done.error();
    return std::move(file->root);
  }

 private:
  // Puts the roots of other tilesets in the places of the tiles that refer to them.
  Result<Done> embed(TilesetTile& tile, int depth) {
    if (is_external(tile)) {
      Result<TilesetTile> root = read(tile.content, depth + 1);
      if (!root) return root.error();
      tile = std::move(*root);
      return Done{};
    }
    for (TilesetTile& child : tile.children)
      if (const Result<Done> done = embed(child, depth); !done) return done;
    return Done{};
  }

  const std::string& folder_;
  std::set<std::string> read_;
};

}  // namespace

Result<ReadTileset> decode_tileset(std::string_view json, const std::string& name) {
  try {
    return tileset_in(Json::parse(json));
  } catch (const TilesetFault& fault) {
    return Error{name, fault.what + "; expected a tileset written by citykiln"};
  } catch (const Json::exception&) {
    return Error{name, "is not a tileset written by citykiln"};
  }
}

Result<TilesetTile> read_tileset(const std::string& folder) { return TilesetFiles(folder).read(kTilesetName, 0); }

}  // namespace citykiln::exporters
