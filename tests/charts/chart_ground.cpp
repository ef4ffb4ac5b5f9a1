// Costs of a map's ground over the tolerance: certified error, triangles and a bound on them, time and memory.
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <set>

#include "compiler/bake/ground/ground_cells.h"
#include "compiler/contract/detail_tolerances.h"
#include "compiler/contract/system/for_each_slot.h"
#include "compiler/ground/cover/partition.h"
#include "compiler/ground/cover/simplify_borders.h"
#include "compiler/ground/plan.h"
#include "compiler/scene/graded_terrain.h"
#include "compiler/scene/land_cover.h"
#include "compiler/spec.h"
#include "compiler/stage_timer.h"
#include "tests/charts/chart.h"

namespace citykiln::charts {
namespace {

/// Allowed ratio of triangles to those of the heights without borders plus those of the borders without heights.
constexpr double kBoundFactor = 1.3;

struct GroundMeasure {
  double triangles = 0, upright = 0, error_m = 0, border_error_m = 0, seconds = 0, cpu_seconds = 0, peak_MB = 0;
};

struct Bound {
  double bare_triangles = 0, border_vertices = 0;
  double triangles() const { return kBoundFactor * (bare_triangles + 2 * border_vertices); }
};

void bake_ground(const scene::Scene& scene, double tolerance_m, int threads, GroundMeasure& measure) {
  Report ignored;
  for (const scene::Chunk& chunk : scene.chunks) {
    const ground::GradedTerrain graded = scene::graded_terrain_of(scene.header, chunk, tolerance_m);
    const scene::LandCover cover = scene::land_cover_of(scene.header, chunk, tolerance_m);
    for (const ground::GroundMesh& cell : bake::generate_cells(
             graded, cover.surfaces, scene::box_of(scene.header, chunk.tile), tolerance_m, threads, ignored)) {
      measure.triangles += cell.first_vertical;
      measure.upright += static_cast<double>(cell.mesh.triangles.size() - cell.first_vertical);
      measure.error_m = std::max(measure.error_m, cell.error_m);
      measure.border_error_m = std::max(measure.border_error_m, cell.border_error_m);
    }
  }
}

/// Measures wall-clock time, processor time and memory of a function.
template <typename Work>
GroundMeasure measured_work(Work work) {
  GroundMeasure measure;
  StageTimer timer([](std::string_view, double) {});
  timer.enter("ground");
  const std::clock_t begin = std::clock();
  work(measure);
  measure.cpu_seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  const StageCost cost = timer.finish().front();
  measure.seconds = cost.seconds;
  measure.peak_MB = static_cast<double>(cost.peak_bytes) * 1e-6;
  return measure;
}

GroundMeasure measure_level(const scene::Scene& scene, double tolerance_m, int threads) {
  return measured_work([&](GroundMeasure& measure) { bake_ground(scene, tolerance_m, threads, measure); });
}

/// Bakes all levels of a tile together, as bake() does.
void bake_ladder(const scene::Scene& scene, const scene::Chunk& chunk, std::span<const double> tolerances_m,
                 int threads) {
  constexpr double kRoadSurfaces_m = tolerances_with(Detail::kRoadSurfaces).below_m;
  const auto carve = [&](double tolerance_m) { return scene::graded_terrain_of(scene.header, chunk, tolerance_m); };
  const ground::GradedTerrain fine = carve(kRoadSurfaces_m / 2), coarse = carve(kRoadSurfaces_m);
  std::vector<scene::LandCover> covers;
  for (const double tolerance_m : tolerances_m)
    covers.push_back(scene::land_cover_of(scene.header, chunk, tolerance_m));
  std::vector<bake::GroundLevel> levels;
  for (std::size_t i = 0; i < tolerances_m.size(); ++i)
    levels.push_back(
        {has_detail(Detail::kRoadSurfaces, tolerances_m[i]) ? fine : coarse, covers[i].surfaces, tolerances_m[i]});
  std::vector<Report> ignored(levels.size());
  bake::generate_cells(levels, scene::box_of(scene.header, chunk.tile), threads, ignored);
}

GroundMeasure measure_ladder(const scene::Scene& scene, std::span<const double> tolerances_m, int threads) {
  return measured_work([&](GroundMeasure&) {
    for_each_index(scene.chunks.size(), threads,
                   [&](std::size_t i) { bake_ladder(scene, scene.chunks[i], tolerances_m, threads); });
  });
}

/// The number of vertices of visible borders after simplification to the tolerance, without heights.
double border_vertices_of(std::span<const ground::LandCoverPolygon> surfaces, const Box2& cell, double tolerance_m) {
  std::vector<ground::LandCoverPolygon> near;
  for (const ground::LandCoverPolygon& surface : surfaces) {
    near.push_back(ground::trimmed_to(surface, cell.widened(1)));
    if (near.back().rings.empty()) near.pop_back();
  }
  const ground::NearbyCover layers = ground::land_cover_near(near, cell);
  const ground::Partition all = ground::partition_all_rings(layers, {}, {}, cell);
  const auto borders = ground::visible_borders(all, ground::ring_joints(layers, all.arrangement, cell));
  const auto none = [](GridPoint) { return false; };
  std::set<GridPoint> vertices;
  for (const ground::Border& border : ground::simplify_borders(borders, tolerance_m, none).borders) {
    if (border.is_cell_border) continue;
    vertices.insert(border.a), vertices.insert(border.b);
  }
  return static_cast<double>(vertices.size());
}

Bound bound_of(const scene::Scene& scene, double tolerance_m, int threads) {
  Bound bound;
  for (const scene::Chunk& chunk : scene.chunks) {
    const ground::GradedTerrain graded = scene::graded_terrain_of(scene.header, chunk, tolerance_m);
    const scene::LandCover cover = scene::land_cover_of(scene.header, chunk, tolerance_m);
    const std::vector<Box2> cells = bake::cells_of(scene::box_of(scene.header, chunk.tile));
    const auto each = for_each_slot<Bound>(cells.size(), threads, [&](std::size_t i) {
      Report ignored;
      const auto bare = ground::generate_cell({}, graded, cells[i], tolerance_m, ignored);
      return Bound{static_cast<double>(bare.mesh.triangles.size()),
                   border_vertices_of(cover.surfaces, cells[i], tolerance_m)};
    });
    for (const Bound& cell : each)
      bound.bare_triangles += cell.bare_triangles, bound.border_vertices += cell.border_vertices;
  }
  return bound;
}

struct GroundCharts {
  Chart triangles, errors, seconds, memory;
};

GroundCharts empty_ground_charts(const std::string& what) {
  const Axis tolerance{"tolerance (m)", true};
  return {{"ground_triangles",
           "Triangles of the ground over the tolerance: " + what,
           tolerance,
           {"triangles", true},
           {{"citykiln, looking upwards", {}},
            {"citykiln, upright: kerbs, quays, walls", {}},
            {"1.3 × (heights alone + 2 a vertex of borders alone)", {}, true}}},
          {"ground_error",
           "Errors of the ground over the tolerance: " + what,
           tolerance,
           {"largest error (m)", true},
           {{"of heights, certified", {}}, {"of borders, in plan", {}}, {"the tolerance", {}, true}}},
          {"ground_time",
           "Time of the ground over the tolerance: " + what,
           tolerance,
           {"seconds", true},
           {{"by the clock", {}}, {"of processors", {}}}},
          {"ground_memory",
           "Memory of the ground over the tolerance: " + what,
           tolerance,
           {"largest resident memory (MB)", false},
           {{"citykiln", {}}}}};
}

void add_ground_level(GroundCharts& charts, double tolerance_m, const GroundMeasure& measure, const Bound& bound) {
  const auto add = [&](Chart& chart, std::initializer_list<double> values) {
    std::size_t i = 0;
    for (const double value : values) chart.series[i++].points.emplace_back(tolerance_m, value);
  };
  add(charts.triangles, {measure.triangles, measure.upright, bound.triangles()});
  add(charts.errors, {measure.error_m, measure.border_error_m, tolerance_m});
  add(charts.seconds, {measure.seconds, measure.cpu_seconds});
  add(charts.memory, {measure.peak_MB});
}

}  // namespace

Result<std::vector<Chart>> chart_ground(const ChartRequest& request) {
  const Result<scene::Scene> scene = compile_first_map(request);
  if (!scene) return scene.error();
  const Box2& extent = scene->header.extent;
  const std::string map = request.maps.front().substr(request.maps.front().rfind('/') + 1);
  GroundCharts charts = empty_ground_charts(
      fmt::format("{}, {:.0f} km², {} tiles", map, extent.width() * extent.height() * 1e-6, scene->chunks.size()));
  const GroundMeasure all = measure_ladder(*scene, Outputs{}.tolerances_m, request.threads);
  charts.seconds.title += fmt::format("; all levels at once {:.1f} s by the clock, {:.1f} s of processors, {:.0f} MB",
                                      all.seconds, all.cpu_seconds, all.peak_MB);
  for (const double tolerance_m : Outputs{}.tolerances_m) {
    const GroundMeasure measure = measure_level(*scene, tolerance_m, request.threads);
    add_ground_level(charts, tolerance_m, measure, bound_of(*scene, tolerance_m, request.threads));
  }
  return std::vector{charts.triangles, charts.errors, charts.seconds, charts.memory};
}

}  // namespace citykiln::charts
