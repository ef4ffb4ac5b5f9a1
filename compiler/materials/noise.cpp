#include "compiler/materials/noise.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "compiler/contract/random_sequence.h"

namespace citykiln::materials {
namespace {

// 128 random bits for a lattice point.
std::array<std::uint32_t, 4> bits_at(std::uint32_t x, std::uint32_t y, std::uint32_t use, std::uint64_t key) {
  return philox4x32_10({x, y, use, 0}, {static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(key >> 32)});
}

double unit_share(std::uint32_t bits) { return bits * 0x1p-32; }

// 6t^5 - 15t^4 + 10t^3: continuous slope and curvature.
double faded(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }

double mixed_value(double a, double b, double share) { return a + (b - a) * share; }

// The centre of a texel along one side: lattice points before and after it, and its position between them.
struct Step {
  std::uint32_t before, after;
  double within, share;
};

std::vector<Step> steps(std::uint32_t side_px, std::uint32_t waves) {
  std::vector<Step> all(side_px);
  for (std::uint32_t i = 0; i < side_px; ++i) {
    const double at = (i + 0.5) * waves / side_px;
    const auto before = static_cast<std::uint32_t>(at);
    const double within = at - before;
    all[i] = {before % waves, (before + 1) % waves, within, faded(within)};
  }
  return all;
}

}  // namespace

Field gradient_noise(std::uint32_t side_px, WaveCounts waves, std::uint64_t key) {
  assert(side_px > 0 && waves.across > 0 && waves.along > 0);
  std::vector<Vec2> slopes(static_cast<std::size_t>(waves.across) * waves.along);
  for (std::uint32_t y = 0; y < waves.along; ++y)
    for (std::uint32_t x = 0; x < waves.across; ++x) {
      const auto bits = bits_at(x, y, 1, key);
      slopes[static_cast<std::size_t>(y) * waves.across + x] = {2 * unit_share(bits[0]) - 1,
                                                                2 * unit_share(bits[1]) - 1};
    }
  const auto slope = [&](std::uint32_t x, std::uint32_t y) {
    return slopes[static_cast<std::size_t>(y) * waves.across + x];
  };
  const std::vector<Step> across = steps(side_px, waves.across), along = steps(side_px, waves.along);
  Field field{side_px, std::vector<float>(static_cast<std::size_t>(side_px) * side_px)};
  for (std::uint32_t row = 0; row < side_px; ++row)
    for (std::uint32_t column = 0; column < side_px; ++column) {
      const Step &x = across[column], &y = along[row];
      const double low = mixed_value(dot(slope(x.before, y.before), {x.within, y.within}),
                                     dot(slope(x.after, y.before), {x.within - 1, y.within}), x.share);
      const double high = mixed_value(dot(slope(x.before, y.after), {x.within, y.within - 1}),
                                      dot(slope(x.after, y.after), {x.within - 1, y.within - 1}), x.share);
      field.at(column, row) = static_cast<float>(mixed_value(low, high, y.share));
    }
  return field;
}

Field layered_noise(std::uint32_t side_px, WaveCounts first, int octaves, double gain, std::uint64_t key) {
  Field sum{side_px, std::vector<float>(static_cast<std::size_t>(side_px) * side_px)};
  double height = 1;
  for (int octave = 0; octave < octaves; ++octave, height *= gain) {
    if (std::max(first.across, first.along) > side_px / 2) break;
    const Field layer = gradient_noise(side_px, first, key + static_cast<std::uint64_t>(octave));
    for (std::size_t i = 0; i < sum.values.size(); ++i) sum.values[i] += static_cast<float>(height) * layer.values[i];
    first = {2 * first.across, 2 * first.along};
  }
  return sum;
}

Field random_values(std::uint32_t side_px, std::uint64_t key) {
  Field field{side_px, std::vector<float>(static_cast<std::size_t>(side_px) * side_px)};
  for (std::size_t i = 0; i < field.values.size(); i += 4) {
    const auto bits = bits_at(static_cast<std::uint32_t>(i / 4), side_px, 4, key);
    for (std::size_t k = 0; k < 4 && i + k < field.values.size(); ++k)
      field.values[i + k] = static_cast<float>(unit_share(bits[k]));
  }
  return field;
}

Cells cells(std::uint32_t side_px, std::uint32_t across, std::uint64_t key) {
  assert(side_px > 0 && across > 0);
  struct Stone {
    Vec2 at;
    float chance;
  };
  std::vector<Stone> stones;
  for (std::uint32_t y = 0; y < across; ++y)
    for (std::uint32_t x = 0; x < across; ++x) {
      const auto bits = bits_at(x, y, 2, key);
      stones.push_back({{unit_share(bits[0]), unit_share(bits[1])}, static_cast<float>(unit_share(bits[2]))});
    }
  const std::size_t texels = static_cast<std::size_t>(side_px) * side_px;
  Cells found{{side_px, std::vector<float>(texels)}, {side_px, std::vector<float>(texels)}};
  for (std::uint32_t row = 0; row < side_px; ++row)
    for (std::uint32_t column = 0; column < side_px; ++column) {
      const Vec2 at{(column + 0.5) * across / side_px, (row + 0.5) * across / side_px};
      const auto x0 = static_cast<std::uint32_t>(at.x), y0 = static_cast<std::uint32_t>(at.y);
      double nearest2 = 9, second2 = 9;
      float chance = 0;
      for (std::uint32_t j = 0; j < 3; ++j)
        for (std::uint32_t i = 0; i < 3; ++i) {
          const Stone& stone = stones[((y0 + across + j - 1) % across) * across + (x0 + across + i - 1) % across];
          const Vec2 middle = Vec2{x0 + i - 1.0, y0 + j - 1.0} + stone.at;
          const double far2 = dot(middle - at, middle - at);
          second2 = std::min(second2, std::max(far2, nearest2));
          if (far2 < nearest2) nearest2 = far2, chance = stone.chance;
        }
      found.chance.at(column, row) = chance;
      found.to_edge.at(column, row) = static_cast<float>(std::sqrt(second2) - std::sqrt(nearest2));
    }
  return found;
}

double noise_at(Vec2 place_m, double wave_m, std::uint64_t key) {
  constexpr double kFarthest = 1 << 30;
  assert(wave_m > 0);
  const Vec2 at = place_m * (1 / wave_m);
  if (!(std::abs(at.x) < kFarthest && std::abs(at.y) < kFarthest)) return 0;
  const double x0 = std::floor(at.x), y0 = std::floor(at.y);
  const auto x = static_cast<std::uint32_t>(static_cast<std::int64_t>(x0)),
             y = static_cast<std::uint32_t>(static_cast<std::int64_t>(y0));
  const auto value = [&](std::uint32_t i, std::uint32_t j) {
    return 2 * unit_share(bits_at(x + i, y + j, 3, key)[0]) - 1;
  };
  const double right = faded(at.x - x0), up = faded(at.y - y0);
  return mixed_value(mixed_value(value(0, 0), value(1, 0), right), mixed_value(value(0, 1), value(1, 1), right), up);
}

}  // namespace citykiln::materials
