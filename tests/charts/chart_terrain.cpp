// Cost of terrain meshes: certified vertical error against triangles and against time.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/contract/system/for_each_slot.h"
#include "compiler/ground/generate.h"
#include "compiler/map/heights/resample.h"
#include "compiler/map/locate.h"
#include "compiler/source/read_raster.h"
#include "compiler/source/voids/fill_gaps.h"
#include "tests/charts/chart.h"
#include "tests/charts/stopwatch.h"

namespace citykiln::charts {
namespace {

/// Results of other meshers on Mapbox' Fuji tile at 5 m and on SRTM's N42E001, measured on two cores.
struct ReferenceMesher {
  const char* name;
  double triangles, seconds, error_m;
};
constexpr ReferenceMesher kPeersOnFuji[] = {{"hmm, Fuji 512² at 5 m", 123'402, 0.12, 5},
                                            {"delatin, Fuji 512² at 5 m", 123'279, 0.50, 5},
                                            {"martini, Fuji 512² at 5 m", 187'985, 0.02, 8.8}};
constexpr ReferenceMesher kPeersOnN42E001[] = {{"hmm, N42E001 at 5 m", 1'319'159, 2.0, 5},
                                               {"delatin, N42E001 at 5 m", 1'291'720, 4.2, 5}};

/// The western and northern edge of a column and row of Web Mercator tiles.
LonLat corner_of_tile(int z, double x, double y) {
  const double n = std::exp2(z);
  const double lat_rad = std::atan(std::sinh(std::numbers::pi * (1 - 2 * y / n)));
  return {x / n * 360 - 180, lat_rad * 180 / std::numbers::pi};
}

/// The box to mesh, in degrees.
Result<source::LonLatBox> box_of(const ChartRequest& request, const source::RasterSpec& spec,
                                 const source::Raster& raster) {
  if (request.has_bbox) return request.bbox;
  if (spec.bounds) return *spec.bounds;
  if (spec.tile_zxy) {
    const auto [z, x, y] = *spec.tile_zxy;
    const LonLat north_west = corner_of_tile(z, x, y), south_east = corner_of_tile(z, x + 1, y + 1);
    return source::LonLatBox{north_west.lon_deg, south_east.lat_deg, south_east.lon_deg, north_west.lat_deg};
  }
  if (!raster.system_wkt.empty())
    return Error{spec.path, "has projected coordinates; choose a part with --bbox W,S,E,N"};
  const auto& g = raster.from_grid;
  return source::LonLatBox{g[0], g[3] + g[5] * (raster.rows - 1), g[0] + g[1] * (raster.columns - 1), g[3]};
}

/// The largest box of whole cells about the origin inside a box in degrees.
Box2 whole_cells_in(const source::LonLatBox& box, const map::Plane& plane, double cell_m) {
  const Vec2 sw = plane.forward({box.west, box.south}), se = plane.forward({box.east, box.south});
  const Vec2 nw = plane.forward({box.west, box.north}), ne = plane.forward({box.east, box.north});
  const auto up = [&](double v) { return std::ceil(v / cell_m) * cell_m; };
  const auto down = [&](double v) { return std::floor(v / cell_m) * cell_m; };
  return {{up(std::max(sw.x, nw.x)), up(std::max(sw.y, se.y))},
          {down(std::min(se.x, ne.x)), down(std::min(nw.y, ne.y))}};
}

struct Terrain {
  std::vector<source::Raster> rasters;
  map::Plane plane;
  ground::GradedTerrain ground;  ///< Without roads, so nothing is graded.
  std::vector<Box2> cells;
};

std::vector<Box2> cells_of(const Box2& extent, double cell_m) {
  std::vector<Box2> cells;
  for (double y = extent.min.y; y < extent.max.y; y += cell_m) {
    for (double x = extent.min.x; x < extent.max.x; x += cell_m) cells.push_back({{x, y}, {x + cell_m, y + cell_m}});
  }
  return cells;
}

Result<Terrain> read_terrain(const ChartRequest& request) {
  if (request.rasters.empty()) return Error{"chart terrain", "needs a heightmap (--dem FILE)"};
  const source::RasterSpec& spec = request.rasters.front();
  Result<source::Raster> raster = source::read_raster(spec, nullptr);
  if (!raster) return raster.error();

  const Result<source::LonLatBox> box = box_of(request, spec, *raster);
  if (!box) return box.error();
  map::Plane plane(map::default_origin(*box));
  const Box2 extent = whole_cells_in(*box, plane, request.cell_m);
  if (extent.is_empty())
    return Error{spec.path,
                 fmt::format("does not contain a whole cell of {} m; choose a smaller --cell", request.cell_m)};

  Report ignored;
  const std::vector<source::Raster> rasters = {source::fill_voids(std::move(*raster), ignored)};
  Result<map::Heightfield> heights = map::resample(rasters, plane, extent, ignored);
  if (!heights) return heights.error();
  return Terrain{rasters, std::move(plane), ground::GradedTerrain(std::move(*heights)),
                 cells_of(extent, request.cell_m)};
}

struct MeshMeasure {
  double triangles = 0, error_m = 0, seconds = 0;
};

MeshMeasure mesh(const Terrain& terrain, double tolerance_m, int threads) {
  const Stopwatch watch;
  const std::vector<MeshMeasure> cells = for_each_slot<MeshMeasure>(terrain.cells.size(), threads, [&](std::size_t i) {
    Report ignored;
    const ground::GroundMesh cell = ground::generate_cell({}, terrain.ground, terrain.cells[i], tolerance_m, ignored);
    return MeshMeasure{static_cast<double>(cell.mesh.triangles.size()), cell.error_m, 0};
  });
  MeshMeasure all;
  all.seconds = watch.seconds();
  for (const MeshMeasure& cell : cells) {
    all.triangles += cell.triangles;
    all.error_m = std::max(all.error_m, cell.error_m);
  }
  return all;
}

/// Side of the middle part on which fields of different steps are compared: about ten thousand SRTM samples.
constexpr double kCompared_m = 8'000;

Box2 compared_box(const map::Heightfield& heights) {
  const Vec2 centre = heights.box().centre();
  const Box2 square = Box2{centre, centre}.widened(kCompared_m / 2), whole = heights.box();
  return {{std::max(square.min.x, whole.min.x), std::max(square.min.y, whole.min.y)},
          {std::min(square.max.x, whole.max.x), std::min(square.max.y, whole.max.y)}};
}

/// The height field with its step chosen as if samples were closer by the factor `share`.
map::Heightfield field_at(const Terrain& terrain, double share, const Box2& box) {
  std::vector<source::Raster> rasters = terrain.rasters;
  for (source::Raster& raster : rasters) raster.spacing_m = raster.spacing_m * share;
  Report ignored;
  Result<map::Heightfield> field = map::resample(rasters, terrain.plane, box, ignored);
  return field ? std::move(*field) : map::Heightfield{};
}

struct HeightError {
  double largest_m = 0, squares_m2 = 0, count = 0;
};

/// The height difference between a field and a finer one, at the finer one's vertices.
HeightError height_error_between(const map::Heightfield& field, const map::Heightfield& fine, const Box2& box) {
  HeightError off;
  for (int j = 0; j < fine.rows; ++j) {
    for (int i = 0; i < fine.columns; ++i) {
      const Vec2 p = fine.vertex(i, j);
      if (!box.contains(p)) continue;
      const double off_m = map::height_m_at(field, p) - fine.height_m_at_vertex(i, j);
      off.largest_m = std::max(off.largest_m, std::abs(off_m)), off.squares_m2 += off_m * off_m, ++off.count;
    }
  }
  return off;
}

/// The resampling error: the field against the heightmap (bilinear between its samples), over the field's step.
Chart chart_resampling(const Terrain& terrain) {
  const Box2 box = compared_box(terrain.ground.terrain);
  Chart chart{"terrain_resampling",
              fmt::format("Error of the field against vertices a sample of the heightmap; steps of compile: {} by {} m",
                          terrain.ground.terrain.step_m.x, terrain.ground.terrain.step_m.y),
              {"vertices a sample", true},
              {"off the heightmap (m)", true},
              {{"largest", {}}, {"root mean square", {}}}};
  const map::Heightfield fine = field_at(terrain, 0.125, box);
  const Vec2 spacing_m = terrain.rasters.front().spacing_m;
  for (const double share : {1.5, 1.25, 1.0, 0.75, 0.5, 0.25}) {
    const map::Heightfield field = field_at(terrain, share, box);
    const double vertices = spacing_m.x * spacing_m.y / (field.step_m.x * field.step_m.y);
    const HeightError off = height_error_between(field, fine, box);
    chart.series[0].points.emplace_back(vertices, off.largest_m);
    chart.series[1].points.emplace_back(vertices, std::sqrt(off.squares_m2 / off.count));
  }
  return chart;
}

/// The other meshers' results on this heightmap.
std::span<const ReferenceMesher> peers_on(const std::string& raster) {
  if (raster.find("fuji") != std::string::npos) return kPeersOnFuji;
  if (raster.find("N42E001") != std::string::npos) return kPeersOnN42E001;
  return {};
}

}  // namespace

Result<std::vector<Chart>> chart_terrain(const ChartRequest& request) {
  const Result<Terrain> terrain = read_terrain(request);
  if (!terrain) return terrain.error();
  const map::Heightfield& heights = terrain->ground.terrain;
  const std::string what = fmt::format(
      "{} x {} heights every {} by {} m, off their samples by up to {:.1f} m, cells of {} m", heights.columns,
      heights.rows, heights.step_m.x, heights.step_m.y, heights.resampling_error_m, request.cell_m);
  Chart triangles{"terrain_triangles",
                  "Vertical error against triangles: " + what,
                  {"triangles", true},
                  {"largest vertical error (m)", true},
                  {}};
  Chart seconds{"terrain_time",
                "Vertical error against time: " + what,
                {"seconds", true},
                {"largest vertical error (m)", true},
                {}};

  triangles.series.push_back({"citykiln, certified", {}});
  seconds.series.push_back({"citykiln, certified", {}});
  for (const double tolerance_m : {0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0}) {
    const MeshMeasure measure = mesh(*terrain, tolerance_m, request.threads);
    triangles.series.front().points.emplace_back(measure.triangles, measure.error_m);
    seconds.series.front().points.emplace_back(measure.seconds, measure.error_m);
  }
  for (const ReferenceMesher& peer : peers_on(request.rasters.front().path)) {
    triangles.series.push_back({peer.name, {{peer.triangles, peer.error_m}}, true});
    seconds.series.push_back({peer.name, {{peer.seconds, peer.error_m}}, true});
  }
  return std::vector{triangles, seconds, chart_resampling(*terrain)};
}

}  // namespace citykiln::charts
