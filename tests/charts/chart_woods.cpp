// Time of placing a map's plants over their number, for parts of the map.
#include <fmt/format.h>

#include <ctime>
#include <set>

#include "compiler/contract/system/for_each_slot.h"
#include "compiler/plants/generate.h"
#include "compiler/scene/graded_terrain.h"
#include "compiler/scene/land_cover.h"
#include "compiler/stage_timer.h"
#include "tests/charts/chart.h"

namespace citykiln::charts {
namespace {

/// Levels from half a metre on have no kerbs.
constexpr double kTerrainTolerance_m = 0.5;

struct Woods {
  double plants = 0, expand_seconds = 0;
  std::set<plants::Species> species;
};

/// Places the plants of one tile. The time excludes preparing the ground, which other objects need too.
Woods woods_of(const scene::Header& header, const scene::Chunk& chunk) {
  const Box2 box = scene::box_of(header, chunk.tile);
  const std::vector<ground::LandCoverPolygon> surfaces = scene::coarse_land_cover(chunk);
  const ground::LandCoverIndex map = ground::index_land_cover(surfaces, box.widened(scene::kHalo_m));
  const ground::GradedTerrain graded = scene::graded_terrain_of(header, chunk, kTerrainTolerance_m);
  Report ignored;
  Woods woods;
  timespec begin, end;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &begin);
  const plants::GeneratedPlants generated =
      plants::generate({chunk.trees, chunk.woods, chunk.plantings, chunk.tree_rows, chunk.corridors},
                       {map, graded, box, header.seed, header.origin.lat_deg, header.climate}, ignored);
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &end);
  woods.expand_seconds =
      static_cast<double>(end.tv_sec - begin.tv_sec) + static_cast<double>(end.tv_nsec - begin.tv_nsec) * 1e-9;
  for (const auto& [prototype, placements] : generated.placed) {
    woods.plants += static_cast<double>(placements.size());
    woods.species.insert(prototype.species);
  }
  return woods;
}

Woods sum_of(std::span<const Woods> tiles) {
  Woods sum;
  for (const Woods& tile : tiles) {
    sum.plants += tile.plants, sum.expand_seconds += tile.expand_seconds;
    sum.species.insert(tile.species.begin(), tile.species.end());
  }
  return sum;
}

}  // namespace

Result<std::vector<Chart>> chart_woods(const ChartRequest& request) {
  const Result<scene::Scene> scene = compile_first_map(request);
  if (!scene) return scene.error();
  StageTimer timer([](std::string_view, double) {});
  timer.enter("woods");
  const std::vector<Woods> tiles = for_each_slot<Woods>(
      scene->chunks.size(), request.threads, [&](std::size_t i) { return woods_of(scene->header, scene->chunks[i]); });
  const StageCost cost = timer.finish().front();
  const Woods all = sum_of(tiles);
  Chart chart;
  chart.name = "woods";
  chart.title = fmt::format(
      "{:.0f} plants of {} species: {:.1f} processor seconds; {:.1f} s and {:.0f} MB with the ground", all.plants,
      all.species.size(), all.expand_seconds, cost.seconds, static_cast<double>(cost.peak_bytes) * 1e-6);
  chart.x = {"plants", true}, chart.y = {"processor seconds", true};
  Series series{"woods", {}, false};
  for (const std::size_t share : {16, 8, 4, 2, 1}) {
    const Woods part = sum_of(std::span(tiles).first(tiles.size() / share));
    if (part.plants > 0) series.points.emplace_back(part.plants, part.expand_seconds);
  }
  chart.series.push_back(std::move(series));
  return std::vector{chart};
}

}  // namespace citykiln::charts
