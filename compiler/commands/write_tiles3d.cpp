#include "compiler/commands/write_tiles3d.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <map>
#include <optional>
#include <utility>

#include "compiler/bake/bend.h"
#include "compiler/commands/join_tiles.h"
#include "compiler/contract/tolerance.h"
#include "compiler/map/geoid.h"
#include "compiler/pipeline.h"
#include "exporters/gltf/encode_tile.h"
#include "exporters/tiles3d/quadtree.h"
#include "exporters/tiles3d/tileset.h"

namespace citykiln::commands {
namespace {

using exporters::NodeKey;
using exporters::TilesetTile;

/// The side of the widest inner tile with content: single precision is exact over twice that.
constexpr double kWidest_m = 8192;

/// An encoded content that waits to be written, and its tile.
struct Content {
  std::vector<std::byte> glb{};
  TilesetTile tile;
};

/// Makes contents of baked tiles.
class ContentMaker {
 public:
  ContentMaker(const scene::Header& header, const Outputs& outputs, const map::Geoid& geoid, int threads)
      : header_(header), geoid_(geoid), globe_(header.origin), threads_(threads) {
    Outputs contents = outputs;
    contents.target = Target::kCesium;
    options_ = verify::glb_options_of(contents);
    options_.is_on_ellipsoid = true;
  }

  /// @param name  Of the content, relative to 3dtiles/.
  /// @param centre  Of the tile's square: the axes of its box are the plane's there.
  Content content_of(bake::BakedTile&& baked, Vec2 centre, std::string name) const {
    const bake::BakedTile tile = bake::bent(std::move(baked), globe_, geoid_);
    exporters::EncodedTile encoded = exporters::encode_tile(tile, header_, options_, threads_);
    const map::GlobePoint there = globe_.at(at_height(centre, 0));
    return {std::move(encoded.glb),
            {.box = exporters::box_of(tile, {there.east, there.north, there.up}),
             .error_m = encoded.error_m,
             .content = std::move(name),
             .tolerance_m = tile.tolerance_m,
             .plant_error_m = tile.plant_error_m}};
  }

  exporters::TilesetFacts facts(const std::string& geoid) const {
    return {.to_earth = globe_.to_earth(),
            .origin = header_.origin,
            .geoid = geoid,
            .geoid_height_m = map::height_m(geoid_, {}),
            .attributions = header_.attributions};
  }

 private:
  const scene::Header& header_;
  const map::Geoid& geoid_;
  map::Globe globe_;
  exporters::GlbOptions options_;
  int threads_;
};

/// The tolerances of inner tiles by height above the tiles, from 1: each twice the one below, up to kCoarsest_m.
std::vector<double> inner_tolerances_m(double coarsest_m, int height) {
  std::vector<double> all_m;
  for (int h = 1; h <= height; ++h) all_m.push_back(std::min(kCoarsest_m, (h == 1 ? coarsest_m : all_m.back()) * 2));
  return all_m;
}

/// The levels of tiles, and those that only inner tiles are made of.
std::vector<double> all_levels_m(std::vector<double> ladder_m, std::span<const double> inner_m) {
  for (const double tolerance_m : inner_m)
    if (tolerance_m > ladder_m.back()) ladder_m.push_back(tolerance_m);
  return ladder_m;
}

/// Bakes a scene and writes the contents of its tile tree, each as soon as all that it is made of is baked.
class TreeWriter {
 public:
  TreeWriter(const scene::Scene& scene, const Outputs& outputs, const ContentMaker& maker, int threads,
             exporters::OutputFolder& folder)
      : scene_(scene),
        maker_(maker),
        threads_(threads),
        folder_(folder),
        tree_(exporters::quadtree_of(scene.header, scene.chunks)),
        own_levels_(outputs.ladder_m.size()),
        inner_m_(inner_tolerances_m(outputs.ladder_m.back(), tree_.root.height)),
        levels_m_(all_levels_m(outputs.ladder_m, inner_m_)),
        slots_(scene.chunks.size() * levels_m_.size()) {}

