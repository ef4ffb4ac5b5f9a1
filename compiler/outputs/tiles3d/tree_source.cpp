#include "compiler/outputs/tiles3d/tree_source.h"

#include <utility>

#include "compiler/contract/system/for_each_slot.h"
#include "compiler/outputs/tile_lights.h"
#include "compiler/outputs/write_tiles3d.h"
#include "exporters/run_files.h"

namespace citykiln::outputs {

Result<std::unique_ptr<TreeSource>> TreeSource::open(const scene::Scene& scene, const Outputs& outputs, int threads) {
  if (scene.chunks.empty()) return Error{"", "the scene has no tiles"};
  Result<map::Geoid> geoid = geoid_of(scene.header, outputs);
  if (!geoid) return geoid.error();
  const Result<std::vector<MaterialSet>> sets = sets_of(outputs);
  if (!sets) return sets.error();
  return std::unique_ptr<TreeSource>(new TreeSource(scene, outputs, std::move(*geoid), *sets, threads));
}

TreeSource::TreeSource(const scene::Scene& scene, const Outputs& outputs, map::Geoid geoid,
                       const std::vector<MaterialSet>& sets, int threads)
    : scene_(scene),
      outputs_(outputs),
      geoid_(std::move(geoid)),
      world_(scene.header, geoid_),
      textures_(outputs_, scene.header.seed, sets),
      threads_(threads),
      plan_(plan_tree(scene, outputs_, world_)),
      tree_{scene, outputs_, world_, plan_, textures_},
      prototypes_(std::make_shared<const bake::PrototypeCache>(scene.header)) {}

const std::optional<AroundContent>& TreeSource::around() const {
  std::call_once(around_once_, [&] {
    if (outputs_.surroundings != AroundWish::kNo) around_ = make_surroundings(tree_, threads_);
  });
  return around_;
}

const std::map<std::string, std::string>& TreeSource::documents() const {
  std::call_once(documents_once_, [&] {
    exporters::TilesetTile root = plan_.root;
    if (around()) root = with_surroundings(std::move(root), around()->tile);
    for (exporters::TilesetFile& file :
         exporters::encode_tileset(std::move(root), tileset_facts(scene_.header, outputs_, geoid_)))
      documents_.emplace(std::move(file.name), std::move(file.json));
  });
  return documents_;
}

bool TreeSource::has(std::string_view content) const {
  return plan_.contents.contains(std::string(content)) || (content == exporters::kSurroundingsContent && around());
}

Result<std::vector<std::byte>> TreeSource::make(const std::string& content) const {
  if (content == exporters::kSurroundingsContent) return around()->glb;
  const ContentOrigin& origin = plan_.contents.at(content);
  if (origin.of_tile) {
    const auto [chunk, level] = *origin.of_tile;
    return make_content(tree_, bake(chunk, plan_.levels_m[level]),
                        lights_of(scene_.header, scene_.chunks[chunk], outputs_.lights), threads_);
  }
  Result<bake::BakedTile> tile = inner_tile(origin.node);
  if (!tile) return tile.error();
  return make_content(tree_, std::move(*tile), {}, threads_);
}

bake::BakedTile TreeSource::bake(std::size_t chunk, double tolerance_m) const {
  Report ignored;
  return bake::bake(scene_.header, scene_.chunks[chunk], tolerance_m, threads_, ignored, prototypes_);
}

Result<bake::BakedTile> TreeSource::inner_tile(exporters::NodeKey key) const {
  const Result<std::vector<bake::BakedTile>> parts = parts_of(key);
  if (!parts) return parts.error();
  return make_inner_tile(tree_, key, *parts);
}

Result<std::vector<bake::BakedTile>> TreeSource::parts_of(exporters::NodeKey key) const {
  const InnerNode& node = plan_.nodes.at(key);
  if (const std::optional<double> bake_m = plan_.inner_level(key.height).bake_m)
    return for_each_slot<bake::BakedTile>(node.chunks.size(), threads_, [&](std::size_t i) {
      const std::size_t chunk = node.chunks[i];
      return make_part(tree_, key.height, scene_.chunks[chunk].tile, bake(chunk, *bake_m));
    });
  std::vector<bake::BakedTile> parts;
  for (const exporters::NodeKey child : node.children) {
    Result<bake::BakedTile> part = inner_tile(child);
    if (!part) return part.error();
    parts.push_back(std::move(*part));
  }
  return parts;
}

}  // namespace citykiln::outputs
