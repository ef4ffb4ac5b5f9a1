#include "tests/charts/sky_reference.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <optional>

#include "compiler/contract/system/for_each_slot.h"
#include "compiler/sky/generate.h"

namespace citykiln::charts {
namespace {

using sky::Air;
using sky::Densities;
using sky::kEarth_m;
using sky::kTop_m;

constexpr double kPi = std::numbers::pi;
constexpr int kWavelengths = 40, kGreen = 17;  // 385, 395 … 775 nm; 555 nm
constexpr int kSteps = 120, kSunSteps = 64, kMostPlaces = 24, kSurePlaces = 4;
using Spectrum = std::array<double, kWavelengths>;

double nm_of(int i) { return 385 + 10.0 * i; }

/// A stream of numbers in [0, 1). SplitMix64 (Steele, Lea, Flood 2014).
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : state_(seed) {}
  double next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t state_;
};

struct World {
  Air air;
  Vec3 to_sun;
  std::array<sky::Coefficients, kWavelengths> coefficients;
};

double height_m(Vec3 at) { return std::max(0.0, length(at) - kEarth_m); }

// Distances at which a ray meets a sphere about the Earth's middle, near and far.
std::optional<std::pair<double, double>> meets(Vec3 from, Vec3 direction, double radius_m) {
  const double b = dot(from, direction), d = b * b - dot(from, from) + radius_m * radius_m;
  if (d < 0) return std::nullopt;
  return std::pair(-b - std::sqrt(d), -b + std::sqrt(d));
}

bool hits_ground(Vec3 from, Vec3 direction) {
  const auto hit = meets(from, direction, kEarth_m);
  return hit && hit->first > 1e-3;
}

struct Columns {
  double molecules = 0, aerosols = 0, ozone = 0;
  void add(const Densities& d, double m) {
    molecules += d.molecules * m, aerosols += d.aerosols * m, ozone += d.ozone * m;
  }
};

double passed(const sky::Coefficients& c, const Columns& columns) {
  return std::exp(-c.molecules * columns.molecules - c.aerosols * columns.aerosols - c.ozone * columns.ozone);
}

// Sunlight that reaches a place.
Spectrum sunlight(const World& world, Vec3 at) {
  Spectrum light{};
  const double up = dot(at, world.to_sun) / length(at), r = std::max(length(at), kEarth_m);
  const double above_rad = std::asin(up) + std::acos(std::min(1.0, kEarth_m / r));
  const double seen = std::clamp((above_rad / sky::kSunRadius_rad + 1) / 2, 0.0, 1.0);
  if (seen <= 0) return light;
  const auto outside = meets(at, world.to_sun, kEarth_m + kTop_m);
  Columns columns;
  for (int i = 0; i < kSunSteps; ++i) {
    const double from = static_cast<double>(i) / kSunSteps, to = (i + 1.0) / kSunSteps;
    const double from_m = from * from * outside->second, step_m = to * to * outside->second - from_m;
    columns.add(densities_at(world.air, height_m(at + world.to_sun * (from_m + step_m / 2))), step_m);
  }
  // the share of a disk above a level line
  const double chord = 2 * seen - 1;
  const double share = 0.5 + (chord * std::sqrt(1 - chord * chord) + std::asin(chord)) / kPi;
  for (int i = 0; i < kWavelengths; ++i) light[i] = share * passed(world.coefficients[i], columns);
  return light;
}

struct Step {
  double from_m, length_m;
  Densities density;
  Columns before;
  double weight;
};

// A place along a ray where light is scattered, or the ground.
struct ScatteringPlace {
  double at_m, pdf;
  bool is_ground;
  Densities density;
  Columns columns;
};

std::optional<ScatteringPlace> draw_scattering_place(const World& world, Vec3 from, Vec3 direction, Chance& chance) {
  const bool is_ground = hits_ground(from, direction);
  const auto outside = meets(from, direction, kEarth_m + kTop_m);
  if (!outside || outside->second <= 0) return std::nullopt;
  const double end_m = is_ground ? meets(from, direction, kEarth_m)->first : outside->second;
  const sky::Coefficients& green = world.coefficients[kGreen];
  std::array<Step, kSteps> steps;
  Columns columns;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double a = static_cast<double>(i) / kSteps, b = (i + 1.0) / kSteps;
    const double from_m = a * a * end_m, step_m = b * b * end_m - from_m;
    const Vec3 middle = from + direction * (from_m + step_m / 2);
    const Densities density = densities_at(world.air, height_m(middle));
    const bool is_lit = !hits_ground(middle, world.to_sun);
    const double scattered = green.molecules * density.molecules + (green.aerosols - green.absorbed) * density.aerosols;
    steps[i] = {from_m, step_m, density, columns, scattered * passed(green, columns) * (is_lit ? 1 : 0.15)};
    sum += steps[i].weight * step_m;
    columns.add(density, step_m);
  }
  const double ground = is_ground ? 0.3 * passed(green, columns) : 0, all = sum + ground;
  if (!(all > 0)) return std::nullopt;
  double wanted = chance.next() * all;
  for (const Step& step : steps) {
    const double of_step = step.weight * step.length_m;
    if (wanted < of_step) {
      const double within_m = wanted / step.weight;
      Columns reached = step.before;
      reached.add(step.density, within_m);
      return ScatteringPlace{step.from_m + within_m, step.weight / all, false, step.density, reached};
    }
    wanted -= of_step;
  }
  if (!is_ground) return std::nullopt;
  return ScatteringPlace{end_m, ground / all, true, {}, columns};
}

