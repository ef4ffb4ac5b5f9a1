// Samples of one lamp of many.
#include <vector>

#include "preview/light/light_tree.h"
#include "tests/charts/hard_cases.h"

namespace citykiln::charts {
namespace {

constexpr double kMostDeviation = 3;

std::vector<preview::LightBounds> hard_lamps(HardDraw& draw, Vec3 at, bool some_are_near) {
  std::vector<preview::LightBounds> lamps(static_cast<std::size_t>(draw.whole(2, 64)));
  for (std::size_t i = 0; i < lamps.size(); ++i) {
    const int kind = draw.whole(0, 9);
    Vec3 place{draw.between(-500, 500), draw.between(-500, 500), draw.between(3, 12)};
    if (kind < 3 && i > 0) place = lamps[i - 1].low;
    if (some_are_near && kind == 9)
      place = at + Vec3{draw.between(-0.1, 0.1), draw.between(-0.1, 0.1), draw.between(0.01, 0.1)};
    lamps[i] = {.low = place, .high = place, .axis = {0, 0, -1}, .reach_rad = 1.5707963};
    lamps[i].flux = draw.of_any_size(1e-3, 1e4), lamps[i].is_even = true;
  }
  return lamps;
}

// The irradiance of level ground by an even lamp, up to a common factor.
double light_of(const preview::LightBounds& lamp, Vec3 at) {
  const Vec3 out = lamp.low - at;
  return lamp.flux * std::max(0.0, out.z) / std::pow(dot(out, out), 1.5);
}

Judged judge_lamps(HardDraw& draw, bool some_are_near) {
  const Vec3 at{draw.between(-500, 500), draw.between(-500, 500), 0};
  const std::vector<preview::LightBounds> lamps = hard_lamps(draw, at, some_are_near);
  const preview::LightTree tree(lamps);
  double sum = 0, by_tree = 0, even = 0, chances = 0;
  bool is_unbiased = true;
  for (std::uint32_t i = 0; i < lamps.size(); ++i) {
    const double light = light_of(lamps[i], at), chance = tree.probability(i, at, {0, 0, 1});
    sum += light, chances += chance, even += light * light * static_cast<double>(lamps.size());
    if (light <= 0) continue;
    is_unbiased &= chance > 0;
    if (chance > 0) by_tree += light * light / chance;
  }
  const auto is_calm = [&](double squares) { return squares / (sum * sum) - 1 <= kMostDeviation * kMostDeviation; };
  return {is_calm(even), is_unbiased && chances < 1 + 1e-6 && is_calm(by_tree)};
}

}  // namespace

Judged judge_lights(HardDraw& draw) { return judge_lamps(draw, false); }
Judged judge_near_lights(HardDraw& draw) { return judge_lamps(draw, true); }

}  // namespace citykiln::charts
