#include "compiler/commands/view/read_tileset_tree.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "exporters/file.h"
#include "exporters/run_files.h"

namespace citykiln::commands {
namespace {

using Json = nlohmann::json;

// A tree over the whole Earth has 32 levels above its tiles.
constexpr int kMostDepth = 64;

// A property of a file that no tileset written by citykiln has; thrown as an exception.
struct Wrong {
  std::string what;
};
Wrong wrong(std::string what) { return {std::move(what)}; }

exporters::OrientedBox checked_box_of(const Json& tile) {
  const auto numbers = tile.at("boundingVolume").at("box").get<std::vector<double>>();
  if (numbers.size() != 12) throw wrong("has a box without twelve numbers");
  const auto vector_at = [&](std::size_t i) { return Vec3{numbers[i], numbers[i + 1], numbers[i + 2]}; };
  exporters::OrientedBox box({unit(vector_at(3)), unit(vector_at(6)), unit(vector_at(9))});
  for (std::size_t i = 0; i < 3; ++i) {
    const double middle = dot(box.axes[i], vector_at(0)), half = length(vector_at(3 + 3 * i));
    box.low[i] = middle - half, box.high[i] = middle + half;
  }
  return box;
}

/// Reads the files of a tileset, each once. Throws Json::exception and Wrong.
class TilesetTreeReader {
 public:
  explicit TilesetTreeReader(std::string folder) : folder_(std::move(folder)) {}

  /// The file that is being read.
  const std::string& file() const { return file_; }

  TileNode read(const std::string& name, int depth) {
    if (!read_.insert(name).second) throw wrong("is named twice");
    const std::string before = std::exchange(file_, name);
    const auto bytes = exporters::read_file(folder_ + "/" + name);
    if (!bytes) throw wrong("cannot be read");
    const Json tileset = Json::parse(reinterpret_cast<const char*>(bytes->data()),
                                     reinterpret_cast<const char*>(bytes->data()) + bytes->size());
    TileNode root = node_of(tileset.at("root"), depth);
    file_ = before;
    return root;
  }

 private:
  TileNode node_of(const Json& tile, int depth) {
    if (depth > kMostDepth) throw wrong(fmt::format("has more than {} levels", kMostDepth));
    if (tile.value("refine", "REPLACE") != "REPLACE") throw wrong("refines tiles by addition");
    if (depth > 0 && tile.contains("transform")) throw wrong("moves a tile");
    TileNode node{.box = checked_box_of(tile), .error_m = tile.at("geometricError").get<double>()};
    if (!(node.error_m >= 0)) throw wrong("has a negative error");
    if (tile.contains("content")) {
      const auto uri = tile.at("content").at("uri").get<std::string>();
      if (uri.empty() || uri.front() == '/' || uri.find("..") != std::string::npos)
        throw wrong("names a content outside of its folder");
      if (uri.ends_with(".json")) return read(uri, depth + 1);
      node.path = folder_ + "/" + uri;
    }
    if (tile.contains("children"))
      for (const Json& child : tile.at("children")) node.children.push_back(node_of(child, depth + 1));
    return node;
  }

  std::string folder_, file_;
  std::set<std::string> read_;
};

}  // namespace

Result<TileNode> read_tileset_tree(const std::string& folder) {
  TilesetTreeReader reader(folder);
  try {
    return reader.read(exporters::kTilesetName, 0);
  } catch (const Wrong& wrong) {
    return Error{folder + "/" + reader.file(), wrong.what + "; expected a tileset written by citykiln"};
  } catch (const Json::exception&) {
    return Error{folder + "/" + reader.file(), "is not a tileset written by citykiln"};
  }
}

}  // namespace citykiln::commands
