#include "compiler/sky/atmosphere/march.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/trig.h"

namespace citykiln::sky {
namespace {

constexpr int kColumnHeights = 64, kColumnDirections = 96, kColumnSteps = 64;

Columns integral(const Air& air, double height_m, double cos_zenith) {
  const double r = kEarth_m + height_m;
  // rays below the horizon by rounding must not stop at the ground
  const double end_m =
      -r * cos_zenith +
      std::sqrt(std::max(0.0, r * r * (cos_zenith * cos_zenith - 1) + (kEarth_m + kTop_m) * (kEarth_m + kTop_m)));
  double sums[3] = {};
  for (int i = 0; i < kColumnSteps; ++i) {
    const double from = static_cast<double>(i) / kColumnSteps, to = static_cast<double>(i + 1) / kColumnSteps;
    const double from_m = from * from * end_m, step_m = to * to * end_m - from_m, at_m = from_m + step_m / 2;
    const double there_m = std::sqrt(r * r + at_m * at_m + 2 * r * at_m * cos_zenith) - kEarth_m;
    const Densities density = densities_at(air, there_m);
    sums[0] += density.molecules * step_m, sums[1] += density.aerosols * step_m, sums[2] += density.ozone * step_m;
  }
  return {static_cast<float>(sums[0]), static_cast<float>(sums[1]), static_cast<float>(sums[2])};
}

float mixed_amount(float a, float b, float share) { return a + (b - a) * share; }
Columns mixed_columns(const Columns& a, const Columns& b, float share) {
  return {mixed_amount(a.molecules, b.molecules, share), mixed_amount(a.aerosols, b.aerosols, share),
          mixed_amount(a.ozone, b.ozone, share)};
}

}  // namespace

double horizon_cosine(double height_m) {
  const double share = kEarth_m / (kEarth_m + std::max(height_m, 0.0));
  return -std::sqrt(std::max(0.0, 1 - share * share));
}

double disk_share(double height_m, double cos_zenith) {
  // near the horizon cosines differ as angles do
  const double share = std::clamp(((cos_zenith - horizon_cosine(height_m)) / kSunRadius_rad + 1) / 2, 0.0, 1.0);
  return share * share * (3 - 2 * share);
}

double way_m(double height_m, double cos_zenith) {
  const double r = kEarth_m + height_m;
  const double flat = r * r * (cos_zenith * cos_zenith - 1);
  if (cos_zenith < horizon_cosine(height_m))
    return -r * cos_zenith - std::sqrt(std::max(0.0, flat + kEarth_m * kEarth_m));
  return -r * cos_zenith + std::sqrt(std::max(0.0, flat + (kEarth_m + kTop_m) * (kEarth_m + kTop_m)));
}

ColumnTable::ColumnTable(const Air& air) {
  for (int i = 0; i < kColumnHeights; ++i) {
    const double root = static_cast<double>(i) / (kColumnHeights - 1), height_m = root * root * kTop_m;
    const double horizon = horizon_cosine(height_m);
    for (int j = 0; j < kColumnDirections; ++j) {
      const double up = static_cast<double>(j) / (kColumnDirections - 1);
      cells_.push_back(integral(air, height_m, horizon + up * up * (1 - horizon)));
    }
  }
}

Columns ColumnTable::at(double height_m, double cos_zenith) const {
  const double horizon = horizon_cosine(height_m);
  const double up = std::sqrt(std::clamp((cos_zenith - horizon) / (1 - horizon), 0.0, 1.0)) * (kColumnDirections - 1);
  const double high = std::sqrt(std::clamp(height_m / kTop_m, 0.0, 1.0)) * (kColumnHeights - 1);
  const int i = std::min(static_cast<int>(high), kColumnHeights - 2),
            j = std::min(static_cast<int>(up), kColumnDirections - 2);
  const Columns* cell = &cells_[static_cast<std::size_t>(i) * kColumnDirections + j];
  const auto across = static_cast<float>(up - j);
  return mixed_columns(mixed_columns(cell[0], cell[1], across),
                       mixed_columns(cell[kColumnDirections], cell[kColumnDirections + 1], across),
                       static_cast<float>(high - i));
}

namespace {

// (1 - e^-x) / x, with the series where the difference would lose its digits.
float mean_share(float x, float share) { return x < 0.01f ? 1 - x * (0.5f - x * (1.0f / 6)) : (1 - share) / x; }

// The factors of the moments, in a direction, for light scattered by molecules and by aerosols: (2 l + 1) g_l / 4π,
// where g_l are the moments of the phase functions, times the factors of the addition theorem.
struct PhaseMoments {
  float molecules[kMoments], aerosols[kMoments];
};
PhaseMoments phase_moments(double z, double x) {
  const MomentBasis basis = moment_basis(z, x);
  PhaseMoments phase;
  for (int i = 0; i < kMoments; ++i) {
    const int degree = kMomentDegrees[i];
    const double shared = basis[i] * kAdditionFactors[i] * (2 * degree + 1) / (4 * kPi);
    constexpr double kOfMolecules[] = {1, 0, 0.1, 0, 0};
    constexpr double kOfAerosols[] = {1, kAsymmetry, kAsymmetry * kAsymmetry, kAsymmetry * kAsymmetry * kAsymmetry,
                                      kAsymmetry * kAsymmetry * kAsymmetry * kAsymmetry};
    phase.molecules[i] = static_cast<float>(shared * kOfMolecules[degree]);
    phase.aerosols[i] = static_cast<float>(shared * kOfAerosols[degree]);
  }
  return phase;
}

}  // namespace

PlaceOnRay place_on(const AirRay& ray, double way_m) {
  const Vec3 at = Vec3{0, 0, kEarth_m + ray.height_m} + ray.direction * way_m;
  const double r = length(at);
  const Vec3 up = at * (1 / r);
  const double source = dot(up, ray.to_source), z = dot(up, ray.direction);
  const double level = std::sqrt(std::max(1e-12, 1 - source * source));
  return {.height_m = std::max(0.0, r - kEarth_m),
          .source_cosine = source,
          .up = z,
          .along = (dot(ray.direction, ray.to_source) - z * source) / level};
}

Bands direct_light(const LitAir& lit, double height_m, double source_cosine) {
  const auto share = static_cast<float>(disk_share(height_m, source_cosine));
  if (share <= 0) return {};
  Bands light = transmitted(lit.coefficients, lit.columns.at(height_m, source_cosine));
  for (float& v : light) v *= share;
  return light;
}

void march(const LitAir& lit, const MarchedSources& sources, const AirRay& ray, double from_m, double to_m,
           MarchedLight& light) {
  const PlaceOnRay place = place_on(ray, (from_m + to_m) / 2);
  const Densities density = densities_at(lit.air, place.height_m);
  const auto step_m = static_cast<float>(to_m - from_m);
  const auto molecules = static_cast<float>(density.molecules), aerosols = static_cast<float>(density.aerosols);
  const auto ozone = static_cast<float>(density.ozone);
  const BandCoefficients c = lit.coefficients;  // a copy, which nothing else can change: loops are vectorised
  Bands reaching;  // the share of what is scattered in this step that gets to the ray's begin, times metres
  for (int b = 0; b < kBands; ++b) {
    const float depth = (c.molecules[b] * molecules + c.aerosols[b] * aerosols + c.ozone[b] * ozone) * step_m;
    const float share = exponential_below(-depth);
    reaching[b] = light.passed[b] * step_m * mean_share(depth, share);
    light.passed[b] *= share;
  }
  if (sources.has_direct && disk_share(place.height_m, place.source_cosine) > 0) {
    const Bands direct = direct_light(lit, place.height_m, place.source_cosine);
    // light that aerosols scattered forwards comes along nearly the same way as direct light
    const float before = lit.columns.at(place.height_m, place.source_cosine).aerosols;
    for (int b = 0; b < kBands; ++b) {
      const float by_aerosols = reaching[b] * c.aerosols_scattered[b] * aerosols * direct[b];
      light.molecules[b] += reaching[b] * c.molecules[b] * molecules * direct[b];
      light.aerosols[b] += by_aerosols;
      light.aerosols_twice[b] += by_aerosols * before * c.aerosols_scattered[b];
    }
  }
  if (sources.field == nullptr) return;
  const Moments moments = sources.field->at(place.height_m, place.source_cosine);
  const PhaseMoments phase = phase_moments(place.up, place.along);
  Bands by_molecules{}, by_aerosols{};
  for (int i = 0; i < kMoments; ++i)
    for (int b = 0; b < kBands; ++b) {
      by_molecules[b] += moments[i][b] * phase.molecules[i];
      by_aerosols[b] += moments[i][b] * phase.aerosols[i];
    }
  for (int b = 0; b < kBands; ++b)
    light.more[b] += reaching[b] * (c.molecules[b] * molecules * by_molecules[b] +
                                    c.aerosols_scattered[b] * aerosols * by_aerosols[b]);
}

double aerosols_glow(double cosine) {
  constexpr double g = kAsymmetry * kAsymmetry;
  const double x = cosine, x2 = x * x;
  const double base = 1 + g * g - 2 * g * x, all = (1 - g * g) / (base * std::sqrt(base));
  const double held = 1 + 3 * g * x + 5 * g * g * (3 * x2 - 1) / 2 + 7 * g * g * g * x * (5 * x2 - 3) / 2 +
                      9 * g * g * g * g * (35 * x2 * x2 - 30 * x2 + 3) / 8;
  return (all - held) / (4 * kPi);
}

MarchedLight march_out(const LitAir& lit, const MarchedSources& sources, const AirRay& ray, int steps) {
  MarchedLight light;
  const double end_m = way_m(ray.height_m, ray.direction.z);
  for (int i = 0; i < steps; ++i) {
    const double from = static_cast<double>(i) / steps, to = static_cast<double>(i + 1) / steps;
    march(lit, sources, ray, from * from * end_m, to * to * end_m, light);
  }
  return light;
}

}  // namespace citykiln::sky
