#include "compiler/bake/bake.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>

#include "compiler/bake/bake_buildings.h"
#include "compiler/bake/bake_ground.h"
#include "compiler/bake/bake_instances.h"
#include "compiler/bake/bake_structures.h"
#include "compiler/bake/baking.h"
#include "compiler/bake/clip_to_extent.h"
#include "compiler/bake/image_uvs.h"
#include "compiler/bake/merge.h"
#include "compiler/bake/tile_levels.h"
#include "compiler/contract/detail_tolerances.h"
#include "compiler/contract/for_each_slot.h"

namespace citykiln::bake {
namespace {

// Frees each mesh when it is merged, so that no tile is held twice.
void merge_meshes(Baking& baking) {
  PrimitiveMap merged;
  for (LayeredMesh& each : baking.meshes) {
    const LayeredMesh part = std::move(each);
    merge(merged, part, baking.tile.origin, number_of(baking.tile, part.mesh.feature));
  }
  baking.meshes.clear();
  baking.tile.primitives = primitives_of(std::move(merged));
}

// Whole metres, at the height of the lowest ground, which keeps offsets small.
Vec3 origin_of(const Box2& box, const map::Heightfield& heights) {
  const auto lowest = std::min_element(heights.heights.begin(), heights.heights.end());
  return {box.min.x, box.min.y, std::floor(*lowest * map::kHeightQuantum_m)};
}

// The barriers that are bands. Hedges are bands where they are not plants, whole, in the tile of their first point.
std::vector<props::Barrier> bands_of(const Baking& baking) {
  std::vector<props::Barrier> bands = baking.chunk.barriers;
  const bool has_plants = baking.part || has_detail(Detail::kHedgePlants, baking.tolerance_m);
  std::erase_if(bands, [&](const props::Barrier& b) {
    const bool is_band = !has_plants && scene::is_anchored(baking.header, baking.chunk.tile, b.axis.front());
    return b.kind == map::BarrierKind::kHedge && !is_band;
  });
  return bands;
}

// A barrier, clipped to the extent and closed there.
props::GeneratedProp generate_within(const props::Barrier& barrier, const ground::GradedTerrain& graded,
                                     double tolerance_m, const Box2& extent) {
  props::GeneratedProp generated = props::generate(barrier, graded, tolerance_m);
  std::vector<MaterialMesh*> meshes;
  for (MaterialMesh& mesh : generated.meshes) meshes.push_back(&mesh);
  Mesh caps = clip_solid_to_extent(meshes, extent);
  if (!caps.triangles.empty()) {
    const MaterialMesh& band = generated.meshes.front();
    generated.meshes.push_back({std::move(caps), band.material, band.tint, band.feature});
  }
  std::erase_if(generated.meshes, [](const MaterialMesh& mesh) { return mesh.mesh.triangles.empty(); });
  return generated;
}

BakedTile bake_level(const scene::Header& header, const scene::Chunk& chunk, TileLevel& level, const TilePart* part,
                     const PrototypeCache& prototypes, std::size_t most_instances, int threads, Report& report) {
  const double tolerance_m = level.tolerance_m;
  const SharedByLevels& shared = *level.shared;
  BakedTile tile{.tile = chunk.tile,
                 .origin = origin_of(scene::box_of(header, chunk.tile), chunk.heights),
                 .tolerance_m = tolerance_m};
  if (part) tile.viewpoint = Viewpoint{part->levels.view.eye, part->levels.view.focal_px, 0};
  Baking baking{header, chunk, tolerance_m, tile, part};

  std::vector<Built> structures = generate_structures(baking, report);
  report.append(level.cell_report);
  bake_ground(baking, level, std::move(structures));
  bake_stairs(baking, shared.stairs);
  bake_buildings(baking, level, prototypes.rulebook(), threads, report);
  bake_each(
      baking, Layer::kProps, bands_of(baking), "barrier", report,
      [&](const auto& b) { return bounds_of(b, chunk.heights); },
      [&](const auto& b) { return generate_within(b, shared.graded, tolerance_m, header.region); });
  report.append(shared.tree_report);
  bake_tree_pits(baking, shared);
  Placed placed = placed_in(baking, shared);
  bake_canopy(baking, level, placed);
  name_placed(baking, placed);

  tile.features.assign(baking.features.begin(), baking.features.end());
  tile.attributes = attributes_of(chunk, tile.features);
  merge_meshes(baking);
  bake_lamps(baking, placed.lamps, shared.graded, report);
  bake_trees(baking, placed, prototypes, most_instances);
  snap_image_uvs(tile);
  tile.textures = textures_shown(tile, baking.texel_m(), prototypes.textures());
  return tile;
}

std::shared_ptr<const PrototypeCache> cache_or_own(const scene::Header& header,
                                                   std::shared_ptr<const PrototypeCache> prototypes) {
  return prototypes ? std::move(prototypes) : std::make_shared<const PrototypeCache>(header);
}

}  // namespace

struct PreparedTile {
  const scene::Header& header;
  const scene::Chunk& chunk;
  std::vector<TileLevel> levels;
  std::shared_ptr<const PrototypeCache> prototypes;
  std::size_t most_instances;
};

std::shared_ptr<PreparedTile> prepare(const scene::Header& header, const scene::Chunk& chunk,
                                      std::span<const double> ladder_m, int threads,
                                      std::shared_ptr<const PrototypeCache> prototypes, std::size_t most_instances) {
  PreparedTile prepared{header, chunk, levels_of(header, chunk, ladder_m, threads), cache_or_own(header, prototypes),
                        most_instances};
  generate_textured_buildings(header, chunk, prepared.prototypes->rulebook(), prepared.levels, threads);
  return std::make_shared<PreparedTile>(std::move(prepared));
}

std::span<const ground::GroundMesh> ground_of(const PreparedTile& prepared, std::size_t level) {
  assert(level < prepared.levels.size());
  return prepared.levels[level].cells;
}

BakedTile bake_prepared(PreparedTile& prepared, std::size_t level, int threads, Report& report) {
  assert(level < prepared.levels.size() && prepared.levels[level].shared && "each level is baked once");
  TileLevel own = std::move(prepared.levels[level]);
  return bake_level(prepared.header, prepared.chunk, own, nullptr, *prepared.prototypes, prepared.most_instances,
                    threads, report);
}

BakedTile bake(const scene::Header& header, const scene::Chunk& chunk, double tolerance_m, int threads, Report& report,
               std::shared_ptr<const PrototypeCache> prototypes) {
  return std::move(bake(header, chunk, std::span(&tolerance_m, 1), threads, report, std::move(prototypes)).front());
}

std::vector<BakedTile> bake(const scene::Header& header, const scene::Chunk& chunk, std::span<const double> ladder_m,
                            int threads, Report& report, std::shared_ptr<const PrototypeCache> prototypes) {
  struct Slot {
    BakedTile tile;
    Report report;
  };
  const std::shared_ptr<PreparedTile> prepared = prepare(header, chunk, ladder_m, threads, std::move(prototypes));
  std::vector<Slot> slots = for_each_slot<Slot>(ladder_m.size(), threads, [&](std::size_t i) {
    Slot slot;
    slot.tile = bake_prepared(*prepared, i, threads, slot.report);
    return slot;
  });
  std::vector<BakedTile> tiles;
  for (Slot& slot : slots) {
    report.append(slot.report);
    tiles.push_back(std::move(slot.tile));
  }
  return tiles;
}

std::vector<BakedTile> bake(const scene::Header& header, const scene::Chunk& chunk, const ViewLevels& view, int threads,
                            std::shared_ptr<const PrototypeCache> prototypes, std::size_t most_instances) {
  prototypes = cache_or_own(header, std::move(prototypes));
  const std::vector<int> parts = levels_of_parts(view, header, chunk);
  std::vector<TileLevel> levels = levels_for_view(header, chunk, view, parts, threads);
  return for_each_slot<BakedTile>(levels.size(), threads, [&](std::size_t i) {
    const TilePart part{view, parts, parts[i]};
    Report ignored;
    return bake_level(header, chunk, levels[i], &part, *prototypes, most_instances / levels.size(), threads, ignored);
  });
}

}  // namespace citykiln::bake
