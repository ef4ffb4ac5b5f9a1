#include "compiler/verify/prepare_tile.h"

#include <algorithm>
#include <cassert>

namespace citykiln::verify {

Result<RecipesOfTile> prepare_tile(const LoadedRun& loaded, std::span<const outputs::WrittenTile> levels) {
  assert(!levels.empty() && std::ranges::all_of(levels, [&](const auto& w) { return w.tile == levels.front().tile; }));
  const scene::Scene& scene = loaded.scene;
  const auto chunk = std::ranges::find(scene.chunks, levels.front().tile, &scene::Chunk::tile);
  if (chunk == scene.chunks.end())
    return Error{loaded.folder + "/" + levels.front().file.name, "is a tile that the manifest does not contain"};
  std::vector<double> tolerances_m;
  for (const outputs::WrittenTile& level : levels) tolerances_m.push_back(level.tolerance_m);
  constexpr int kOneThread = 1;
  return RecipesOfTile{*chunk,
                       bake::prepare_for_check(scene.header, *chunk, tolerances_m, kOneThread, loaded.prototypes,
                                               outputs::most_instances_of(loaded.record.target))};
}

}  // namespace citykiln::verify
