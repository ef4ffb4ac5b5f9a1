#include "compiler/outputs/write_tiles3d.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "compiler/bake_scene.h"
#include "compiler/outputs/tile_lights.h"
#include "compiler/outputs/tiles3d/make_content.h"
#include "compiler/outputs/tiles3d/tree_sink.h"
#include "exporters/run_files.h"
#include "exporters/tiles3d/tileset.h"

namespace citykiln::outputs {
namespace {

using exporters::NodeKey;
using Lights = std::vector<bake::PlacedLamp>;

/// Bakes a scene and writes the contents of its tile tree, each as soon as all that it is made of is baked.
class TreeWriter {
 public:
  TreeWriter(const TreeContents& tree, int threads, TreeSink& sink)
      : tree_(tree),
        plan_(tree.plan),
        threads_(threads),
        sink_(sink),
        lights_(lights_of_tiles(tree.scene, tree.outputs.lights, threads)),
        slots_(tree.scene.chunks.size() * plan_.levels_m.size()) {}

  Result<Done> write(Report& report, const OnProgress& on_progress) {
    return bake_scene(tree_.scene, plan_.levels_m, threads_, report, on_progress,
                      {.exists = [](ChunkLevel) { return false; },
                       .process = [&](ChunkLevel at, bake::BakedTile&& tile) { process(at, std::move(tile)); },
                       .take = [&](ChunkLevel at, const Report&) { return take(at); }});
  }

 private:
  /// A baked tile at one level: its content, and the tile itself if inner tiles are made of it.
  struct Slot {
    std::vector<std::byte> glb;
    std::optional<bake::BakedTile> coarse;
  };

  Slot& slot(ChunkLevel at) { return slots_[at.chunk * plan_.levels_m.size() + at.level]; }

  void process(ChunkLevel at, bake::BakedTile&& tile) {
    const auto inner = std::ranges::find(plan_.inner, plan_.levels_m[at.level], &InnerLevel::bake_m);
    if (inner != plan_.inner.end()) {
      const auto height = static_cast<int>(inner - plan_.inner.begin()) + 1;
      slot(at).coarse = make_part(tree_, height, tree_.scene.chunks[at.chunk].tile, bake::BakedTile(tile));
    }
    if (at.level < plan_.own_levels) slot(at).glb = make_content(tree_, std::move(tile), lights_[at.chunk], threads_);
  }

  /// Writes a tile's level. The last level completes the tile.
  Result<Done> take(ChunkLevel at) {
    const scene::TileKey tile = tree_.scene.chunks[at.chunk].tile;
    if (at.level < plan_.own_levels) {
      const std::vector<std::byte> glb = std::exchange(slot(at).glb, {});
      if (const Result<Done> done = sink_.put(content_name(tile, at.level), glb); !done) return done;
    }
    if (at.level + 1 < plan_.levels_m.size()) return Done{};
    keep_coarse(at.chunk);
    return complete(exporters::leaf_of(plan_.tree, tile));
  }

  /// Hands the coarse levels of a tile to the inner nodes above it.
  void keep_coarse(std::size_t chunk) {
    NodeKey key = exporters::leaf_of(plan_.tree, tree_.scene.chunks[chunk].tile);
    for (const InnerLevel& inner : plan_.inner) {
      key = exporters::parent_of(key);
      if (!inner.bake_m) continue;
      const auto level =
          static_cast<std::size_t>(std::ranges::find(plan_.levels_m, *inner.bake_m) - plan_.levels_m.begin());
      parts_[key].push_back(*slot({chunk, level}).coarse);
    }
    for (std::size_t level = 0; level < plan_.levels_m.size(); ++level) slot({chunk, level}).coarse.reset();
  }

  /// Counts a finished node at its parent, which is made if this was its last child.
  Result<Done> complete(NodeKey key) {
    if (key == plan_.tree.root) return Done{};
    const NodeKey above = exporters::parent_of(key);
    if (++finished_[above] < plan_.tree.children.at(above)) return Done{};
    if (const Result<Done> done = make_node(above); !done) return done;
    return complete(above);
  }

  Result<Done> make_node(NodeKey key) {
    Result<bake::BakedTile> inner = make_inner_tile(tree_, key, std::move(parts_.extract(key).mapped()));
    if (!inner) return inner.error();
    if (key != plan_.tree.root && !plan_.inner_level(exporters::parent_of(key).height).bake_m)
      parts_[exporters::parent_of(key)].push_back(*inner);
    return sink_.put(content_name(key), make_content(tree_, std::move(*inner), {}, threads_));
  }

  const TreeContents& tree_;
  const TreePlan& plan_;
  int threads_;
  TreeSink& sink_;
  std::vector<Lights> lights_;                             ///< By chunk.
  std::vector<Slot> slots_;                                ///< By chunk and level.
  std::map<NodeKey, std::vector<bake::BakedTile>> parts_;  ///< The tiles that inner nodes are joined from.
  std::map<NodeKey, std::size_t> finished_;                ///< The number of finished children of inner nodes.
};

/// The name of a document relative to tileset.json.
std::string name_in_tileset(const exporters::TilesetFile& file) {
  return file.name.substr(std::string_view(exporters::kTilesetFolder).size() + 1);
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

  const TreeWorld world(scene.header, geoid);
  const TreePlan plan = plan_tree(scene, outputs, world);
  const TreeContents tree{scene, outputs, world, plan, textures};
  Result<TreeSink> sink = TreeSink::open(outputs, folder);
  if (!sink) return sink.error();
  TreeWriter writer(tree, threads, *sink);
  Report repeated;  // what the tiles of .glb and USD count again
  if (const auto done = writer.write(outputs.glb || outputs.usd ? repeated : report, on_progress); !done)
    return done.error();
  exporters::TilesetTile root = plan.root;
  if (outputs.surroundings != AroundWish::kNo)
    if (std::optional<AroundContent> around = make_surroundings(tree, threads)) {
      if (const Result<Done> done = sink->put(around->tile.content, around->glb); !done) return done.error();
      root = with_surroundings(std::move(root), std::move(around->tile));
    }
  const exporters::TilesetFacts facts = tileset_facts(scene.header, outputs, geoid);
  for (const exporters::TilesetFile& file : exporters::encode_tileset(std::move(root), facts))
    if (const Result<Done> done = sink->put(name_in_tileset(file), exporters::bytes_of(file.json)); !done)
      return done.error();
  return sink->finish();
}

}  // namespace citykiln::outputs
