// Compiles and bakes the scene that a chart measures.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "compiler/bake_scene.h"
#include "compiler/charts/chart.h"
#include "compiler/pipeline.h"

namespace citykiln::charts {

Result<scene::Scene> compile_first_map(const ChartRequest& request) {
  if (request.maps.empty())
    return Error{"chart", fmt::format("{} needs a map (--map FILE)", fmt::join(request.names, ", "))};
  CompileSpec spec;
  spec.map_path = request.maps.front();
  spec.threads = request.threads;
  spec.rasters = request.rasters;
  Result<CompileResult> compiled = compile(spec, [](std::string_view, double) {});
  if (!compiled) return compiled.error();
  return std::move(compiled->scene);
}

Result<std::vector<bake::BakedTile>> bake_tiles(const scene::Scene& scene, double tolerance_m, int threads) {
  std::vector<bake::BakedTile> tiles;
  Report ignored;
  const Result<Done> baked = bake_scene(
      scene, std::vector{tolerance_m}, threads, ignored, [](std::string_view, double) {},
      [&](const bake::BakedTile& tile, std::size_t) -> Result<Done> {
        tiles.push_back(tile);
        return Done{};
      });
  if (!baked) return baked.error();
  return tiles;
}

}  // namespace citykiln::charts
