#include "compiler/outputs/write_tiles3d.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "compiler/bake/far/bake_surroundings.h"
#include "compiler/bake/far/bend.h"
#include "compiler/bake/far/fade_roads.h"
#include "compiler/bake/tiles/join_tiles.h"
#include "compiler/bake/tiles/simplify_tile.h"
#include "compiler/bake_scene.h"
#include "compiler/contract/tolerance.h"
#include "compiler/map/plane/geoid.h"
#include "compiler/outputs/tile_lights.h"
#include "exporters/gltf/write/encode_tile.h"
#include "exporters/run_files.h"
#include "exporters/tiles3d/quadtree.h"
#include "exporters/tiles3d/tileset.h"

namespace citykiln::outputs {
namespace {

using exporters::NodeKey;
using exporters::TilesetTile;
using Lights = std::vector<bake::PlacedLamp>;

/// An encoded content that waits to be written, and its tile.
struct Content {
  std::vector<std::byte> glb{};
  TilesetTile tile;
};

/// Returns the path of a tile's content relative to the folder of the run.
std::string name_in_run(const TilesetTile& tile) {
  return fmt::format("{}/{}", exporters::kTilesetFolder, tile.content);
}

/// Makes contents of baked tiles, on the ellipsoid or inside of the scene's cylinder.
class ContentMaker {
 public:
  ContentMaker(const scene::Header& header, const Outputs& outputs, const map::Geoid& geoid,
               const TextureChoice& textures, int threads)
      : header_(header),
        geoid_(geoid),
        textures_(textures),
        globe_(header.origin),
        cylinder_(scene::cylinder_of(header)),
        threads_(threads) {
    Outputs contents = outputs;
    contents.target = Target::kCesium;
    options_ = glb_options_of(contents);
    options_.is_on_ellipsoid = !cylinder_;
  }

  /// @param name  The name of the content, relative to 3dtiles/.
  /// @param centre  The centre of the tile's square, at which the axes of its box are those of the plane.
  /// @param lights  Lamps that are lights of the content, in the plane.
  Content content_of(bake::BakedTile&& baked, Vec2 centre, std::string name, const Lights& lights = {}) const {
    textures_.apply(baked);
    bake::BakedTile tile =
        cylinder_ ? bake::bent(std::move(baked), *cylinder_) : bake::bent(std::move(baked), globe_, geoid_);
    const Lights bent_lights = bent(lights);
    exporters::GlbOptions options = options_;
    options.lights = bent_lights;
    const Vec3 level = at_height(centre, 0);
    const map::BentPoint there = cylinder_ ? map::at(*cylinder_, level) : globe_.at(level);
    Content content{.glb = {},
                    .tile = {.box = exporters::box_of(tile, {there.east, there.north, there.up}),
                             .content = std::move(name),
                             .tolerance_m = tile.tolerance_m,
                             .plant_error_m = tile.plant_error_m}};
    exporters::EncodedTile encoded = exporters::encode_tile(std::move(tile), header_, options, threads_);
    content.glb = std::move(encoded.glb), content.tile.error_m = encoded.error_m;
    return content;
  }

 private:
  /// On the ellipsoid lamps are a few metres high, so that their lean to the vertical of the origin does not matter.
  Lights bent(Lights lights) const {
    // those inside of a cylinder are there already
    if (cylinder_) return lights;
    for (bake::PlacedLamp& lamp : lights) {
      Vec3& at = lamp.placement.at;
      at = globe_.at({at.x, at.y, at.z + map::height_m(geoid_, in_plan(at))}).at;
    }
    return lights;
  }

