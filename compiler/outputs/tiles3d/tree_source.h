// Makes the tile tree of a scene content by content, on request. Nothing is written.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/bake/prototype_cache.h"
#include "compiler/outputs/texture_choice.h"
#include "compiler/outputs/tiles3d/make_content.h"
#include "compiler/outputs/tiles3d/plan_tree.h"

namespace citykiln::outputs {

/// A scene whose tree of tiles is made as it is asked for. All functions may be called from several threads at once.
class TreeSource {
 public:
  /// Errors: a geoid or a folder of materials that cannot be read; a scene without tiles.
  /// @param scene  Must outlive the result.
  static Result<std::unique_ptr<TreeSource>> open(const scene::Scene& scene, const Outputs& outputs, int threads);

  /// Returns the texts of the tileset's JSON files by their names in a run: "3dtiles/tileset.json". They equal those of
  /// write_tiles3d(). Cost: the first call bakes the land around, if it is wanted, in half a second; later calls are
  /// free.
  const std::map<std::string, std::string>& documents() const;
  /// Tests whether a name, relative to 3dtiles/, is that of a content: "3_-2_L0.glb". O(log n); the name of the land
  /// around (exporters::kSurroundingsContent) bakes it once, in half a second.
  bool has(std::string_view content) const;
  /// The name of the content that is shown first: the coarsest one of the whole scene.
  const std::string& first_content() const { return plan_.root.content; }
  /// Returns a content with the bytes that write_tiles3d() writes. Cost: baking it. Errors: those of
  /// bake::join_tiles().
  /// @param content  A name for which has() is true.
  Result<std::vector<std::byte>> make(const std::string& content) const;

  /// A hash of the textures that replace those of citykiln; 0 if none do.
  std::uint64_t textures_hash() const { return textures_.hash(); }

 private:
  TreeSource(const scene::Scene& scene, const Outputs& outputs, map::Geoid geoid, const std::vector<MaterialSet>& sets,
             int threads);
  bake::BakedTile bake(std::size_t chunk, double tolerance_m) const;
  Result<bake::BakedTile> inner_tile(exporters::NodeKey key) const;
  Result<std::vector<bake::BakedTile>> parts_of(exporters::NodeKey key) const;
  const std::optional<AroundContent>& around() const;

  const scene::Scene& scene_;
  Outputs outputs_;
  map::Geoid geoid_;
  TreeWorld world_;
  TextureChoice textures_;
  int threads_;
  TreePlan plan_;
  TreeContents tree_;
  std::shared_ptr<const bake::PrototypeCache> prototypes_;

  // made when they are first asked for
  mutable std::once_flag around_once_, documents_once_;
  mutable std::optional<AroundContent> around_;
  mutable std::map<std::string, std::string> documents_;
};

}  // namespace citykiln::outputs
