#include "compiler/sky/atmosphere/town_glow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "compiler/geometry/trig.h"

namespace citykiln::sky {
namespace {

// Sides of cells: the least up to the first distance, then twice as long with each doubling of the distance.
constexpr double kLeastCell_m = 250, kFine_m = 4000;
constexpr double kAllOverLamps = 3, kDirect = 0.15, kReflected = 0.15 * (1 - kDirect);
// Normalises an intensity by the fourth power of the zenith angle (Garstang 1986).
constexpr double kFourth = 0.554;

constexpr int kGlowRows = 12, kGlowColumns = 16, kGlowSteps = 24;
constexpr double kFarthestGlow_m = 60000;

// Rows are nearer to each other at the horizon.
double row_rad(int row) { return kPi / 2 * std::pow(static_cast<double>(row) / (kGlowRows - 1), 1.5); }

struct Cell {
  Vec2 at;
  double side_m = 0, lumen = 0;  // of all outdoor light
};

double side_at_m(double distance_m) {
  double side_m = kLeastCell_m;
  for (double far_m = kFine_m; far_m < distance_m; far_m *= 2) side_m *= 2;
  return side_m;
}

std::vector<Cell> cells_of(std::span<const GroundLight> lights) {
  std::map<std::tuple<double, int, int>, Cell> by_place;
  for (const GroundLight& light : lights) {
    const double distance_m = length(light.from_eye_m), side_m = side_at_m(distance_m);
    if (distance_m > kGlowRadius_m) continue;
    const auto number = [&](double v) { return static_cast<int>(std::floor(v / side_m)); };
    Cell& cell = by_place[{side_m, number(light.from_eye_m.x), number(light.from_eye_m.y)}];
    cell.side_m = side_m;
    cell.at = cell.at + light.from_eye_m * light.lumen, cell.lumen += light.lumen;
  }
  std::vector<Cell> cells;
  for (const auto& [place, cell] : by_place)
    if (cell.lumen > 0) cells.push_back({cell.at * (1 / cell.lumen), cell.side_m, cell.lumen * kAllOverLamps});
  return cells;
}

// One lumen of the lamps' mean colour, in klx per steradian where it shines on a square metre.
Bands spectrum_of(std::span<const GroundLight> lights) {
  double lumen = 0, kelvin = 0;
  for (const GroundLight& light : lights) lumen += light.lumen, kelvin += light.lumen * light.temperature_k;
  const double mean_k = lumen > 0 ? kelvin / lumen : 3000;
  Bands bands;
  for (int b = 0; b < kBands; ++b) bands[b] = static_cast<float>(black_body(nm_of(b), mean_k) / solar(nm_of(b)));
  const Rgb colour = rgb_of(bands);
  const double klx = 0.2126 * colour[0] + 0.7152 * colour[1] + 0.0722 * colour[2];
  for (float& band : bands) band = static_cast<float>(band * 1e-3 / klx);
  return bands;
}

// Columns of air above the ground, by height.
class Above {
 public:
  explicit Above(const Air& air) {
    columns_.push_back({});
    for (int i = 0; i < kLevels; ++i) {
      const Densities d = densities_at(air, (i + 0.5) * kStep_m);
      Columns next = columns_.back();
      next.molecules += static_cast<float>(d.molecules * kStep_m);
      next.aerosols += static_cast<float>(d.aerosols * kStep_m);
      columns_.push_back(next);
    }
  }

  // The columns along a straight way between two heights.
  Columns along(double low_m, double high_m, double way_m) const {
    if (std::abs(high_m - low_m) < 1) high_m = low_m + 1;
    const Columns a = at(low_m), b = at(high_m);
    const auto longer = static_cast<float>(way_m / (high_m - low_m));
    return {(b.molecules - a.molecules) * longer, (b.aerosols - a.aerosols) * longer, 0};
  }

 private:
  static constexpr int kLevels = 700;
  static constexpr double kStep_m = 100;

  Columns at(double height_m) const {
    const double place = std::clamp(height_m / kStep_m, 0.0, kLevels - 0.001);
    const auto low = static_cast<std::size_t>(place);
    const auto part = static_cast<float>(place - static_cast<double>(low));
    const Columns &a = columns_[low], &b = columns_[low + 1];
    return {a.molecules + (b.molecules - a.molecules) * part, a.aerosols + (b.aerosols - a.aerosols) * part, 0};
  }