  const scene::Header& header_;
  const map::Geoid& geoid_;
  const TextureChoice& textures_;
  map::Globe globe_;
  std::optional<map::Cylinder> cylinder_;
  exporters::GlbOptions options_;
  int threads_;
};

/// How the inner tiles of one height are made.
struct InnerLevel {
  double tolerance_m;            ///< Twice that of the level below.
  std::optional<double> bake_m;  ///< Tolerance of the tiles that it is joined from; empty: joined from child nodes.
};

/// Shares of an inner level's tolerance. Tiles are baked at the first share and simplified by the second. Nodes with
/// half of the tolerance are joined, simplified by the second share, and lose objects within that distance of the
/// terrain.
constexpr double kBakeShare = 0.75, kSimplifyShare = 0.25;
/// Measuring the error of decimated terrain takes time per square of the tolerance. A tile whose tolerance is a smaller
/// share of its side is not decimated, unless its level has few tiles.
constexpr double kLeastShareOfSide = 1.0 / 512;
constexpr int kFewFromHeight = 3;

bool is_decimated(int height, double tolerance_m, double side_m) {
  return height >= kFewFromHeight || tolerance_m >= kLeastShareOfSide * side_m;
}

/// The share of the tolerance by which roads of joined nodes give way to the ground beside them.
constexpr double kFadeShare = 0.125;

/// Inner levels by height above the tiles, from 1.
std::vector<InnerLevel> inner_levels(double coarsest_m, int height) {
  std::vector<InnerLevel> all;
  for (int h = 1; h <= height; ++h) {
    const double tolerance_m = 2 * (h == 1 ? coarsest_m : all.back().tolerance_m), bake_m = kBakeShare * tolerance_m;
    if (h == 1)
      all.push_back({tolerance_m, std::min(bake_m, kCoarsest_m)});
    else
      all.push_back({tolerance_m, bake_m <= kCoarsest_m ? std::optional(bake_m) : std::nullopt});
  }
  return all;
}

/// The levels of tiles, and those that only inner tiles are made of.
std::vector<double> all_levels_m(std::vector<double> tolerances_m, std::span<const InnerLevel> inner) {
  for (const InnerLevel& level : inner)
    if (level.bake_m && *level.bake_m > tolerances_m.back()) tolerances_m.push_back(*level.bake_m);
  return tolerances_m;
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
        own_levels_(outputs.tolerances_m.size()),
        inner_(inner_levels(outputs.tolerances_m.back(), tree_.root.height)),
        levels_m_(all_levels_m(outputs.tolerances_m, inner_)),
        lights_(lights_of_tiles(scene, outputs.lights, threads)),
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

  std::vector<WrittenFile> files;

 private:
  /// A baked tile at one level: its content, or the tile itself if inner tiles are made of it.
  struct Slot {
    std::optional<Content> content;
    std::optional<bake::BakedTile> coarse;
  };

  Slot& slot(ChunkLevel at) { return slots_[at.chunk * levels_m_.size() + at.level]; }
  Vec2 centre_of(NodeKey key) const { return exporters::box_of(tree_, scene_.header, key).centre(); }

  void process(ChunkLevel at, bake::BakedTile&& tile) {
    if (std::ranges::find(inner_, levels_m_[at.level], &InnerLevel::bake_m) != inner_.end()) slot(at).coarse = tile;
    if (at.level >= own_levels_) return;
    const std::string name = fmt::format("{}_L{}.glb", to_string(tile.tile), at.level);
    const Vec2 centre = centre_of(exporters::leaf_of(tree_, tile.tile));
    slot(at).content = maker_.content_of(std::move(tile), centre, name, lights_[at.chunk]);
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
    const std::string name = name_in_run(content.tile);
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
    for (const InnerLevel& inner : inner_) {
      key = exporters::parent_of(key);
      tiles_[key].insert(scene_.chunks[chunk].tile);
      if (!inner.bake_m) continue;
      const auto level = static_cast<std::size_t>(std::ranges::find(levels_m_, *inner.bake_m) - levels_m_.begin());
      parts_[key].push_back(*slot({chunk, level}).coarse);
    }
    for (std::size_t level = 0; level < levels_m_.size(); ++level) slot({chunk, level}).coarse.reset();
  }

  const InnerLevel& inner_level(NodeKey key) const { return inner_[static_cast<std::size_t>(key.height - 1)]; }

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
    std::vector<TilesetTile> own;
    Result<bake::BakedTile> joined = simplified(key);
    if (!joined) return joined.error();
    if (key != tree_.root && !inner_level(exporters::parent_of(key)).bake_m)
      parts_[exporters::parent_of(key)].push_back(*joined);
    const std::string name = fmt::format("Q{}_{}_{}.glb", key.height, key.x, key.y);
    if (const Result<Done> done = put(maker_.content_of(std::move(*joined), centre_of(key), name), own); !done)
      return done.error();
    return with_children(std::move(own.front()), std::move(children));
  }

  /// The parts of an inner node as one tile, simplified.
  Result<bake::BakedTile> simplified(NodeKey key) {
    const std::vector<bake::BakedTile> parts = std::move(parts_.extract(key).mapped());
    Result<bake::BakedTile> joined = bake::join_tiles(parts, bake::JoinPrecision::kRounded);
    if (!joined) return joined;
    const InnerLevel& level = inner_level(key);
    joined->tolerance_m = level.tolerance_m;
    bake::remove_inner_skirts(*joined, tiles_.extract(key).mapped(), scene_.header.tile_m);
    if (!level.bake_m) {
      bake::drop_near_terrain(*joined, kSimplifyShare * level.tolerance_m);
      bake::fade_roads(*joined, kFadeShare * level.tolerance_m);
    }
    const Box2 square = exporters::box_of(tree_, scene_.header, key);
    const double simplify_m = kSimplifyShare * level.tolerance_m;
    if (is_decimated(key.height, simplify_m, square.width())) bake::simplify_terrain(*joined, square, simplify_m);
    bake::drop_unused_features(*joined);
    return joined;
  }

