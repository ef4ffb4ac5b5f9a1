#include "compiler/bake/bake_ground.h"

#include <algorithm>
#include <span>
#include <utility>

#include "compiler/bake/ground/ground_meshes.h"
#include "compiler/bake/ground/skirt.h"

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

Markings markings_of(const TileLevel& level, const std::vector<GeneratedSpan>& structures, double texel_m) {
  std::vector<roads::MarkingLayout> layouts = level.cover->layouts;
  const std::vector<roads::MarkingLayout> more = layouts_of(structures);
  layouts.insert(layouts.end(), more.begin(), more.end());
  return lay_out_markings(layouts, texel_m);
}

bool shows_markings(const Baking& baking) {
  return std::ranges::any_of(baking.meshes, [](const LayeredMesh& each) {
    return each.mesh.colour_source == materials::ColourSource::kByMarkingAtlas;
  });
}

}  // namespace

void bake_ground(Baking& baking, const TileLevel& level, std::vector<GeneratedSpan> structures) {
  Markings own;
  if (!level.markings) own = markings_of(level, structures, baking.texel_m());
  const Markings& markings = level.markings ? *level.markings : own;
  bake_cells(baking, level.cells, level.seen, *level.cover, markings);
  bake_cells(baking, level.beyond, level.seen_beyond, *level.cover, markings);
  bake_structures(baking, structures, markings);
  if (!level.markings)
    baking.tile.marking_atlas = std::move(own.atlas);
  else if (!baking.cell && shows_markings(baking))
    baking.tile.marking_atlas = markings.atlas;
}

}  // namespace citykiln::bake
