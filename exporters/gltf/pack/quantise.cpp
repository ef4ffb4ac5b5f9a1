#include "exporters/gltf/pack/quantise.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/geometry/snap.h"
#include "exporters/gltf/object_runs.h"
#include "exporters/gltf/packed_grids.h"
#include "exporters/gltf/share_vertices.h"

namespace citykiln::exporters {
namespace {

using bake::Float3;
using bake::Primitive;
using materials::ColourSource;

// + 0.0 turns a negative zero, which not every format can represent, into a positive one.
float on_grid(double step_m, float v) { return static_cast<float>(snapped_to(step_m, v)) + 0.0f; }

double distance_m(const Float3& a, const Float3& b) {
  const auto square = [&](std::size_t c) { return (double{a[c]} - b[c]) * (double{a[c]} - b[c]); };
  return std::sqrt(square(0) + square(1) + square(2));
}

// Returns the longest move of a position.
double put_positions_on_grid(double step_m, Primitive& primitive) {
  double farthest_m = 0;
  for (Float3& p : primitive.positions) {
    const Float3 before = p;
    for (float& c : p) c = on_grid(step_m, c);
    farthest_m = std::max(farthest_m, distance_m(before, p));
  }
  return farthest_m;
}

// The step of uvs on an image.
double uv_step_m(double texel_m) {
  int exponent = 0;
  std::frexp(texel_m / kUvStepsPerTexel, &exponent);
  return std::max(kPackedUv_m, std::ldexp(1.0, exponent - 1));
}

void put_uvs_on_grid(double step_m, Primitive& primitive) {
  for (bake::Float2& uv : primitive.uvs)
    for (float& c : uv) c = on_grid(step_m, c);
}

// Moves the uvs of a run by whole periods, so that the smallest are in the first one.
void begin_in_first_period(const ObjectRun& run, std::vector<bake::Float2>& uvs) {
  for (std::size_t c = 0; c < 2; ++c) {
    double smallest = uvs[run.first_vertex][c];
    for (std::size_t v = run.first_vertex; v < run.last_vertex; ++v) smallest = std::min<double>(smallest, uvs[v][c]);
    const double begin = std::floor(smallest / materials::kTexturePeriod_m) * materials::kTexturePeriod_m;
    for (std::size_t v = run.first_vertex; v < run.last_vertex; ++v) uvs[v][c] = static_cast<float>(uvs[v][c] - begin);
  }
}

// The texel of the image that a primitive shows; 0 where it shows none.
double shown_texel_m(const bake::BakedTile& tile, const impostor::Cutout* cutout, ColourSource source) {
  if (source == ColourSource::kByMarkingAtlas) return tile.marking_atlas.texel_m;
  if (source == ColourSource::kByAtlas) return tile.facade_atlas.colour.texel_m;
  return source == ColourSource::kByCutout && cutout != nullptr ? cutout->colour.texel_m : 0;
}

// Returns the longest move of a position. @param step_m  Of positions; 0: they stay. @param texel_m  0 for uvs on
// textures, which repeat.
double quantise(double step_m, double texel_m, double tolerance_m, Primitive& primitive) {
  const double farthest_m = step_m == 0 ? 0 : put_positions_on_grid(step_m, primitive);
  const bool is_on_image = texel_m > 0;
  put_uvs_on_grid(is_on_image ? uv_step_m(texel_m) : packed_texture_step_m(tolerance_m), primitive);
  if (!is_on_image && !primitive.uvs.empty()) {
    std::vector<ObjectRun> runs = object_runs(primitive);
    // faces of a building go on sharing vertices; a road may be too long for 16 bits
    if (primitive.layer == bake::Layer::kBuildings) runs = feature_runs(primitive, runs);
    for (const ObjectRun& run : runs) begin_in_first_period(run, primitive.uvs);
  }
  share_vertices(primitive);
  return farthest_m;
}

constexpr double kHalfALastBit = 0x1p-24, kSqrt3 = 1.7320508075688772;

}  // namespace

double rounding_m(std::span<const Primitive> primitives) {
  double farthest_m = 0;
  for (const Primitive& primitive : primitives)
    for (const Float3& p : primitive.positions)
      for (const float c : p)
        if (c != snapped(c)) farthest_m = std::max<double>(farthest_m, std::abs(c));
  return farthest_m * kHalfALastBit * kSqrt3;
}

double quantising_bound_m(double tolerance_m, double reach_m, double largest_scale, Compression compression) {
  if (compression == Compression::kNone || compression == Compression::kLean) return 0;
  const double steps = kSqrt3 / 2 * std::max(1.0, kPrototypeStepRatio * largest_scale);
  return steps * packed_position_step_m(tolerance_m) + reach_m * kHalfALastBit * kSqrt3;
}

bake::BakedTile quantised(bake::BakedTile tile, Compression compression) {
  assert(compression != Compression::kNone);
  const bool moves = compression != Compression::kLean;
  const double step_m = moves ? packed_position_step_m(tile.tolerance_m) : 0;
  double farthest_m = 0, of_plants_m = 0;
  const double rounded_m = moves ? rounding_m(tile.primitives) : 0;
  for (Primitive& p : tile.primitives) {
    // terrain keeps the map's own grid: borders, lakes and quays are measured by the height at a place, which a step
    // aside can change by the height of a quay
    const double own_step_m = moves && is_terrain(p) ? kQuantum_m : step_m;
    farthest_m =
        std::max(farthest_m, quantise(own_step_m, shown_texel_m(tile, nullptr, p.colour_source), tile.tolerance_m, p));
  }
  for (bake::InstancedMesh& instanced : tile.instanced) {
    double moved_m = 0;
    for (Primitive& p : instanced.primitives)
      moved_m =
          std::max(moved_m, quantise(step_m * kPrototypeStepRatio,
                                     shown_texel_m(tile, &*instanced.cutout, p.colour_source), tile.tolerance_m, p));
    double& largest_m = layer_of(instanced) == bake::Layer::kPlants ? of_plants_m : farthest_m;
    for (const float scale : instanced.scales) largest_m = std::max(largest_m, moved_m * std::abs(scale));
  }
  tile.object_error_m += rounded_m + farthest_m;
  tile.error_m = std::max(tile.error_m, tile.object_error_m), tile.plant_error_m += of_plants_m;
  return tile;
}

}  // namespace citykiln::exporters
