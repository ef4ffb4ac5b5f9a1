// After Hillaire, "A Scalable and Production Ready Sky and Atmosphere Rendering Technique", EGSR 2020: a table of the
// sky for one eye, and a volume of light in the air. Different: twelve wavelengths, and light that was scattered before
// comes from ScatteredField.
#include "compiler/sky/atmosphere/sky_dome.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/trig.h"

namespace citykiln::sky {
namespace {

constexpr int kSkyRows = 72, kSkyColumns = 40, kSkySteps = 40;
constexpr int kAirRows = 61, kAirColumns = 17, kDistances = 24;
constexpr double kFarthestAir_m = 200000;

Vec3 along(double angle_rad, double azimuth_rad) {
  return {std::cos(angle_rad) * std::cos(azimuth_rad), std::cos(angle_rad) * std::sin(azimuth_rad),
          std::sin(angle_rad)};
}

double distance_m(int slice) {
  const double root = static_cast<double>(slice) / (kDistances - 1);
  return root * root * kFarthestAir_m;
}

// Heights of rows of air: finer near 0.
double air_angle_rad(int row) {
  const double side = 2.0 * row / (kAirRows - 1) - 1;
  return side * std::abs(side) * kPi / 2;
}
double air_row(double angle_rad) {
  const double side = std::sqrt(std::abs(angle_rad) / (kPi / 2));
  return (std::copysign(side, angle_rad) + 1) / 2 * (kAirRows - 1);
}

Vec3 in_xz_plane(Vec3 to_source) { return {std::sqrt(std::max(0.0, 1 - to_source.z * to_source.z)), 0, to_source.z}; }

std::array<float, 3> narrowed(const Rgb& light, double scale) {
  std::array<float, 3> narrow;
  for (int c = 0; c < 3; ++c) narrow[c] = static_cast<float>(std::max(0.0, light[c] * scale));
  return narrow;
}

template <typename Table>
auto mixed_tables(const Table& a, const Table& b, float share) {
  Table sum;
  for (std::size_t c = 0; c < a.size(); ++c) sum[c] = a[c] + (b[c] - a[c]) * share;
  return sum;
}

}  // namespace

SkyDome::Light SkyDome::light_of(const MarchedLight& marched, double cosine, double scale) {
  Bands smooth = marched.more;
  const auto phase = static_cast<float>(molecules_phase(cosine));
  const auto glow = static_cast<float>(aerosols_glow(cosine));
  for (int b = 0; b < kBands; ++b) smooth[b] += phase * marched.molecules[b] + glow * marched.aerosols_twice[b];
  return {narrowed(rgb_of(smooth), scale), narrowed(rgb_of(marched.aerosols), scale)};
}

SkyDome::SkyDome(const LitAir& lit, Vec3 to_source, double eye_height_m, double irradiance)
    : to_source_(unit(to_source)),
      eye_height_m_(std::clamp(eye_height_m, 0.0, 20000.0)),
      irradiance_(irradiance),
      horizon_rad_(std::asin(horizon_cosine(eye_height_m_))) {
  const ScatteredField field(lit, std::acos(std::clamp(to_source_.z, -1.0, 1.0)));
  const Bands diffuse = field.ground_irradiance(to_source_.z);
  Bands level = direct_light(lit, 0, to_source_.z);
  for (int b = 0; b < kBands; ++b) level[b] = level[b] * static_cast<float>(std::max(0.0, to_source_.z)) + diffuse[b];
  const Rgb ground = rgb_of(level), direct = rgb_of(direct_light(lit, eye_height_m_, to_source_.z));
  for (int c = 0; c < 3; ++c) {
    ground_[c] = std::max(0.0, ground[c]) * irradiance_;
    direct_[c] = std::max(0.0, direct[c]) * irradiance_;
  }
  fill_sky(lit, field);
  fill_air(lit, field);
}

void SkyDome::fill_sky(const LitAir& lit, const ScatteredField& field) {
  const Vec3 to_source = in_xz_plane(to_source_);
  for (int row = 0; row < kSkyRows; ++row) {
    const double root = static_cast<double>(row) / (kSkyRows - 1);
    // the lowest row is just above the horizon, whatever rounding does
    const double angle = horizon_rad_ + std::max(1e-6, root * root * (kPi / 2 - horizon_rad_));
    for (int column = 0; column < kSkyColumns; ++column) {
      const Vec3 direction = along(angle, kPi * column / (kSkyColumns - 1));
      const MarchedLight light = march_out(lit, {.field = &field}, {eye_height_m_, direction, to_source}, kSkySteps);
      sky_.push_back(light_of(light, dot(direction, to_source), irradiance_));
    }
  }
}

void SkyDome::fill_air(const LitAir& lit, const ScatteredField& field) {
  const Vec3 to_source = in_xz_plane(to_source_);
  const Rgb white = rgb_of(filled(1));
  for (int row = 0; row < kAirRows; ++row)
    for (int column = 0; column < kAirColumns; ++column) {
      const Vec3 direction = along(air_angle_rad(row), kPi * column / (kAirColumns - 1));
      const AirRay ray{eye_height_m_, direction, to_source};
      MarchedLight light;
      double from_m = 0;
      for (int slice = 0; slice < kDistances; ++slice) {
        // the first slice has the limit at 0; below the sea the air goes on as at its surface, so that rows beside the
        // horizon can be interpolated
        const double slice_m = std::max(1.0, distance_m(slice));
        march(lit, {.field = &field}, ray, from_m, slice_m, light);
        from_m = slice_m;
        air_.push_back(light_of(light, dot(direction, to_source), irradiance_ / slice_m));
        if (column > 0) continue;
        const Rgb passed = rgb_of(light.passed);
        Rgb depth;
        for (int c = 0; c < 3; ++c) depth[c] = -std::log(std::clamp(passed[c] / white[c], 1e-9, 1.0));
        depth_.push_back(narrowed(depth, 1 / slice_m));
      }
    }
}

SkyDome::Cell SkyDome::azimuth_cell(Vec3 direction, int columns) const {
  const double level = (direction.x * direction.x + direction.y * direction.y) *
                       (to_source_.x * to_source_.x + to_source_.y * to_source_.y);
  const double cosine = (direction.x * to_source_.x + direction.y * to_source_.y) / std::sqrt(std::max(level, 1e-30));
  const double place = std::acos(std::clamp(cosine, -1.0, 1.0)) / kPi * (columns - 1);
  const int index = std::min(static_cast<int>(place), columns - 2);
  return {index, place - index};
}

Rgb SkyDome::with_phase(const Light& light, Vec3 direction) const {
  const double phase = aerosols_phase(dot(direction, to_source_));
  Rgb sum;
  for (int c = 0; c < 3; ++c) sum[c] = light.smooth[c] + phase * light.aerosols[c];
  return sum;
}

Rgb SkyDome::radiance(Vec3 direction) const {
  const double angle = std::asin(std::clamp(direction.z, -1.0, 1.0)) - horizon_rad_;
  const double up = std::sqrt(std::clamp(angle / (kPi / 2 - horizon_rad_), 0.0, 1.0)) * (kSkyRows - 1);
  const int row = std::min(static_cast<int>(up), kSkyRows - 2);
  const Cell across = azimuth_cell(direction, kSkyColumns);
  const auto u = static_cast<float>(across.share), v = static_cast<float>(up - row);
  const Light* low = &sky_[static_cast<std::size_t>(row) * kSkyColumns + across.index];
  const Light* high = low + kSkyColumns;
  return with_phase(
      {mixed_tables(mixed_tables(low[0].smooth, low[1].smooth, u), mixed_tables(high[0].smooth, high[1].smooth, u), v),
       mixed_tables(mixed_tables(low[0].aerosols, low[1].aerosols, u),
                    mixed_tables(high[0].aerosols, high[1].aerosols, u), v)},
      direction);
}

AirPath SkyDome::air(Vec3 direction, double distance_m) const {
  const double way = std::clamp(distance_m, 0.0, kFarthestAir_m);
  const double along = std::sqrt(way / kFarthestAir_m) * (kDistances - 1);
  const int slice = std::min(static_cast<int>(along), kDistances - 2);
  const double high = air_row(std::asin(std::clamp(direction.z, -1.0, 1.0)));
  const int row = std::min(static_cast<int>(high), kAirRows - 2);
  const Cell across = azimuth_cell(direction, kAirColumns);
  const auto w = static_cast<float>(along - slice), u = static_cast<float>(across.share),
             v = static_cast<float>(high - row);
  Light light;
  const auto mix = [&](auto member) {
    const auto line = [&](int at_row, int column) {
      const Light* cell = &air_[(static_cast<std::size_t>(at_row) * kAirColumns + column) * kDistances + slice];
      return mixed_tables(cell[0].*member, cell[1].*member, w);
    };
    return mixed_tables(mixed_tables(line(row, across.index), line(row, across.index + 1), u),
                        mixed_tables(line(row + 1, across.index), line(row + 1, across.index + 1), u), v);
  };
  light.smooth = mix(&Light::smooth), light.aerosols = mix(&Light::aerosols);
  const std::array<float, 3>* depths = &depth_[static_cast<std::size_t>(row) * kDistances + slice];
  const auto depth = mixed_tables(mixed_tables(depths[0], depths[1], w),
                                  mixed_tables(depths[kDistances], depths[kDistances + 1], w), v);
  AirPath path{.added = with_phase(light, direction)};
  for (int c = 0; c < 3; ++c) {
    path.passed[c] = std::exp(-depth[c] * way);
    path.added[c] *= way;
  }
  return path;
}

}  // namespace citykiln::sky