Vec3 about(Vec3 axis, double cosine, double turn) {
  const Vec3 side = unit(cross(std::abs(axis.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0}, axis)),
             other = cross(axis, side);
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine)), angle = 2 * kPi * turn;
  return unit(axis * cosine + side * (sine * std::cos(angle)) + other * (sine * std::sin(angle)));
}

// The cosine of scattering: uniform for half of the molecules' share, since their phase is nearly so.
double draw_cosine(bool is_aerosol, double chance) {
  if (!is_aerosol) return 2 * chance - 1;
  constexpr double g = sky::kAsymmetry;
  const double t = (1 - g * g) / (1 - g + 2 * g * chance);
  return std::clamp((1 + g * g - t * t) / (2 * g), -1.0, 1.0);
}

Spectrum path_light(const World& world, Vec3 direction, Chance& chance) {
  Spectrum light{}, carried;
  carried.fill(1);
  Vec3 from{0, 0, kEarth_m};
  for (int places = 0; places < kMostPlaces; ++places) {
    const std::optional<ScatteringPlace> place = draw_scattering_place(world, from, direction, chance);
    if (!place) break;
    const Vec3 at = from + direction * place->at_m;
    const Spectrum sun = sunlight(world, at);
    for (int i = 0; i < kWavelengths; ++i) carried[i] *= passed(world.coefficients[i], place->columns) / place->pdf;
    if (place->is_ground) {
      const Vec3 up = unit(at);
      const double level = std::max(0.0, dot(up, world.to_sun));
      for (int i = 0; i < kWavelengths; ++i) {
        carried[i] *= world.air.ground_albedo;
        light[i] += carried[i] * sun[i] * level / kPi;
      }
      direction = about(up, std::sqrt(chance.next()), chance.next());
      from = at + up * 0.1;
    } else {
      const double to_sun = dot(direction, world.to_sun);
      const sky::Coefficients& green = world.coefficients[kGreen];
      const double molecules = green.molecules * place->density.molecules;
      const double aerosols = (green.aerosols - green.absorbed) * place->density.aerosols;
      const double share = aerosols / (molecules + aerosols);
      const double cosine = draw_cosine(chance.next() < share, chance.next());
      const double pdf = (1 - share) / (4 * kPi) + share * sky::aerosols_phase(cosine);
      for (int i = 0; i < kWavelengths; ++i) {
        const sky::Coefficients& c = world.coefficients[i];
        const double m = c.molecules * place->density.molecules,
                     a = (c.aerosols - c.absorbed) * place->density.aerosols;
        light[i] += carried[i] * sun[i] * (m * sky::molecules_phase(to_sun) + a * sky::aerosols_phase(to_sun));
        carried[i] *= (m * sky::molecules_phase(cosine) + a * sky::aerosols_phase(cosine)) / pdf;
      }
      direction = about(direction, cosine, chance.next());
      from = at;
    }
    if (places < kSurePlaces) continue;
    const double kept = std::clamp(carried[kGreen], 0.05, 0.9);
    if (chance.next() >= kept) break;
    for (double& c : carried) c /= kept;
  }
  return light;
}

