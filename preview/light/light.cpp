#include "preview/light/light.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace citykiln::preview {
namespace {

constexpr double kPi = std::numbers::pi;

// Preetham's sky is smooth: cells of 0.028 rad² represent it within 1 %, but for the glow around the sun.
constexpr int kAcross = 128, kDown = 64, kCells = kAcross * kDown;

// Extinction of clear air by molecules (at 680, 550 and 440 nm; Bruneton, Neyret, "Precomputed Atmospheric Scattering",
// EGSR 2008, at sea level) and by dust. Together some 3.9 / 2.3e-5 = 170 km of sight, the clearest of days
// (Koschmieder), so that cities are visible from a few kilometres.
constexpr Rgb kAir_per_m = {5.8e-6 + 6e-6, 13.5e-6 + 6e-6, 33.1e-6 + 6e-6};

// Haze has the colour of the sky at this height above the horizon, where the eye looks through some 40 km of air.
constexpr double kHazeRise = 0.06;

// The sky fades to haze within this angle below the horizon.
constexpr double kHorizonBlur_rad = 0.06;

double turn_of(Vec3 d) {
  const double turn = std::atan2(d.y, d.x) / (2 * kPi);
  return turn < 0 ? turn + 1 : turn;
}

int cell_of(Vec3 d) {
  const int column = std::min(static_cast<int>(turn_of(d) * kAcross), kAcross - 1);
  const int row = std::min(static_cast<int>(d.z * kDown), kDown - 1);
  return row * kAcross + column;
}

Vec3 direction_of(double turn, double z) {
  const double r = std::sqrt(std::max(0.0, 1 - z * z)), angle = 2 * kPi * turn;
  return {r * std::cos(angle), r * std::sin(angle), z};
}

// The step at which a cumulative sum exceeds a share of its total, and the position within it.
struct Step {
  int index;
  double within;
};

Step step_at(const double* sums, int count, double share) {
  const double wanted = share * sums[count - 1];
  const int i = std::min(static_cast<int>(std::upper_bound(sums, sums + count, wanted) - sums), count - 1);
  const double before = i > 0 ? sums[i - 1] : 0, size = sums[i] - before;
  return {i, size > 0 ? std::clamp((wanted - before) / size, 0.0, 1.0) : 0.5};
}

}  // namespace

// Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.
Vec3 around(Vec3 n, double cos_angle, double turn) {
  const double sign = std::copysign(1.0, n.z), a = -1 / (sign + n.z), b = n.x * n.y * a;
  const Vec3 tangent{1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, other{b, sign + n.y * n.y * a, -n.y};
  const double s = std::sqrt(std::max(0.0, 1 - cos_angle * cos_angle)), angle = 2 * kPi * turn;
  return unit(tangent * (s * std::cos(angle)) + other * (s * std::sin(angle)) + n * cos_angle);
}

DirectionSample sample_cosine(Vec3 normal, UnitPair chance) {
  assert(chance.u >= 0 && chance.u < 1);
  const double cos_angle = std::sqrt(1 - chance.u);
  return {around(normal, cos_angle, chance.v), cos_angle / kPi};
}

Lights::Lights(const sky::SkyModel& model)
    : model_(model), cells_(kCells), ring_(kAcross + 1), row_sums_(kDown), sums_(kCells) {
  if (luminance(model.sun_radiance) > 0) sun_solid_angle_ = 2 * kPi * (1 - model.sun_cos_radius);
  double total = 0;
  for (int row = 0; row < kDown; ++row) {
    double sum = 0;
    for (int column = 0; column < kAcross; ++column) {
      const int cell = row * kAcross + column;
      cells_[cell] = sky::radiance(model, direction_of((column + 0.5) / kAcross, (row + 0.5) / kDown));
      sums_[cell] = sum += luminance(cells_[cell]);
    }
    row_sums_[row] = total += sum;
  }
  for (int i = 0; i <= kAcross; ++i) {
    const Vec3 level = direction_of(static_cast<double>(i) / kAcross, 0);
    ring_[i] = sky::radiance(model, unit(Vec3{level.x, level.y, kHazeRise}));
    if (i == kAcross) continue;
    haze_mean_ = haze_mean_ + ring_[i] * (1.0 / kAcross);
    below_ = below_ + sky::radiance(model, unit(Vec3{level.x, level.y, -kHazeRise})) * (1.0 / kAcross);
  }
}

const Rgb& Lights::falling(Vec3 direction) const { return direction.z < 0 ? below_ : cells_[cell_of(direction)]; }

DirectionSample Lights::sample_sky(UnitPair chance) const {
  if (row_sums_.back() <= 0) return {};
  const Step row = step_at(row_sums_.data(), kDown, chance.u);
  const Step column = step_at(&sums_[row.index * kAcross], kAcross, chance.v);
  const Vec3 direction = direction_of((column.index + column.within) / kAcross, (row.index + row.within) / kDown);
  return {direction, sky_pdf(direction)};
}

double Lights::sky_pdf(Vec3 direction) const {
  if (direction.z < 0 || row_sums_.back() <= 0) return 0;
  return luminance(cells_[cell_of(direction)]) / row_sums_.back() * (kCells / (2 * kPi));
}

Vec3 Lights::sample_sun(UnitPair chance) const {
  return around(model_.to_sun, 1 - chance.u * (1 - model_.sun_cos_radius), chance.v);
}

Rgb Lights::haze(Vec3 direction) const {
  const double place = turn_of(direction) * kAcross;
  const int i = std::min(static_cast<int>(place), kAcross - 1);
  const double share = place - i;
  // straight down there is no azimuth
  const double level = direction.x * direction.x + direction.y * direction.y;
  return (ring_[i] * (1 - share) + ring_[i + 1] * share) * level + haze_mean_ * (1 - level);
}

Rgb Lights::seen(Vec3 direction) const {
  if (direction.z >= 0) return sky::radiance(model_, direction);
  const double depth = std::min(-direction.z / kHorizonBlur_rad, 1.0), share = depth * depth * (3 - 2 * depth);
  if (share >= 1) return haze(direction);
  const Rgb horizon = sky::radiance(model_, unit(Vec3{direction.x, direction.y, 0}));
  return horizon * (1 - share) + haze(direction) * share;
}

Rgb Lights::through_air(const Rgb& light, Vec3 direction, double distance_m) const {
  const Rgb added = haze(direction);
  Rgb out;
  for (int c = 0; c < 3; ++c) {
    const double clear = std::exp(-distance_m * kAir_per_m[c]);
    out[c] = light[c] * clear + added[c] * (1 - clear);
  }
  return out;
}

}  // namespace citykiln::preview