  Result<TilesetTile> write(Report& report, const OnProgress& on_progress) {
    const Result<Done> done =
        bake_scene(scene_, levels_m_, threads_, report, on_progress,
                   {.exists = [](ChunkLevel) { return false; },
                    .process = [&](ChunkLevel at, bake::BakedTile&& tile) { process(at, std::move(tile)); },
                    .take = [&](ChunkLevel at, const Report&) { return take(at); }});
    if (!done) return done.error();
    return std::move(*root_);
  }

  std::vector<verify::WrittenFile> files;

 private:
  /// A baked tile at one level: its content, or the tile itself if inner tiles are made of it.
  struct Slot {
    std::optional<Content> content;
    std::optional<bake::BakedTile> coarse;
  };

  Slot& slot(ChunkLevel at) { return slots_[at.chunk * levels_m_.size() + at.level]; }
  Vec2 centre_of(NodeKey key) const { return exporters::box_of(tree_, scene_.header, key).centre(); }

  void process(ChunkLevel at, bake::BakedTile&& tile) {
    if (std::ranges::find(inner_m_, levels_m_[at.level]) != inner_m_.end()) slot(at).coarse = tile;
    if (at.level >= own_levels_) return;
    const std::string name = fmt::format("{}_L{}.glb", to_string(tile.tile), at.level);
    const Vec2 centre = centre_of(exporters::leaf_of(tree_, tile.tile));
    slot(at).content = maker_.content_of(std::move(tile), centre, name);
  }

  /// Writes a tile's level. The last level completes the tile.
  Result<Done> take(ChunkLevel at) {
    if (at.level == 0) chain_.clear();
    if (std::optional<Content> content = std::exchange(slot(at).content, std::nullopt)) {
      // a coarser level with an error that is no larger would be shown at the same distances
      if (chain_.empty() || content->tile.error_m > chain_.back().error_m) {
        if (const Result<Done> done = put(std::move(*content), chain_); !done) return done;
      }
    }
    if (at.level + 1 < levels_m_.size()) return Done{};
    keep_coarse(at.chunk);
    return complete(exporters::leaf_of(tree_, scene_.chunks[at.chunk].tile), chained());
  }

  Result<Done> put(Content&& content, std::vector<TilesetTile>& tiles) {
    const std::string name = "3dtiles/" + content.tile.content;
    if (const Result<Done> done = folder_.write(name, content.glb); !done) return done;
    files.push_back({name, content.glb.size()});
    tiles.push_back(std::move(content.tile));
    return Done{};
  }

  /// The levels as a chain, the coarsest first.
  TilesetTile chained() {
    TilesetTile tile = std::move(chain_.front());
    for (std::size_t i = 1; i < chain_.size(); ++i) {
      TilesetTile coarser = std::move(chain_[i]);
      coarser.box.grow(tile.box);
      coarser.box.round_outwards();
      coarser.children.push_back(std::move(tile));
      tile = std::move(coarser);
    }
    return tile;
  }

  /// Hands the coarse levels of a tile to the inner nodes above it.
  void keep_coarse(std::size_t chunk) {
    NodeKey key = exporters::leaf_of(tree_, scene_.chunks[chunk].tile);
    for (const double tolerance_m : inner_m_) {
      key = exporters::parent_of(key);
      const auto level = static_cast<std::size_t>(std::ranges::find(levels_m_, tolerance_m) - levels_m_.begin());
      if (has_content(key)) parts_[key].push_back(*slot({chunk, level}).coarse);
    }
    for (std::size_t level = 0; level < levels_m_.size(); ++level) slot({chunk, level}).coarse.reset();
  }

  bool has_content(NodeKey key) const {
    return scene_.header.tile_m * static_cast<double>(std::int64_t{1} << key.height) <= kWidest_m;
  }

