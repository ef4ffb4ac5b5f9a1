#include "compiler/sky/atmosphere/scattered_field.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/trig.h"
#include "compiler/sky/atmosphere/march.h"

namespace citykiln::sky {
namespace {

// Nodes: heights, finer near the ground, and zenith angles within 12 degrees. These are a degree apart for low sources,
// since twilight falls by half in a degree.
constexpr int kNodeHeights = 16;
constexpr double kHighestNode_m = 75000, kReach_rad = 12 * kPi / 180;
int angles_for(double source_angle_rad) {
  const double above_deg = 90 - source_angle_rad * 180 / kPi;
  return above_deg < 12 ? 25 : above_deg < 30 ? 13 : 7;
}

// Directions: per half of the sphere heights by Gauss and Legendre, and azimuths of the half circle; the other half is
// the mirror image.
constexpr double kGauss[][2] = {{0.0337652429, 0.0856622462}, {0.1693953068, 0.1803807865},
                                {0.3806904070, 0.2339569673}, {0.6193095930, 0.2339569673},
                                {0.8306046932, 0.1803807865}, {0.9662347571, 0.0856622462}};
constexpr int kAzimuths = 6;

// The first sweep gathers light scattered once, each of the others adds at least one order.
constexpr int kSweeps = 5;
constexpr int kFieldSteps = 16;

double height_m(int row) {
  const double root = static_cast<double>(row) / (kNodeHeights - 1);
  return root * root * kHighestNode_m;
}

struct Direction {
  Vec3 to;
  double solid_angle;  // of both mirror images
};
std::vector<Direction> make_directions() {
  std::vector<Direction> directions;
  for (const double side : {-1.0, 1.0})
    for (const auto& [z, weight] : kGauss)
      for (int i = 0; i < kAzimuths; ++i) {
        const double azimuth = kPi * (i + 0.5) / kAzimuths, level = std::sqrt(1 - z * z);
        directions.push_back(
            {{level * std::cos(azimuth), level * std::sin(azimuth), side * z}, 2 * kPi * weight / kAzimuths});
      }
  return directions;
}

// Light from the ground where a ray meets it.
Bands ground_light(const LitAir& lit, const ScatteredField& field, const AirRay& ray) {
  const PlaceOnRay place = place_on(ray, way_m(ray.height_m, ray.direction.z));
  Bands light = direct_light(lit, 0, place.source_cosine);
  const Bands diffuse = field.ground_irradiance(place.source_cosine);
  const auto level = static_cast<float>(std::max(0.0, place.source_cosine));
  const auto reflected = static_cast<float>(lit.air.ground_albedo / kPi);
  for (int b = 0; b < kBands; ++b) light[b] = reflected * (light[b] * level + diffuse[b]);
  return light;
}

// Light along a ray that was scattered once, or by the ground.
Bands gather_once(const LitAir& lit, const AirRay& ray) {
  const MarchedLight marched = march_out(lit, {}, ray, kFieldSteps);
  const double cosine = dot(ray.direction, ray.to_source);
  const auto molecules = static_cast<float>(molecules_phase(cosine));
  const auto aerosols = static_cast<float>(aerosols_phase(cosine));
  Bands sum;
  for (int b = 0; b < kBands; ++b) sum[b] = molecules * marched.molecules[b] + aerosols * marched.aerosols[b];
  return sum;
}

// Light along a ray that was scattered more often, and from the ground behind the air.
Bands gather_more(const LitAir& lit, const ScatteredField& field, const AirRay& ray) {
  const MarchedLight marched = march_out(lit, {.has_direct = false, .field = &field}, ray, kFieldSteps);
  Bands sum = marched.more;
  if (ray.direction.z >= horizon_cosine(ray.height_m)) return sum;
  const Bands ground = ground_light(lit, field, ray);
  for (int b = 0; b < kBands; ++b) sum[b] += marched.passed[b] * ground[b];
  return sum;
}

void add(Moments& moments, const Bands& light, Vec3 d, double solid_angle) {
  const MomentBasis basis = moment_basis(d.z, d.x);
  for (int i = 0; i < kMoments; ++i) {
    const auto weight = static_cast<float>(basis[i] * solid_angle);
    for (int b = 0; b < kBands; ++b) moments[i][b] += weight * light[b];
  }
}

}  // namespace

MomentBasis moment_basis(double z, double x) {
  const double z2 = z * z, x2 = x * x, y2 = std::max(0.0, 1 - z2 - x2);
  const double twice = x2 - y2, thrice = x * (x2 - 3 * y2), four = x2 * x2 - 6 * x2 * y2 + y2 * y2;
  return {1,
          z,
          x,
          (3 * z2 - 1) / 2,
          x * z,
          twice,
          z * (5 * z2 - 3) / 2,
          x * (5 * z2 - 1),
          z * twice,
          thrice,
          (35 * z2 * z2 - 30 * z2 + 3) / 8,
          x * z * (7 * z2 - 3),
          (7 * z2 - 1) * twice,
          z * thrice,
          four};
}

ScatteredField::ScatteredField(const LitAir& lit, double source_angle_rad)
    : angles_(angles_for(source_angle_rad)),
      step_rad_(2 * kReach_rad / (angles_ - 1)),
      first_rad_(source_angle_rad - kReach_rad),
      cells_(static_cast<std::size_t>(kNodeHeights) * angles_),
      ground_(angles_) {
  std::vector<Bands> once;
  for (int i = 0; i < kSweeps; ++i) sweep(lit, once);
}

double ScatteredField::angle_rad(int column) const { return first_rad_ + column * step_rad_; }

// The first sweep fills `once` with light that was scattered once, which stays the same.
void ScatteredField::sweep(const LitAir& lit, std::vector<Bands>& once) {
  static const std::vector<Direction> kDirections = make_directions();
  const bool is_first = once.empty();
  std::size_t next = 0;
  for (int column = 0; column < angles_; ++column)
    for (int row = 0; row < kNodeHeights; ++row) {
      const double angle = angle_rad(column);
      Moments moments{};
      Bands ground{};
      for (const Direction& direction : kDirections) {
        const AirRay ray{height_m(row), direction.to, {std::sin(angle), 0, std::cos(angle)}};
        if (is_first) once.push_back(gather_once(lit, ray));
        Bands light = is_first ? Bands{} : gather_more(lit, *this, ray);
        for (int b = 0; b < kBands; ++b) light[b] += once[next][b];
        ++next;
        add(moments, light, direction.to, direction.solid_angle);
        const auto level = static_cast<float>(std::max(0.0, direction.to.z) * direction.solid_angle);
        for (int b = 0; b < kBands; ++b) ground[b] += level * light[b];
      }
      cells_[static_cast<std::size_t>(row) * angles_ + column] = moments;
      if (row == 0) ground_[column] = ground;
    }
}

int ScatteredField::column_of(double source_cosine, float& share) const {
  const double angle = std::acos(std::clamp(source_cosine, -1.0, 1.0));
  const double place = std::clamp((angle - first_rad_) / step_rad_, 0.0, angles_ - 1.0);
  const int column = std::min(static_cast<int>(place), angles_ - 2);
  share = static_cast<float>(place - column);
  return column;
}

Moments ScatteredField::at(double at_m, double source_cosine) const {
  float across;
  const int column = column_of(source_cosine, across);
  const double high = std::sqrt(std::clamp(at_m / kHighestNode_m, 0.0, 1.0)) * (kNodeHeights - 1);
  const int row = std::min(static_cast<int>(high), kNodeHeights - 2);
  const auto up = static_cast<float>(high - row);
  const Moments* low = &cells_[static_cast<std::size_t>(row) * angles_ + column];
  Moments mixed;
  const float w[] = {(1 - up) * (1 - across), (1 - up) * across, up * (1 - across), up * across};
  for (int i = 0; i < kMoments; ++i)
    for (int b = 0; b < kBands; ++b)
      mixed[i][b] =
          w[0] * low[0][i][b] + w[1] * low[1][i][b] + w[2] * low[angles_][i][b] + w[3] * low[angles_ + 1][i][b];
  return mixed;
}

Bands ScatteredField::ground_irradiance(double source_cosine) const {
  float across;
  const int column = column_of(source_cosine, across);
  Bands mixed;
  for (int b = 0; b < kBands; ++b) mixed[b] = (1 - across) * ground_[column][b] + across * ground_[column + 1][b];
  return mixed;
}

}  // namespace citykiln::sky
