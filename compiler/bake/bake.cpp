#include "compiler/bake/bake.h"

#include <cassert>
#include <memory>

#include "compiler/bake/bake_level.h"
#include "compiler/bake/parts/bake_buildings.h"
#include "compiler/bake/tile_levels.h"
#include "compiler/bake/view_markings.h"
#include "compiler/contract/system/for_each_slot.h"
#include "compiler/scene/shown_chunk.h"

namespace citykiln::bake {
namespace {

std::shared_ptr<const PrototypeCache> cache_or_own(const scene::Header& header,
                                                   std::shared_ptr<const PrototypeCache> prototypes) {
  return prototypes ? std::move(prototypes) : std::make_shared<const PrototypeCache>(header);
}

}  // namespace

struct PreparedTile {
  const scene::Header& header;
  std::shared_ptr<const scene::Chunk> chunk;
  std::vector<TileLevel> levels;
  std::shared_ptr<const PrototypeCache> prototypes;
  std::size_t most_instances;
};

namespace {

std::shared_ptr<PreparedTile> with_buildings(PreparedTile&& prepared, int threads) {
  if (shows(prepared.header, scene::SceneLayer::kBuildings))
    generate_textured_buildings(prepared.header, *prepared.chunk, *prepared.prototypes, prepared.levels, threads);
  return std::make_shared<PreparedTile>(std::move(prepared));
}

PreparedTile prepared_tile(const scene::Header& header, const scene::Chunk& chunk, std::span<const double> tolerances_m,
                           int threads, KeptReferences kept, std::shared_ptr<const PrototypeCache> prototypes,
                           std::size_t most_instances) {
  std::shared_ptr<const scene::Chunk> shown = scene::shared_shown_chunk(header, chunk);
  std::vector<TileLevel> levels = levels_of(header, *shown, tolerances_m, threads, kept);
  return {header, std::move(shown), std::move(levels), cache_or_own(header, std::move(prototypes)), most_instances};
}

}  // namespace

std::shared_ptr<PreparedTile> prepare(const scene::Header& header, const scene::Chunk& chunk,
                                      std::span<const double> tolerances_m, int threads,
                                      std::shared_ptr<const PrototypeCache> prototypes, std::size_t most_instances) {
  return with_buildings(
      prepared_tile(header, chunk, tolerances_m, threads, KeptReferences::kNone, std::move(prototypes), most_instances),
      threads);
}

std::shared_ptr<PreparedTile> prepare_for_check(const scene::Header& header, const scene::Chunk& chunk,
                                                std::span<const double> tolerances_m, int threads,
                                                std::shared_ptr<const PrototypeCache> prototypes,
                                                std::size_t most_instances) {
  return with_buildings(
      prepared_tile(header, chunk, tolerances_m, threads, KeptReferences::kAll, std::move(prototypes), most_instances),
      threads);
}

ExpectedGround expected_ground_of(const PreparedTile& prepared, std::size_t level) {
  assert(level < prepared.levels.size());
  const TileLevel& own = prepared.levels[level];
  assert(own.shared && own.references.size() == own.cells.size() && "not baked yet, and prepared for a check");
  return {own.shared->graded, own.cover, own.references};
}

std::span<const ground::GroundMesh> ground_of(const PreparedTile& prepared, std::size_t level) {
  assert(level < prepared.levels.size());
  return prepared.levels[level].cells;
}

BakedTile bake_prepared(PreparedTile& prepared, std::size_t level, int threads, Report& report) {
  assert(level < prepared.levels.size() && prepared.levels[level].shared && "each level is baked once");
  TileLevel own = std::move(prepared.levels[level]);
  const LevelRequest request{.header = prepared.header,
                             .chunk = *prepared.chunk,
                             .part = nullptr,
                             .cell = nullptr,
                             .most_instances = prepared.most_instances};
  return bake_level(request, own, *prepared.prototypes, threads, report);
}

BakedTile bake(const scene::Header& header, const scene::Chunk& chunk, double tolerance_m, int threads, Report& report,
               std::shared_ptr<const PrototypeCache> prototypes) {
  return std::move(bake(header, chunk, std::span(&tolerance_m, 1), threads, report, std::move(prototypes)).front());
}

std::vector<BakedTile> bake(const scene::Header& header, const scene::Chunk& chunk,
                            std::span<const double> tolerances_m, int threads, Report& report,
                            std::shared_ptr<const PrototypeCache> prototypes) {
  struct Slot {
    BakedTile tile;
    Report report;
  };
  const std::shared_ptr<PreparedTile> prepared = prepare(header, chunk, tolerances_m, threads, std::move(prototypes));
  std::vector<Slot> slots = for_each_slot<Slot>(tolerances_m.size(), threads, [&](std::size_t i) {
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

std::vector<BakedTile> bake(const scene::Header& header, const scene::Chunk& all, const ViewLevels& view, int threads,
                            std::shared_ptr<const PrototypeCache> prototypes, std::size_t most_instances) {
  const std::shared_ptr<const scene::Chunk> shown = scene::shared_shown_chunk(header, all);
  const scene::Chunk& chunk = *shown;
  prototypes = cache_or_own(header, std::move(prototypes));
  const std::vector<int> parts = levels_of_parts(view, header, chunk);
  std::vector<TileLevel> levels = levels_for_view(header, chunk, view, parts, threads);
  const std::shared_ptr<const Markings> markings = markings_for_view(header, chunk, view, parts, levels);
  for (TileLevel& level : levels) level.markings = markings;
  return for_each_slot<BakedTile>(levels.size(), threads, [&](std::size_t i) {
    const TilePart part{view, parts, parts[i]};
    const LevelRequest request{.header = header,
                               .chunk = chunk,
                               .part = &part,
                               .cell = nullptr,
                               .most_instances = most_instances / levels.size()};
    Report ignored;
    return bake_level(request, levels[i], *prototypes, threads, ignored);
  });
}

}  // namespace citykiln::bake