  std::vector<Columns> columns_;
};

// Candela of a lumen of outdoor light, by zenith angle.
double upward_cd(double cosine) {
  const double zenith = std::acos(std::clamp(cosine, 0.0, 1.0));
  return (2 * kReflected * cosine + kFourth * kDirect * zenith * zenith * zenith * zenith) / (2 * kPi);
}

struct Town {
  Air air;
  BandCoefficients coefficients;
  Above above;
  Bands spectrum;
  std::vector<Cell> cells;
};

// The light of a cell that a metre of air at a place scatters into a direction.
void add_scattered(const Town& town, const Cell& cell, Vec3 place, Vec3 to_eye, const Densities& density, Bands& sum) {
  const Vec3 way = place - at_height(cell.at, 0);
  const double way_m = length(way), cosine = way.z / way_m;
  // nearer than its size a cell is no point
  const double lx = cell.lumen * upward_cd(cosine) / (way_m * way_m + cell.side_m * cell.side_m / 4);
  const double off = dot(way, to_eye) / way_m;
  const double molecules = lx * density.molecules * molecules_phase(off),
               aerosols = lx * density.aerosols * aerosols_phase(off);
  const Bands passed = transmitted(town.coefficients, town.above.along(0, place.z, way_m));
  for (int b = 0; b < kBands; ++b)
    sum[b] += passed[b] * static_cast<float>(molecules * town.coefficients.molecules[b] +
                                             aerosols * town.coefficients.aerosols_scattered[b]);
}

Rgb glow_along(const Town& town, double eye_m, Vec3 direction) {
  Bands light{};
  for (int i = 0; i < kGlowSteps; ++i) {
    const auto way_at = [](double step) { return kFarthestGlow_m * std::pow(step / kGlowSteps, 3); };
    const double from_m = way_at(i), to_m = way_at(i + 1), way_m = (from_m + to_m) / 2;
    const Vec3 place = Vec3{0, 0, eye_m} + direction * way_m;
    Bands scattered{};
    for (const Cell& cell : town.cells)
      add_scattered(town, cell, place, direction * -1, densities_at(town.air, place.z), scattered);
    const Bands passed = transmitted(town.coefficients, town.above.along(eye_m, place.z, way_m));
    for (int b = 0; b < kBands; ++b)
      light[b] += scattered[b] * passed[b] * town.spectrum[b] * static_cast<float>(to_m - from_m);
  }
  Rgb colour = rgb_of(light);
  for (double& c : colour) c = std::max(0.0, c);
  return colour;
}

Vec3 sky_direction(double height_rad, double azimuth_rad) {
  return {std::cos(height_rad) * std::cos(azimuth_rad), std::cos(height_rad) * std::sin(azimuth_rad),
          std::sin(height_rad)};
}

}  // namespace

TownGlow::TownGlow(const Air& air, std::span<const GroundLight> lights, double eye_height_m)
    : cells_(kGlowRows * kGlowColumns) {
  const Town town{air, band_coefficients(air), Above(air), spectrum_of(lights), cells_of(lights)};
  const double eye_m = std::max(2.0, eye_height_m);
  double last_sine = 0;
  for (int row = 0; row < kGlowRows; ++row) {
    // the band of the sky that is nearest to this row, through level ground: the difference of its squared sines
    const double next_sine = row + 1 < kGlowRows ? std::sin((row_rad(row) + row_rad(row + 1)) / 2) : 1;
    const double band_sr = kPi * (next_sine * next_sine - last_sine * last_sine) / kGlowColumns;
    last_sine = next_sine;
    for (int column = 0; column < kGlowColumns; ++column) {
      Rgb& cell = cells_[static_cast<std::size_t>(row * kGlowColumns + column)];
      cell = glow_along(town, eye_m, sky_direction(row_rad(row), 2 * kPi * column / kGlowColumns));
      for (int c = 0; c < 3; ++c) ground_[c] += cell[c] * band_sr;
    }
  }
}

Rgb TownGlow::radiance(Vec3 direction) const {
  const double height_rad = std::asin(std::clamp(direction.z, 0.0, 1.0));
  const double row = (kGlowRows - 1) * std::pow(height_rad / (kPi / 2), 1 / 1.5);
  const double turn = std::atan2(direction.y, direction.x) / (2 * kPi),
               column = (turn < 0 ? turn + 1 : turn) * kGlowColumns;
  const int r = std::clamp(static_cast<int>(row), 0, kGlowRows - 2), c = static_cast<int>(column);
  const double up = std::clamp(row - r, 0.0, 1.0), on = column - c;
  Rgb sum{};
  const auto add = [&](int of_row, int of_column, double share) {
    const Rgb& cell = cells_[static_cast<std::size_t>(of_row * kGlowColumns + of_column % kGlowColumns)];
    for (int i = 0; i < 3; ++i) sum[i] += cell[i] * share;
  };
  add(r, c, (1 - up) * (1 - on)), add(r, c + 1, (1 - up) * on);
  add(r + 1, c, up * (1 - on)), add(r + 1, c + 1, up * on);
  return sum;
}

}  // namespace citykiln::sky
