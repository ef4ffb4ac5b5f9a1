#include "exporters/gltf/quantise.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/snap.h"
#include "exporters/gltf/compression.h"

namespace citykiln::exporters {
namespace {

using bake::Float3;
using bake::Primitive;

// + 0.0 turns a negative zero, which not every format can represent, into a positive one.
float on_grid(double step_m, float v) { return static_cast<float>(snapped_to(step_m, v)) + 0.0f; }

double distance_m(const Float3& a, const Float3& b) {
  const auto square = [&](std::size_t c) { return (double{a[c]} - b[c]) * (double{a[c]} - b[c]); };
  return std::sqrt(square(0) + square(1) + square(2));
}

// Returns the longest move of a position.
double put_on_grid(std::vector<Primitive>& primitives) {
  double farthest_m = 0;
  for (Primitive& primitive : primitives) {
    for (Float3& p : primitive.positions) {
      const Float3 before = p;
      for (float& c : p) c = on_grid(kPackedPosition_m, c);
      farthest_m = std::max(farthest_m, distance_m(before, p));
    }
    for (bake::Float2& uv : primitive.uvs)
      for (float& c : uv) c = on_grid(kPackedUv_m, c);
  }
  return farthest_m;
}

}  // namespace

double rounding_m(std::span<const Primitive> primitives) {
  constexpr double kHalfALastBit = 0x1p-24, kSqrt3 = 1.7320508075688772;
  double farthest_m = 0;
  for (const Primitive& primitive : primitives)
    for (const Float3& p : primitive.positions)
      for (const float c : p)
        if (c != snapped(c)) farthest_m = std::max<double>(farthest_m, std::abs(c));
  return farthest_m * kHalfALastBit * kSqrt3;
}

bake::BakedTile quantised(bake::BakedTile tile) {
  const double before_m = rounding_m(tile.primitives);
  double farthest_m = put_on_grid(tile.primitives);
  for (bake::InstancedMesh& instanced : tile.instanced) {
    const double moved_m = put_on_grid(instanced.primitives);
    for (const float scale : instanced.scales) farthest_m = std::max(farthest_m, moved_m * std::abs(scale));
  }
  tile.error_m += before_m + farthest_m, tile.plant_error_m += farthest_m;
  return tile;
}

}  // namespace citykiln::exporters
