// Size and speed of packed meshes over the step of their positions: the bits that a triangle takes, and how fast files
// are written and read, for each way of packing.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>

#include "compiler/bake/bake.h"
#include "compiler/geometry/snap.h"
#include "exporters/gltf/pack/quantise.h"
#include "exporters/gltf/write/encode_tile.h"
#include "exporters/kiln/manifest.h"
#include "tests/charts/chart.h"

namespace citykiln::charts {
namespace {

constexpr double kPackedTolerance_m = 0.1;
/// A finer tolerance than that of the tile, so that packing keeps the map's grid and only the chart sets the step.
constexpr double kKeepsGrid_m = 0.05;
/// From the step of the map's grid to one that is visible at 2.5 m.
constexpr int kExponents[] = {-10, -8, -7, -6, -5, -4, -3};
/// The number of runs, of which the fastest counts.
constexpr int kEncodingRuns = 3;

struct Packing {
  const char* name;
  Compression compression;
};
constexpr std::array kPackings = {Packing{"none", Compression::kNone}, Packing{"quantize", Compression::kQuantize},
                                  Packing{"meshopt", Compression::kMeshopt}, Packing{"draco", Compression::kDraco}};

/// Returns the scene of a manifest, or of a map that is compiled.
Result<scene::Scene> scene_of(const ChartRequest& request) {
  if (!request.maps.empty() && request.maps.front().ends_with(".kiln"))
    return exporters::read_manifest(request.maps.front(), {});
  return compile_first_map(request);
}

/// Bakes the tile with most buildings and removes images and instances, since only its own meshes are measured.
bake::BakedTile tile_of(const scene::Scene& scene, int threads) {
  const auto fullest = std::ranges::max_element(scene.chunks, {}, [](const auto& c) { return c.buildings.size(); });
  Report ignored;
  bake::BakedTile tile = bake::bake(scene.header, *fullest, kPackedTolerance_m, threads, ignored);
  tile.instanced.clear(), tile.textures.clear();
  tile.facade_atlas = {}, tile.marking_atlas = {};
  std::erase_if(tile.primitives, [](const auto& p) { return p.colour_source == materials::ColourSource::kByCutout; });
  for (bake::Primitive& p : tile.primitives) p.colour_source = materials::ColourSource::kByMaterial;
  return tile;
}

/// A tile on a grid, and the longest move of a position. The grid of the tile itself is kQuantum_m for the ground.
struct Snapped {
  bake::BakedTile tile;
  double moved_m = 0;
};

Snapped snapped_tile(const bake::BakedTile& tile, double step_m) {
  Snapped out{tile};
  for (bake::Primitive& p : out.tile.primitives)
    for (bake::Float3& position : p.positions) {
      const Vec3 before = bake::widened(position);
      for (float& c : position) c = static_cast<float>(snapped_to(step_m, c)) + 0.0f;
      out.moved_m = std::max(out.moved_m, length(bake::widened(position) - before));
    }
  out.tile.tolerance_m = kKeepsGrid_m;
  return out;
}

/// Processor time of the process, which runs on one thread while files are measured.
double processor_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct FileCost {
  double bytes = 0, write_s = 1e300, read_s = 1e300;
};

/// The file of a tile, written and read on one thread.
Result<FileCost> cost_of(const bake::BakedTile& tile, const scene::Header& header, Compression compression) {
  const exporters::GlbOptions options{.target = Target::kThree, .split = NodeSplit::kTile, .compression = compression};
  FileCost cost;
  for (int run = 0; run < kEncodingRuns; ++run) {
    const double begin_s = processor_s();
    const std::vector<std::byte> glb = exporters::encode_tile(tile, header, options, 1).glb;
    cost.write_s = std::min(cost.write_s, processor_s() - begin_s), cost.bytes = static_cast<double>(glb.size());
    const double read_s = processor_s();
    const Result<bake::BakedTile> back = exporters::decode_glb(glb, "chart");
    if (!back) return back.error();
    cost.read_s = std::min(cost.read_s, processor_s() - read_s);
  }
  return cost;
}

/// The bytes of a file that are not meshes.
double other_bytes(bake::BakedTile tile, const scene::Header& header) {
  tile.primitives.clear();
  return static_cast<double>(exporters::encode_glb(tile, header, {.split = NodeSplit::kTile}).size());
}

struct Measured {
  Series bits, writing, reading;
};

/// One way of packing at each step, and the plain tile's bytes for the speed.
Result<Measured> measure_packing(const bake::BakedTile& tile, const scene::Header& header, const Packing& packing,
                                 double plain_bytes) {
  const double triangles = static_cast<double>(exporters::triangles_of(tile)), other = other_bytes(tile, header);
  Measured out{{packing.name, {}}, {fmt::format("{} writes", packing.name), {}}, {packing.name, {}}};
  out.reading.name += " reads";
  for (const int exponent : kExponents) {
    const double step_m = std::ldexp(1, exponent);
    const Snapped snapped = snapped_tile(tile, step_m);
    const Result<FileCost> cost = cost_of(snapped.tile, header, packing.compression);
    if (!cost) return cost.error();
    out.bits.points.emplace_back(snapped.moved_m, (cost->bytes - other) * 8 / triangles);
    out.writing.points.emplace_back(step_m, plain_bytes * 1e-6 / cost->write_s);
    out.reading.points.emplace_back(step_m, plain_bytes * 1e-6 / cost->read_s);
  }
  return out;
}

std::size_t vertices_of(const bake::BakedTile& tile) {
  std::size_t count = 0;
  for (const bake::Primitive& p : tile.primitives) count += p.positions.size();
  return count;
}

}  // namespace

Result<std::vector<Chart>> chart_compression(const ChartRequest& request) {
  const Result<scene::Scene> scene = scene_of(request);
  if (!scene) return scene.error();
  if (scene->chunks.empty()) return Error{"chart", "compression: the map has no tile"};
  const bake::BakedTile tile = tile_of(*scene, request.threads);
  const Result<FileCost> plain = cost_of(tile, scene->header, Compression::kNone);
  if (!plain) return plain.error();
  const std::string of = fmt::format("tile {} at {} m, {} triangles, {} vertices", to_string(tile.tile),
                                     kPackedTolerance_m, exporters::triangles_of(tile), vertices_of(tile));
  Chart bits{"compression_bits", "Size of packed meshes: " + of, {"longest move of a vertex (m)", true}, {}, {}};
  bits.y = {"bits per triangle, all attributes", false};
  Chart speed{"compression_speed", "Speed on one thread: " + of, {"step of positions (m)", true}, {}, {}};
  speed.y = {"MB of the plain file per processor second", true};
  for (const Packing& packing : kPackings) {
    Result<Measured> measured = measure_packing(tile, scene->header, packing, plain->bytes);
    if (!measured) return measured.error();
    bits.series.push_back(std::move(measured->bits));
    speed.series.push_back(std::move(measured->writing)), speed.series.push_back(std::move(measured->reading));
  }
  return std::vector{bits, speed};
}

}  // namespace citykiln::charts