World world_of(const Air& air, Vec3 to_sun) {
  World world{air, to_sun, {}};
  for (int i = 0; i < kWavelengths; ++i) world.coefficients[i] = coefficients_at(air, nm_of(i));
  return world;
}

sky::Rgb rgb_of(const Spectrum& light) {
  sky::Rgb xyz{};
  for (int i = 0; i < kWavelengths; ++i) {
    const sky::Rgb cie = sky::matching(nm_of(i));
    for (int c = 0; c < 3; ++c) xyz[c] += cie[c] * light[i] * sky::solar(nm_of(i)) * 10;
  }
  return sky::rgb_of_xyz(xyz);
}

}  // namespace

sky::Rgb reference_radiance(const Air& air, Vec3 to_sun, Vec3 direction, int paths) {
  const World world = world_of(air, to_sun);
  Chance chance(7);
  Spectrum sum{};
  for (int path = 0; path < paths; ++path) {
    const Spectrum light = path_light(world, direction, chance);
    for (int i = 0; i < kWavelengths; ++i) sum[i] += light[i] / paths;
  }
  return rgb_of(sum);
}

std::vector<double> sky_errors(const sky::Sky& sky, int rings, int paths, int threads) {
  constexpr double kAzimuths_deg[] = {3, 30, 60, 90, 135, 180};
  constexpr int kAround = static_cast<int>(std::size(kAzimuths_deg));
  const Air air = air_of(sky);
  const sky::SkyModel model = sky::generate(sky);
  const double of_sun = std::atan2(sky.to_sun.y, sky.to_sun.x);
  std::vector<double> errors(static_cast<std::size_t>(rings) * kAround);
  for_each_index(errors.size(), threads, [&](std::size_t i) {
    // closer to each other near the horizon
    const double root = static_cast<double>(i / kAround) / std::max(1, rings - 1);
    const double height = (0.5 + root * root * 87.5) * kPi / 180;
    const double azimuth = of_sun + kAzimuths_deg[i % kAround] * kPi / 180, level = std::cos(height);
    const Vec3 direction{level * std::cos(azimuth), level * std::sin(azimuth), std::sin(height)};
    const double reference = luminance(reference_radiance(air, sky.to_sun, direction, paths));
    // without airglow
    errors[i] = std::abs(luminance(model.domes.front()->radiance(direction)) / reference - 1);
  });
  std::ranges::sort(errors);
  return errors;
}

sky::Rgb reference_transmittance(const Air& air, double eye_m, Vec3 direction, double distance_m) {
  const World world = world_of(air, {0, 0, 1});
  constexpr int kFine = 2000;
  Columns columns;
  for (int i = 0; i < kFine; ++i) {
    const Vec3 at = Vec3{0, 0, kEarth_m + eye_m} + direction * (distance_m * (i + 0.5) / kFine);
    columns.add(densities_at(air, height_m(at)), distance_m / kFine);
  }
  Spectrum light, all;
  all.fill(1);
  for (int i = 0; i < kWavelengths; ++i) light[i] = passed(world.coefficients[i], columns);
  const sky::Rgb lit = rgb_of(light), white = rgb_of(all);
  return {lit[0] / white[0], lit[1] / white[1], lit[2] / white[2]};
}

}  // namespace citykiln::charts
