#include "compiler/bake_scene.h"

#include <algorithm>
#include <cassert>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "compiler/contract/system/for_each_slot.h"
#include "compiler/contract/system/once.h"

namespace citykiln {
namespace {

/// One step of baking: a tile at a level, or the preparation that all levels of the tile share (no level).
struct BakeStep {
  std::size_t tile = 0;
  std::optional<std::size_t> level;
  bool exists = false;  ///< There is nothing to do.
};

/// Returns all steps in order. Levels of a tile are separate steps, so none waits for the others. Each tile is prepared
/// while the tile before it is baked.
std::vector<BakeStep> bake_steps(const scene::Scene& scene, std::size_t levels, const ExistsTile& exists) {
  std::vector<BakeStep> steps;
  const auto preparation = [&](std::size_t tile) {
    bool all_exist = true;
    for (std::size_t level = 0; level < levels; ++level) all_exist = all_exist && exists({tile, level});
    return BakeStep{tile, std::nullopt, all_exist};
  };
  const std::size_t tiles = scene.chunks.size();
  for (std::size_t tile = 0; tile < tiles; ++tile) {
    if (tile == 0) steps.push_back(preparation(tile));
    if (tile + 1 < tiles) steps.push_back(preparation(tile + 1));
    for (std::size_t level = 0; level < levels; ++level) steps.push_back({tile, level, exists({tile, level})});
  }
  return steps;
}

struct TileInFlight {
  Once once;
  std::shared_ptr<bake::PreparedTile> prepared;
};

}  // namespace

Result<Done> bake_scene(const scene::Scene& scene, std::span<const double> tolerances_m, int threads, Report& report,
                        const OnProgress& on_progress, const TileHandlers& handlers, std::size_t most_instances) {
  assert(!tolerances_m.empty() && tolerances_m.front() > 0 && std::ranges::is_sorted(tolerances_m));
  const std::vector<BakeStep> steps = bake_steps(scene, tolerances_m.size(), handlers.exists);
  std::vector<Report> reports(steps.size());
  std::vector<TileInFlight> in_flight(scene.chunks.size());
  Result<Done> done = Done{};
  const auto prototypes = std::make_shared<const bake::PrototypeCache>(scene.header);
  const auto make = [&](std::size_t i) {
    TileInFlight& tile = in_flight[steps[i].tile];
    if (steps[i].exists) return;
    // the first thread that needs the tile prepares it; other threads join that work
    tile.once.call([&] {
      tile.prepared =
          bake::prepare(scene.header, scene.chunks[steps[i].tile], tolerances_m, threads, prototypes, most_instances);
    });
    if (!steps[i].level) return;
    const ChunkLevel at{steps[i].tile, *steps[i].level};
    handlers.process(at, bake::bake_prepared(*tile.prepared, at.level, threads, reports[i]));
  };
  const auto hand_on = [&](std::size_t i) {
    if (!steps[i].level) return true;
    if (*steps[i].level + 1 == tolerances_m.size()) in_flight[steps[i].tile].prepared.reset();
    const Report diagnosed = std::exchange(reports[i], {});
    report.append(diagnosed);
    done = handlers.take({steps[i].tile, *steps[i].level}, diagnosed);
    on_progress("bake", static_cast<double>(i + 1) / static_cast<double>(steps.size()));
    return static_cast<bool>(done);
  };
  for_each_in_order(steps.size(), threads, make, hand_on);
  return done;
}

Result<Done> bake_scene(const scene::Scene& scene, std::span<const double> tolerances_m, int threads, Report& report,
                        const OnProgress& on_progress, const OnBakedTile& take, std::size_t most_instances) {
  std::vector<std::optional<bake::BakedTile>> slots(scene.chunks.size() * tolerances_m.size());
  const auto slot = [&](ChunkLevel at) -> auto& { return slots[at.chunk * tolerances_m.size() + at.level]; };
  return bake_scene(scene, tolerances_m, threads, report, on_progress,
                    {.exists = [](ChunkLevel) { return false; },
                     .process = [&](ChunkLevel at, bake::BakedTile&& tile) { slot(at) = std::move(tile); },
                     .take =
                         [&](ChunkLevel at, const Report&) {
                           const bake::BakedTile tile = *std::exchange(slot(at), std::nullopt);
                           return take(tile, at.level);
                         }},
                    most_instances);
}

std::vector<bake::BakedTile> bake_tiles(const scene::Scene& scene, double tolerance_m, int threads) {
  std::vector<bake::BakedTile> tiles(scene.chunks.size());
  Report ignored;
  [[maybe_unused]] const Result<Done> done =
      bake_scene(scene, std::span(&tolerance_m, 1), threads, ignored, [](std::string_view, double) {},
                 {.exists = [](ChunkLevel) { return false; },
                  .process = [&](ChunkLevel at, bake::BakedTile&& tile) { tiles[at.chunk] = std::move(tile); },
                  .take = [](ChunkLevel, const Report&) -> Result<Done> { return Done{}; }});
  assert(done);
  return tiles;
}

}  // namespace citykiln
