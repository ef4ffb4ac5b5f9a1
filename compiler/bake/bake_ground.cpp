#include "compiler/bake/bake_ground.h"

#include <span>
#include <utility>

#include "compiler/bake/ground_meshes.h"
#include "compiler/bake/skirt.h"

namespace citykiln::bake {

namespace {

void bake_cells(Baking& baking, std::span<const ground::GroundMesh> cells, std::span<const ViewCell> seen,
                const scene::LandCover& cover, const Markings& markings) {
  assert(cells.size() == seen.size());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const ground::GroundMesh& ground = cells[c];
    baking.certify(length(Vec2{ground.error_m, ground.border_error_m}), bounds_of(ground.mesh));
    std::vector<LayeredMesh> meshes = material_meshes(ground, cover, markings, baking.header, baking.tolerance_m);
    for (LayeredMesh& each : meshes) add_skirt(each.mesh, seen[c].skirt, seen[c].skirt_m);
    baking.take(std::move(meshes));
  }
}

}  // namespace

void bake_ground(Baking& baking, TileLevel& level, std::vector<Built> structures) {
  scene::LandCover& cover = level.cover;
  const std::size_t first_of_structures = cover.layouts.size();
  for (const Built& built : structures)
    for (const structures::MarkedMesh& marked : built.generated.marked) cover.layouts.push_back(marked.layout);
  Markings markings = lay_out_markings(cover, baking.texel_m());
  bake_cells(baking, level.cells, level.seen, cover, markings);
  bake_cells(baking, level.beyond, level.seen_beyond, cover, markings);
  bake_structures(baking, structures, markings, first_of_structures);
  baking.tile.marking_atlas = std::move(markings.atlas);
}

}  // namespace citykiln::bake
