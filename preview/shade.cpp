#include "preview/shade.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace citykiln::preview {
namespace {

using Rgb = std::array<double, 3>;
constexpr double kPi = std::numbers::pi;

// Surfaces smoother than this mirror the sky as well as being coloured.
constexpr float kMirrorRoughness = 0.3f;
// Of water and window glass at normal incidence.
constexpr double kMirrorF0 = 0.02, kGlassF0 = 0.06;
// Visibility on a clear day is some 150 km (Koschmieder: 3.9 over the extinction).
constexpr double kHaze_per_m = 1.0 / 38000;
// No sample counts more than this: rare paths by mirrors into the sun would stay as white dots.
constexpr double kBrightest = 12;

Rgb operator*(const Rgb& a, const Rgb& b) { return {a[0] * b[0], a[1] * b[1], a[2] * b[2]}; }
Rgb operator*(const Rgb& a, double s) { return {a[0] * s, a[1] * s, a[2] * s}; }
void add(Rgb& a, const Rgb& b) {
  for (int c = 0; c < 3; ++c) a[c] += b[c];
}

struct Frame {
  Vec3 tangent, bitangent;
};

// Duff et al., "Building an orthonormal basis, revisited", JCGT 6, 2017.
Frame frame_about(Vec3 n) {
  const double sign = std::copysign(1.0, n.z), a = -1 / (sign + n.z), b = n.x * n.y * a;
  return {{1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}};
}

Vec3 around(Vec3 axis, double cos_angle, double turn) {
  const Frame f = frame_about(axis);
  const double s = std::sqrt(std::max(0.0, 1 - cos_angle * cos_angle));
  return unit(f.tangent * (s * std::cos(turn)) + f.bitangent * (s * std::sin(turn)) + axis * cos_angle);
}

Vec3 cosine_direction(Vec3 n, PathDraw& draw) {
  const double cos_angle = std::sqrt(1.0 - draw.next());
  return around(n, cos_angle, 2 * kPi * draw.next());
}

Vec3 sun_direction(const sky::Dome& dome, PathDraw& draw) {
  const double cos_angle = 1 - draw.next() * (1 - dome.sun_cos_radius);
  return around(dome.to_sun, cos_angle, 2 * kPi * draw.next());
}

bool is_water(materials::Material m) { return m == materials::Material::kWater || m == materials::Material::kSea; }

// Small waves: the slopes of a few sines that run across each other, fading with distance as they fall below a pixel.
Vec3 wave_normal(Vec3 position, double distance_m) {
  constexpr double kWaves[5][4] = {{0.9, 0.35, 0.020, 0}, {-0.5, 0.8, 0.022, 1.7}, {1.9, -1.3, 0.016, 4.1}, {2.7, 2.3, 0.012, 2.2}, {0.21, -0.13, 0.012, 5.3}};
  double dx = 0, dy = 0;
  for (const auto& wave : kWaves) {
    const double slope = wave[2] * std::cos(wave[0] * position.x + wave[1] * position.y + wave[3]), k = std::sqrt(wave[0] * wave[0] + wave[1] * wave[1]);
    dx += slope * wave[0] / k, dy += slope * wave[1] / k;
  }
  const double fade = 1 / (1 + distance_m / 400);
  return unit(Vec3{-dx * fade, -dy * fade, 1});
}

Rgb horizon_light(const sky::Dome& dome, Vec3 direction) {
  const Vec3 level{direction.x, direction.y, 0.15};
  return sky::radiance(dome, unit(level));
}

// What a ray that meets nothing sees.
Rgb background(const sky::Dome& dome, Vec3 direction) {
  return direction.z >= 0 ? sky::radiance(dome, direction) : horizon_light(dome, direction) * 0.9;
}

// Light that arrives straight from the sun, times cosine over pi.
Rgb sunlight(const Stage& stage, const Hit& hit, PathDraw& draw) {
  const Vec3 to_sun = sun_direction(stage.dome, draw);
  const double cosine = dot(hit.shading_normal, to_sun);
  if (cosine <= 0 || dot(hit.geometric_normal, to_sun) <= 0 || stage.world.is_blocked(leave(hit, to_sun), to_sun)) return {};
  const double solid_angle = 2 * kPi * (1 - stage.dome.sun_cos_radius);
  return stage.dome.sun_radiance * (cosine * solid_angle / kPi);
}

double fresnel(double f0, double cosine) { return f0 + (1 - f0) * std::pow(1 - std::clamp(cosine, 0.0, 1.0), 5); }

Vec3 mirrored(Vec3 d, Vec3 n) { return d - n * (2 * dot(d, n)); }

// The mirror's share of the light at a smooth surface, and where it looks.
struct Mirror {
  double share = 0;
  Vec3 direction;
};

Mirror mirror_of(const Hit& hit, Vec3 direction) {
  if (hit.roughness >= kMirrorRoughness) return {};
  const Vec3 normal = is_water(hit.material) ? wave_normal(hit.position, hit.distance_m) : hit.shading_normal;
  Vec3 out = unit(mirrored(direction, normal));
  // a wave's far side would mirror the ground's inside
  if (dot(out, hit.geometric_normal) < 0.01) out = unit(out + hit.geometric_normal * (0.02 - dot(out, hit.geometric_normal)));
  return {fresnel(is_water(hit.material) ? kMirrorF0 : kGlassF0, -dot(direction, normal)), out};
}

}  // namespace

std::array<double, 3> trace(const Stage& stage, Vec3 from, Vec3 direction, PathDraw& draw) {
  Rgb light{}, weight{1, 1, 1};
  for (int bounce = 0; bounce <= stage.bounces; ++bounce) {
    const auto hit = stage.world.first_hit(from, direction);
    if (!hit) {
      add(light, weight * background(stage.dome, direction));
      break;
    }
    if (bounce == 0) {
      const double clear = std::exp(-hit->distance_m * kHaze_per_m);
      add(light, weight * (horizon_light(stage.dome, direction) * (1 - clear)));
      weight = weight * clear;
    }
    if (const Mirror mirror = mirror_of(*hit, direction); mirror.share > 0) {
      // both ways at the first smooth surface, so that water does not sparkle with the choice; none of it after a diffuse bounce
      const Stage shorter{stage.world, stage.dome, std::min(stage.bounces - 1, 1)};
      if (bounce == 0 && stage.bounces > 0) add(light, weight * (trace(shorter, leave(*hit, mirror.direction), mirror.direction, draw) * mirror.share));
      weight = weight * (1 - mirror.share);
    }
    weight = weight * Rgb{hit->albedo[0], hit->albedo[1], hit->albedo[2]};
    add(light, weight * sunlight(stage, *hit, draw));
    direction = cosine_direction(hit->shading_normal, draw);
    if (dot(direction, hit->geometric_normal) <= 0) break;
    from = leave(*hit, direction);
  }
  for (double& c : light) c = std::min(c, kBrightest);
  return light;
}

}  // namespace citykiln::preview
