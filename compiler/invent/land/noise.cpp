#include "compiler/invent/land/noise.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/geometry/trig.h"

namespace citykiln::invent {
namespace {

constexpr int kGradients = 16;

// the finaliser of SplitMix64 (Steele, Lea, Flood 2014)
std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

std::array<Vec2, kGradients> gradients() {
  std::array<Vec2, kGradients> all;
  for (int i = 0; i < kGradients; ++i) all[i] = direction_of((i + 0.5) / kGradients);
  return all;
}

double eased(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }

}  // namespace

std::uint64_t hash_of(std::int64_t x, std::int64_t y, std::uint64_t seed) {
  const std::uint64_t first = mixed(static_cast<std::uint64_t>(x) + 0x9e3779b97f4a7c15U * (seed + 1));
  return mixed(first ^ mixed(static_cast<std::uint64_t>(y) + 0xd1b54a32d192ed03U));
}

double perlin(Vec2 p, std::uint64_t seed) {
  static const std::array<Vec2, kGradients> kDirections = gradients();
  const double x = std::floor(p.x), y = std::floor(p.y);
  const Vec2 in{p.x - x, p.y - y};
  const auto corner = [&](int i, int j) {
    const std::uint64_t hash = hash_of(static_cast<std::int64_t>(x) + i, static_cast<std::int64_t>(y) + j, seed);
    return dot(kDirections[hash % kGradients], in - Vec2{static_cast<double>(i), static_cast<double>(j)});
  };
  const double u = eased(in.x), v = eased(in.y);
  const double south = corner(0, 0) + (corner(1, 0) - corner(0, 0)) * u,
               north = corner(0, 1) + (corner(1, 1) - corner(0, 1)) * u;
  // the largest value of gradient noise in the plane is the square root of a half
  return std::clamp((south + (north - south) * v) * 1.4142135623730951, -1.0, 1.0);
}

double fractal_noise(Vec2 p, int octaves, std::uint64_t seed) {
  double sum = 0, height = 1, heights = 0;
  for (int i = 0; i < octaves; ++i, p = p * 2, height /= 2) {
    sum += height * perlin(p, seed + static_cast<std::uint64_t>(i));
    heights += height;
  }
  return heights > 0 ? sum / heights : 0;
}

double ridged_noise(Vec2 p, int octaves, std::uint64_t seed) {
  double sum = 0, height = 1, heights = 0, weight = 1;
  for (int i = 0; i < octaves; ++i, p = p * 2, height /= 2) {
    const double ridge = 1 - std::abs(perlin(p, seed + static_cast<std::uint64_t>(i)));
    const double sharp = ridge * ridge * weight;
    weight = std::clamp(sharp * 2, 0.0, 1.0);
    sum += height * sharp;
    heights += height;
  }
  return heights > 0 ? sum / heights : 0;
}

}  // namespace citykiln::invent
