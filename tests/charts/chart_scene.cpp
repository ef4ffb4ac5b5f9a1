// Compiles the scene that a chart measures.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "compiler/pipeline.h"
#include "tests/charts/chart.h"

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

}  // namespace citykiln::charts
