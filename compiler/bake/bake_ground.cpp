#include "compiler/bake/bake_ground.h"

#include <utility>

#include "compiler/bake/ground_meshes.h"
#include "compiler/bake/skirt.h"

namespace citykiln::bake {

void bake_ground(Baking& baking, TileLevel& level, std::vector<Built> structures) {
  assert(level.cells.size() == level.seen.size());
  scene::LandCover& cover = level.cover;
  const std::size_t first_of_structures = cover.layouts.size();
  for (const Built& built : structures)
    for (const structures::MarkedMesh& marked : built.generated.marked) cover.layouts.push_back(marked.layout);
  Markings markings = lay_out_markings(cover, baking.texel_m());
  for (std::size_t c = 0; c < level.cells.size(); ++c) {
    const ground::GroundMesh& ground = level.cells[c];
    baking.certify(length(Vec2{ground.error_m, ground.border_error_m}), bounds_of(ground.mesh));
    std::vector<LayeredMesh> meshes = material_meshes(ground, cover, markings, baking.header, baking.tolerance_m);
    for (LayeredMesh& each : meshes) add_skirt(each.mesh, level.seen[c].skirt, level.seen[c].skirt_m);
    baking.take(std::move(meshes));
  }
  bake_structures(baking, structures, markings, first_of_structures);
  baking.tile.marking_atlas = std::move(markings.atlas);
}

}  // namespace citykiln::bake
