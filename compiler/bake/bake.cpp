#include "compiler/bake/bake.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "compiler/bake/dress_ground.h"
#include "compiler/bake/fire_houses.h"
#include "compiler/bake/fire_placed.h"
#include "compiler/bake/fire_structures.h"
#include "compiler/bake/firing.h"
#include "compiler/bake/levels.h"
#include "compiler/bake/merge.h"
#include "compiler/bake/skirt.h"
#include "compiler/contract/for_each_slot.h"

namespace citykiln::bake {
namespace {

void fire_ground(Firing& firing, Level& level, std::vector<Built> structures) {
  scene::GroundCover& cover = level.cover;
  const std::size_t first_of_structures = cover.patterns.size();
  for (const Built& built : structures)
    for (const structures::MarkedMesh& marked : built.expanded.marked) cover.patterns.push_back(marked.pattern);
  Markings markings = lay_out_markings(cover, firing.texel_m());
  for (std::size_t c = 0; c < level.cells.size(); ++c) {
    const ground::GroundMesh& ground = level.cells[c];
    firing.certify(length(Vec2{ground.error_m, ground.border_error_m}), bounds_of(ground.mesh));
    std::vector<DressedMesh> dressed = dress(ground, cover, markings, firing.header, firing.tolerance_m);
    for (DressedMesh& mesh : dressed) hang_skirt(mesh, level.seen[c].skirt, level.seen[c].skirt_m);
    firing.take(std::move(dressed));
  }
  fire_structures(firing, structures, markings, first_of_structures);
  firing.tile.sheet = std::move(markings.sheet);
}

// each mesh goes when it is merged: a tile is never there twice
void merge_meshes(Firing& firing) {
  Merged merged;
  for (DressedMesh& each : firing.meshes) {
    const DressedMesh mesh = std::move(each);
    merge(merged, mesh, firing.tile.origin, number_of(firing.tile, mesh.feature));
  }
  firing.meshes.clear();
  firing.tile.primitives = primitives_of(std::move(merged));
}

// Whole metres; the height of the lowest ground keeps offsets small.
Vec3 origin_of(const Box2& box, const map::Heightfield& heights) {
  const auto lowest = std::min_element(heights.heights.begin(), heights.heights.end());
  return {box.min.x, box.min.y, std::floor(*lowest * map::kHeightQuantum_m)};
}

// Near by, hedges are plants; else bands like others, whole, of the tile that they begin in.
std::vector<props::Barrier> bands_of(const Firing& firing) {
  std::vector<props::Barrier> bands = firing.chunk.barriers;
  const bool has_plants = firing.part || has_hedge_plants(firing.tolerance_m);
  std::erase_if(bands, [&](const props::Barrier& b) {
    const bool is_band = !has_plants && scene::is_anchored(firing.header, firing.chunk.tile, b.axis.front());
    return b.kind == map::BarrierKind::kHedge && !is_band;
  });
  return bands;
}

BakedTile fire_level(const scene::Header& header, const scene::Chunk& chunk, Level& level, const TilePart* part,
                     const Grove& grove, int threads, Report& report) {
  const double tolerance_m = level.tolerance_m;
  const Common& common = *level.common;
  BakedTile tile{chunk.tile, origin_of(scene::box_of(header, chunk.tile), chunk.heights), tolerance_m, 0, {}, {}, {}};
  if (part) tile.seen_from = SeenFrom{part->levels.view.eye, part->levels.view.focal_px, 0};
  Firing firing{header, chunk, tolerance_m, tile, part};

  std::vector<Built> structures = expand_structures(firing, report);
  report.append(level.of_cells);
  fire_ground(firing, level, std::move(structures));
  fire_stairs(firing, common.stairs);
  fire_houses(firing, level, threads, report);
  fire_each(
      firing, bands_of(firing), "barrier", report, [&](const auto& b) { return bounds_of(b, chunk.heights); },
      [&](const auto& b) { return props::expand(b, common.carving, tolerance_m); });
  report.append(common.of_trees);
  fire_pits(firing, common);
  Placed placed = placed_in(firing, common);
  fire_canopy(firing, common, placed);
  name_placed(firing, placed);

  tile.features.assign(firing.features.begin(), firing.features.end());
  merge_meshes(firing);
  fire_trees(firing, placed.trees, grove);
  fire_lamps(firing, placed.lamps, common.carving, report);
  tile.textures = textures_shown(tile, firing.texel_m(), grove.textures());
  return tile;
}

std::shared_ptr<const Grove> grove_or_own(const scene::Header& header, std::shared_ptr<const Grove> grove) {
  return grove ? std::move(grove) : std::make_shared<const Grove>(header);
}

}  // namespace

struct PreparedTile {
  const scene::Header& header;
  const scene::Chunk& chunk;
  std::vector<Level> levels;
  std::shared_ptr<const Grove> grove;
};

std::shared_ptr<PreparedTile> prepare(const scene::Header& header, const scene::Chunk& chunk,
                                      std::span<const double> ladder_m, int threads,
                                      std::shared_ptr<const Grove> grove) {
  PreparedTile prepared{header, chunk, levels_of(header, chunk, ladder_m, threads), grove_or_own(header, grove)};
  expand_imprinted(header, chunk, prepared.levels, threads);
  return std::make_shared<PreparedTile>(std::move(prepared));
}

std::span<const ground::GroundMesh> ground_of(const PreparedTile& prepared, std::size_t level) {
  return prepared.levels[level].cells;
}

BakedTile fire_prepared(PreparedTile& prepared, std::size_t level, int threads, Report& report) {
  Level own = std::move(prepared.levels[level]);
  return fire_level(prepared.header, prepared.chunk, own, nullptr, *prepared.grove, threads, report);
}

BakedTile bake(const scene::Header& header, const scene::Chunk& chunk, double tolerance_m, int threads, Report& report,
               std::shared_ptr<const Grove> grove) {
  return std::move(bake(header, chunk, std::span(&tolerance_m, 1), threads, report, std::move(grove)).front());
}

std::vector<BakedTile> bake(const scene::Header& header, const scene::Chunk& chunk, std::span<const double> ladder_m,
                            int threads, Report& report, std::shared_ptr<const Grove> grove) {
  struct Slot {
    BakedTile tile;
    Report report;
  };
  const std::shared_ptr<PreparedTile> prepared = prepare(header, chunk, ladder_m, threads, std::move(grove));
  std::vector<Slot> slots = for_each_slot<Slot>(ladder_m.size(), threads, [&](std::size_t i) {
    Slot slot;
    slot.tile = fire_prepared(*prepared, i, threads, slot.report);
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
                            std::shared_ptr<const Grove> grove) {
  grove = grove_or_own(header, std::move(grove));
  const std::vector<double> tolerances_m = tolerances_of(view, header, chunk);
  std::vector<Level> levels = levels_seen(header, chunk, view, tolerances_m, threads);
  return for_each_slot<BakedTile>(levels.size(), threads, [&](std::size_t i) {
    const TilePart part{view, tolerances_m, tolerances_m[i]};
    Report ignored;
    return fire_level(header, chunk, levels[i], &part, *grove, threads, ignored);
  });
}

}  // namespace citykiln::bake