  /// An inner node.
  static TilesetTile with_children(TilesetTile tile, std::vector<TilesetTile>&& children) {
    double most_m = 0;
    for (const TilesetTile& child : children) {
      tile.box.grow(child.box);
      most_m = std::max(most_m, child.error_m);
    }
    tile.box.round_outwards();
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
  std::size_t own_levels_;                                 ///< The number of levels that are contents of tiles.
  std::vector<InnerLevel> inner_;                          ///< By height, from 1.
  std::vector<double> levels_m_;                           ///< The tolerances of all levels that are baked.
  std::vector<Lights> lights_;                             ///< By chunk.
  std::vector<Slot> slots_;                                ///< By chunk and level.
  std::vector<TilesetTile> chain_;                         ///< The levels of the current tile, finest first.
  std::map<NodeKey, std::vector<bake::BakedTile>> parts_;  ///< The tiles that inner nodes are joined from.
  std::map<NodeKey, std::set<scene::TileKey>> tiles_;      ///< All tiles below inner nodes.
  std::map<NodeKey, std::vector<TilesetTile>> finished_;   ///< The children of inner nodes.
  std::optional<TilesetTile> root_;
};

/// Returns a root without content above the scene's root and the land around, so that both are shown.
TilesetTile joined_with_surroundings(TilesetTile&& root, TilesetTile&& around) {
  TilesetTile both;
  both.box = root.box;
  both.box.grow(around.box);
  both.box.round_outwards();
  both.error_m = 2 * std::max(root.error_m, around.error_m);
  both.children = {std::move(root), std::move(around)};
  return both;
}

/// Bakes and writes the land around the scene, where it is known, and puts it beside the root.
Result<Done> add_surroundings(const scene::Scene& scene, const ContentMaker& maker, exporters::OutputFolder& folder,
                              TilesetTile& root, std::vector<WrittenFile>& files) {
  std::optional<bake::BakedTile> tile = bake::bake_surroundings(scene, bake::EarthCurve::kNone);
  if (!tile) return Done{};
  Content content = maker.content_of(std::move(*tile), scene.header.extent.centre(), exporters::kSurroundingsContent);
  const std::string name = name_in_run(content.tile);
  if (const Result<Done> done = folder.write(name, content.glb); !done) return done;
  files.push_back({name, content.glb.size()});
  root = joined_with_surroundings(std::move(root), std::move(content.tile));
  return Done{};
}

}  // namespace

Result<map::Geoid> geoid_of(const scene::Header& header, const Outputs& outputs) {
  return map::read_geoid(outputs.geoid, header.extent, map::Plane(header.origin));
}

exporters::TilesetFacts tileset_facts(const scene::Header& header, const Outputs& outputs, const map::Geoid& geoid) {
  if (const auto cylinder = scene::cylinder_of(header)) {
    return exporters::TilesetFacts{.to_earth = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1},
                                   .origin = header.origin,
                                   .cylinder_radius_m = cylinder->radius_m,
                                   .attributions = header.attributions};
  }
  return exporters::TilesetFacts{.to_earth = map::Globe(header.origin).to_earth(),
                                 .origin = header.origin,
                                 .geoid = outputs.geoid ? outputs.geoid->name : "",
                                 .geoid_height_m = map::height_m(geoid, {}),
                                 .attributions = header.attributions};
}

Result<std::vector<WrittenFile>> write_tiles3d(const scene::Scene& scene, const Outputs& outputs,
                                               const map::Geoid& geoid, const TextureChoice& textures, int threads,
                                               exporters::OutputFolder& folder, Report& report,
                                               const OnProgress& on_progress) {
  if (scene.chunks.empty()) return std::vector<WrittenFile>();
  if (!outputs.geoid && !scene::cylinder_of(scene.header)) report.add(Code::kNoGeoidHeight, {});

  const ContentMaker maker(scene.header, outputs, geoid, textures, threads);
  TreeWriter writer(scene, outputs, maker, threads, folder);
  Report repeated;  // what the tiles of .glb and USD count again
  Result<TilesetTile> root = writer.write(outputs.glb || outputs.usd ? repeated : report, on_progress);
  if (!root) return root.error();
  if (outputs.surroundings != AroundWish::kNo)
    if (const Result<Done> done = add_surroundings(scene, maker, folder, *root, writer.files); !done)
      return done.error();
  const exporters::TilesetFacts facts = tileset_facts(scene.header, outputs, geoid);
  for (const exporters::TilesetFile& file : exporters::encode_tileset(std::move(*root), facts)) {
    const auto bytes = exporters::bytes_of(file.json);
    if (const Result<Done> done = folder.write(file.name, bytes); !done) return done.error();
    writer.files.push_back({file.name, bytes.size()});
  }
  return std::move(writer.files);
}

}  // namespace citykiln::outputs
