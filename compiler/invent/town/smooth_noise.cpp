#include "compiler/invent/town/smooth_noise.h"

#include <cmath>

#include "compiler/contract/stable_id.h"

namespace citykiln::invent {
namespace {

double lattice_noise(std::uint64_t seed, std::int64_t i, std::int64_t j) {
  const StableId id = stable_id(StableId{seed}, "noise", static_cast<std::uint64_t>(i * 0x100000001 + j));
  return static_cast<double>(static_cast<std::uint64_t>(id) >> 32) * (2.0 / 4294967296.0) - 1;
}

double cubic_blend(double t) { return t * t * (3 - 2 * t); }

}  // namespace

double smooth_noise(std::uint64_t seed, Vec2 p, double wave_m) {
  const double x = p.x / wave_m, y = p.y / wave_m;
  const double fx = std::floor(x), fy = std::floor(y), u = cubic_blend(x - fx), v = cubic_blend(y - fy);
  const auto i = static_cast<std::int64_t>(fx), j = static_cast<std::int64_t>(fy);
  const double south = lattice_noise(seed, i, j) * (1 - u) + lattice_noise(seed, i + 1, j) * u;
  const double north = lattice_noise(seed, i, j + 1) * (1 - u) + lattice_noise(seed, i + 1, j + 1) * u;
  return south * (1 - v) + north * v;
}

}  // namespace citykiln::invent
