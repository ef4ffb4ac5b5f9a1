#include "preview/light/light.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace citykiln::preview {
namespace {

constexpr double kPi = std::numbers::pi;

// Preetham's sky is smooth: interpolated between cells of 0.8 millisteradian it is right within 1 %, but for the glow
// around the sun.
constexpr int kAcross = 128, kDown = 64;

// Extinction of clear air by molecules (at 680, 550 and 440 nm; Bruneton, Neyret, "Precomputed Atmospheric Scattering",
// EGSR 2008, at sea level) and by dust. Together some 3.9 / 2.3e-5 = 170 km of sight, the clearest of days
// (Koschmieder), so that cities are visible from a few kilometres.
constexpr Rgb kAir_per_m = {5.8e-6 + 6e-6, 13.5e-6 + 6e-6, 33.1e-6 + 6e-6};

// Haze has the colour of the sky at this height above the horizon, where the eye looks through some 40 km of air.
constexpr double kHazeRise = 0.06;

// The sky fades to haze within this angle below the horizon.
constexpr double kHorizonBlur_rad = 0.06;

std::array<float, 3> narrowed(const Rgb& c) {
  return {static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])};
}

DirectionTable table_of(const sky::SkyModel& model) {
  std::vector<double> z_edges;
  for (int row = 0; row <= kDown; ++row) z_edges.push_back(static_cast<double>(row) / kDown);
  std::vector<std::array<float, 3>> cells;
  for (int row = 0; row < kDown; ++row)
    for (int column = 0; column < kAcross; ++column)
      cells.push_back(narrowed(sky::radiance(model, direction_at((column + 0.5) / kAcross, (row + 0.5) / kDown))));
  return {std::move(z_edges), kAcross, std::move(cells)};
}

// The map's rows are turned upside down, its columns backwards and by half a circle: azimuths are counter-clockwise
// from east.
DirectionTable table_of(const EnvironmentMap& map) {
  assert(map.width > 0 && map.height > 0);
  std::vector<double> z_edges;
  for (int row = 0; row <= map.height; ++row) z_edges.push_back(-std::cos(kPi * row / map.height));
  std::vector<std::array<float, 3>> cells;
  for (int row = map.height - 1; row >= 0; --row)
    for (int column = 0; column < map.width; ++column) {
      const int from = (map.width - 1 - column + map.width / 2 + map.width % 2) % map.width;
      const float* texel = &map.rgb[(static_cast<std::size_t>(row) * map.width + from) * 3];
      cells.push_back({texel[0], texel[1], texel[2]});
    }
  return {std::move(z_edges), map.width, std::move(cells)};
}

}  // namespace

Lights::Lights(const sky::SkyModel& model, std::vector<StreetLamp> lamps)
    : model_(model),
      about_sun_(frame_about(unit(model.to_sun))),
      table_(table_of(model)),
      ring_(kAcross + 1),
      lamps_(std::move(lamps)) {
  if (luminance(model.sun_radiance) > 0) sun_solid_angle_ = 2 * kPi * (1 - model.sun_cos_radius);
  if (sun_solid_angle_ > 0 && table_.flux() > 0)
    sun_to_sky_ = luminance(model.sun_radiance) * sun_solid_angle_ / table_.flux();
  for (int i = 0; i <= kAcross; ++i) {
    const Vec3 level = direction_at(static_cast<double>(i) / kAcross, 0);
    ring_[i] = sky::radiance(model, unit(Vec3{level.x, level.y, kHazeRise}));
    if (i == kAcross) continue;
    haze_mean_ = haze_mean_ + ring_[i] * (1.0 / kAcross);
    below_ = below_ + sky::radiance(model, unit(Vec3{level.x, level.y, -kHazeRise})) * (1.0 / kAcross);
  }
}

Lights::Lights(const EnvironmentMap& map, std::vector<StreetLamp> lamps)
    : is_map_(true), table_(table_of(map)), lamps_(std::move(lamps)) {}

Rgb Lights::falling(Vec3 direction) const { return direction.z < 0 && !is_map_ ? below_ : table_.radiance(direction); }

Vec3 Lights::sample_sun(UnitPair chance) const {
  const double cosine = 1 - chance.u * (1 - model_.sun_cos_radius);
  return about_sun_.out_of(direction_at(chance.v, cosine));
}

Rgb Lights::haze(Vec3 direction) const {
  if (is_map_) return {};
  const double place = turn_of(direction) * kAcross;
  const int i = std::min(static_cast<int>(place), kAcross - 1);
  // straight down there is no azimuth
  const double level = direction.x * direction.x + direction.y * direction.y;
  return mixed(haze_mean_, mixed(ring_[i], ring_[i + 1], place - i), level);
}

Rgb Lights::seen(Vec3 direction) const {
  if (direction.z >= 0 || is_map_) return table_.radiance(direction);
  const double depth = std::min(-direction.z / kHorizonBlur_rad, 1.0), share = depth * depth * (3 - 2 * depth);
  if (share >= 1) return haze(direction);
  return mixed(table_.radiance({direction.x, direction.y, 0}), haze(direction), share);
}

Rgb Lights::clearness(double distance_m) const {
  if (is_map_) return {1, 1, 1};
  Rgb clear;
  for (int c = 0; c < 3; ++c) clear[c] = std::exp(-distance_m * kAir_per_m[c]);
  return clear;
}

}  // namespace citykiln::preview