  /// Adds a finished node to its parent, which is finished if this was its last child.
  Result<Done> complete(NodeKey key, TilesetTile&& tile) {
    if (key == tree_.root) {
      root_ = std::move(tile);
      return Done{};
    }
    const NodeKey above = exporters::parent_of(key);
    finished_[above].push_back(std::move(tile));
    if (finished_[above].size() < tree_.children.at(above)) return Done{};
    Result<TilesetTile> node = make_node(above);
    return node ? complete(above, std::move(*node)) : Result<Done>(node.error());
  }

  Result<TilesetTile> make_node(NodeKey key) {
    std::vector<TilesetTile> children = std::move(finished_.extract(key).mapped());
    std::vector<TilesetTile> own(1);
    if (has_content(key)) {
      own.clear();
      const std::vector<bake::BakedTile> parts = std::move(parts_.extract(key).mapped());
      Result<bake::BakedTile> joined = join_tiles(parts);
      if (!joined) return joined.error();
      const std::string name = fmt::format("Q{}_{}_{}.glb", key.height, key.x, key.y);
      if (const Result<Done> done = put(maker_.content_of(std::move(*joined), centre_of(key), name), own); !done)
        return done.error();
    }
    return with_children(std::move(own.front()), std::move(children));
  }

  /// An inner node. Without content it shows nothing, so that its error is its size.
  static TilesetTile with_children(TilesetTile tile, std::vector<TilesetTile>&& children) {
    if (tile.box.is_empty()) tile.box = exporters::OrientedBox(children.front().box.axes);
    double most_m = 0;
    for (const TilesetTile& child : children) {
      tile.box.grow(child.box);
      most_m = std::max(most_m, child.error_m);
    }
    tile.box.round_outwards();
    if (tile.content.empty()) tile.error_m = length(tile.box.corner(7) - tile.box.corner(0));
    // a bound may be larger than the error, and errors must fall strictly
    tile.error_m = std::max(tile.error_m, most_m * kLeastRatio);
    tile.children = std::move(children);
    return tile;
  }

  static constexpr double kLeastRatio = 1 + 0x1p-10;

  const scene::Scene& scene_;
  const ContentMaker& maker_;
  int threads_;
  exporters::OutputFolder& folder_;
  exporters::Quadtree tree_;
  std::size_t own_levels_;                                 ///< So many levels are contents of tiles.
  std::vector<double> inner_m_;                            ///< Tolerances of inner nodes by height, from 1.
  std::vector<double> levels_m_;                           ///< All that are baked.
  std::vector<Slot> slots_;                                ///< By chunk and level.
  std::vector<TilesetTile> chain_;                         ///< Of the tile that is taken, finest first.
  std::map<NodeKey, std::vector<bake::BakedTile>> parts_;  ///< What inner nodes are joined from.
  std::map<NodeKey, std::vector<TilesetTile>> finished_;   ///< The children of inner nodes.
  std::optional<TilesetTile> root_;
};

}  // namespace

Result<std::vector<verify::WrittenFile>> write_tiles3d(const scene::Scene& scene, const Outputs& outputs, int threads,
                                                       exporters::OutputFolder& folder, Report& report,
                                                       const OnProgress& on_progress) {
  if (scene.chunks.empty()) return std::vector<verify::WrittenFile>();
  const Result<map::Geoid> geoid = map::read_geoid(outputs.geoid, scene.header.region, map::Plane(scene.header.origin));
  if (!geoid) return geoid.error();
  if (outputs.geoid.empty()) report.add(Code::kNoGeoidHeight, {});

  const ContentMaker maker(scene.header, outputs, *geoid, threads);
  TreeWriter writer(scene, outputs, maker, threads, folder);
  Report repeated;
  Result<TilesetTile> root = writer.write(outputs.glb ? repeated : report, on_progress);
  if (!root) return root.error();
  for (const exporters::TilesetFile& file : exporters::encode_tileset(std::move(*root), maker.facts(outputs.geoid))) {
    const auto bytes = exporters::bytes_of(file.json);
    if (const Result<Done> done = folder.write(file.name, bytes); !done) return done.error();
    writer.files.push_back({file.name, bytes.size()});
  }
  return std::move(writer.files);
}

}  // namespace citykiln::commands
