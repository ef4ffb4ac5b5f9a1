#include "preview/light/light.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "compiler/geometry/trig.h"
#include "compiler/props/luminaire.h"

namespace citykiln::preview {
namespace {

// Cells from which directions are drawn, finer near the horizon: their radiance is that of their middle.
constexpr int kAcross = 128, kDown = 64;

// Reflectance of the sea's body, and the slope of its waves, which see the sky that much above the horizon.
constexpr Rgb kSeaBody = {0.008, 0.02, 0.03};
constexpr double kWaveSlope = 0.12;
// Thick fog is lit as a white floor is, and sends this share of it in every direction.
constexpr double kFogAlbedo = 0.8;
constexpr double kWaterNormal = 0.02;  // Fresnel reflectance at right angles

std::array<float, 3> narrowed(const Rgb& c) {
  return {static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])};
}

DirectionTable table_of(const sky::SkyModel& model) {
  std::vector<double> z_edges;
  for (int row = 0; row <= kDown; ++row) z_edges.push_back(std::pow(static_cast<double>(row) / kDown, 1.5));
  std::vector<std::array<float, 3>> cells;
  for (int row = 0; row < kDown; ++row)
    for (int column = 0; column < kAcross; ++column)
      cells.push_back(narrowed(
          sky::radiance(model, direction_at((column + 0.5) / kAcross, (z_edges[row] + z_edges[row + 1]) / 2))));
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

Lights::Lights(const sky::SkyModel& model, std::vector<StreetLamp> lamps, std::optional<Surroundings> around,
               std::optional<Fog> fog, std::shared_ptr<const Clouds> clouds)
    : model_(model),
      about_sun_(frame_about(unit(model.to_sun))),
      table_(table_of(model)),
      stars_(model.stars),
      around_(std::move(around)),
      fog_(fog),
      clouds_(std::move(clouds)),
      below_(sky::ground_radiance(model)),
      lamps_(std::move(lamps)) {
  if (around_) bound_heights(*around_);
  if (luminance(model.sun_radiance) > 0) sun_solid_angle_ = 2 * kPi * (1 - model.sun_cos_radius);
  if (sun_solid_angle_ > 0 && table_.flux() > 0)
    sun_to_sky_ = luminance(model.sun_radiance) * sun_solid_angle_ / table_.flux();
}

Lights::Lights(const EnvironmentMap& map, std::vector<StreetLamp> lamps)
    : is_map_(true), table_(table_of(map)), lamps_(std::move(lamps)) {}

Lights::Lights(const InsideLights& inside, std::vector<StreetLamp> lamps)
    : table_({0, 1}, 1, {{0, 0, 0}}), inside_(inside), lamps_(std::move(lamps)) {}

Rgb Lights::white() const {
  // about 20 lx: below, lamps light what is seen
  constexpr double kLeast = 1e-3;
  if (inside_ || is_map_) return {};
  if (luminance(model_.white_ground) >= kLeast) return model_.white_ground;
  Rgb sum{};
  for (const StreetLamp& lamp : lamps_) {
    const auto [r, g, b] = props::black_body_colour(lamp.light.temperature_k);
    sum = sum + Rgb{r, g, b} * lamp.light.lumen;
  }
  return sum;
}

Rgb Lights::falling(Vec3 from, Vec3 direction) const {
  if (inside_) return inside_->hull(from, direction).radiance;
  if (is_map_) return table_.radiance(direction);
  if (direction.z < 0) return below_;
  const Rgb sky = sky::radiance(model_, direction);
  if (!clouds_) return sky;
  const CloudVeil veil = clouds_->falling(from, direction);
  return sky * veil.passed + veil.added;
}

Vec3 Lights::sample_sun(UnitPair chance) const {
  const double cosine = 1 - chance.u * (1 - model_.sun_cos_radius);
  return about_sun_.out_of(direction_at(chance.v, cosine));
}

// Stars and the moon, as they are outside of the air. The moon hides stars; the terminator is where the sun is level.
Rgb Lights::bodies(Vec3 direction, double pixel_rad) const {
  const sky::MoonDisk& moon = model_.moon;
  const double off = dot(direction, moon.to_moon);
  if (off < model_.sun_cos_radius || largest_component(moon.radiance) <= 0)
    return stars_.radiance(direction, pixel_rad);
  const Vec3 aside = (direction - moon.to_moon * off) * (1 / sky::kSunRadius_rad);
  const double depth = std::sqrt(std::max(0.0, 1 - dot(aside, aside)));
  const bool is_lit = dot(aside - moon.to_moon * depth, moon.to_sun) > 0;
  return is_lit ? moon.radiance : Rgb{};
}

Rgb Lights::around_at(const Edge& edge, Vec3 direction) const {
  const Vec3 mirrored = unit(Vec3{direction.x, direction.y, -direction.z + kWaveSlope});
  const double grazing = std::pow(1 - mirrored.z, 5), reflectance = kWaterNormal + (1 - kWaterNormal) * grazing;
  const Rgb sea = sky::radiance(model_, mirrored) * reflectance + model_.white_ground * kSeaBody;
  return mixed(model_.white_ground * edge.albedo, sea, edge.sea);
}

Rgb Lights::behind_fog(Vec3 from, Vec3 direction, const Rgb& light) const {
  if (!fog_) return light;
  const double passed = fog_transmittance(*fog_, from, direction, std::numeric_limits<double>::infinity());
  return mixed(model_.white_ground * kFogAlbedo, light, passed);
}

Rgb Lights::seen(Vec3 from, Vec3 direction, double pixel_rad, bool is_camera) const {
  if (inside_) {
    const Seen hull = inside_->hull(from, direction);
    const sky::AirPath path = inside_->air(from, direction, hull.distance_m);
    return path.added + path.passed * hull.radiance;
  }
  if (is_map_) return table_.radiance(direction);
  if (around_)
    if (const auto ground = meet_ground(*around_, from, direction)) {
      const sky::AirPath path = air(from, direction, ground->distance_m);
      return path.added + path.passed * around_at(ground->edge, direction);
    }
  const Rgb sky = sky::radiance(model_, direction);
  const Rgb behind = is_camera && direction.z >= 0 ? bodies(direction, pixel_rad) : Rgb{};
  constexpr double kFarthest_m = 2e5;  // beyond is no air, but for rays along the ground
  const Rgb all = largest_component(behind) > 0 ? sky + behind * sky::air(model_, direction, kFarthest_m).passed : sky;
  if (!clouds_) return behind_fog(from, direction, all);
  const CloudPath clouds = clouds_->seen(from, direction, std::numeric_limits<double>::infinity(), is_camera);
  if (clouds.passed >= 1) return behind_fog(from, direction, all);
  const CloudVeil veil = veil_of(clouds, clear_air(from, direction, clouds.distance_m));
  return behind_fog(from, direction, all * veil.passed + veil.added);
}

std::optional<double> Lights::ground_m(Vec3 from, Vec3 direction) const {
  if (inside_) return inside_->hull(from, direction).distance_m;
  if (is_map_) return std::nullopt;
  if (around_) {
    const auto ground = meet_ground(*around_, from, direction);
    return ground ? std::optional(ground->distance_m) : std::nullopt;
  }
  const bool sees_sea = !model_.domes.empty() && model_.domes.front()->sees_sea(direction);
  return sees_sea ? std::optional(model_.domes.front()->sea_m(direction)) : std::nullopt;
}

sky::AirPath Lights::air(Vec3 from, Vec3 direction, double distance_m) const {
  sky::AirPath path = clear_air(from, direction, distance_m);
  if (!clouds_) return path;
  const CloudPath clouds = clouds_->seen(from, direction, distance_m, false);
  if (clouds.passed >= 1) return path;
  const CloudVeil veil = veil_of(clouds, clear_air(from, direction, clouds.distance_m));
  return {path.passed * clouds.passed, path.added * clouds.passed + veil.added};
}

sky::AirPath Lights::clear_air(Vec3 from, Vec3 direction, double distance_m) const {
  if (is_map_) return {};
  if (inside_) return inside_->air(from, direction, distance_m);
  sky::AirPath path = sky::air(model_, direction, distance_m);
  if (!fog_) return path;
  const double passed = fog_transmittance(*fog_, from, direction, distance_m);
  return {path.passed * passed, mixed(model_.white_ground * kFogAlbedo, path.added, passed)};
}

}  // namespace citykiln::preview
