#include "preview/surface/specular.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "preview/surface/water_waves.h"

namespace citykiln::preview {
namespace {

constexpr float kSmooth = 0.3f;

// Reflectances for refractive indices 1.33 and 1.5; a window has two panes with two faces each, half of whose light is
// seen.
constexpr double kWaterF0 = 0.02, kGlassF0 = 0.08;

// With a smaller width the sun's highlight is narrower than its disk and only adds noise.
constexpr double kLeastAlpha = 0.01;

bool is_water(materials::Material m) { return m == materials::Material::kWater || m == materials::Material::kSea; }

double schlick(double f0, double cosine) {
  const double c = 1 - std::clamp(cosine, 0.0, 1.0);
  return f0 + (1 - f0) * c * c * c * c * c;
}

// Smith's masking: the share of facets visible from a direction at this cosine.
double seen(double alpha, double cosine) {
  const double a2 = alpha * alpha, c2 = cosine * cosine;
  return 2 * cosine / (cosine + std::sqrt(a2 + (1 - a2) * c2));
}

Vec3 mirrored(Vec3 to_eye, Vec3 normal) { return normal * (2 * dot(to_eye, normal)) - to_eye; }

// The normal, turned towards the eye if it faces away.
Vec3 facing(Vec3 normal, Vec3 to_eye) {
  constexpr double kLeast = 0.01;
  const double cosine = dot(normal, to_eye);
  return cosine >= kLeast ? normal : unit(normal + to_eye * (kLeast - cosine));
}

}  // namespace

bool is_smooth(const Hit& hit) { return hit.roughness < kSmooth; }

SpecularLobe specular_lobe_of(const Hit& hit, Vec3 direction, Vec2 place, double pixel_rad) {
  SpecularLobe lobe;
  lobe.to_eye = direction * -1;
  lobe.outside = hit.geometric_normal;
  double spread = 0;
  Vec3 normal = hit.shading_normal;
  const double upright = hit.geometric_normal.z;
  if (is_water(hit.material) && upright > 0.9) {
    // at grazing angles a pixel covers more along the view than across it: the geometric mean of both
    const double across_m = hit.distance_m * pixel_rad, cosine = std::max(0.02, dot(lobe.to_eye, normal));
    const Waves waves = waves_at(place, std::max(across_m / std::sqrt(cosine), 1e-3));
    normal = waves.normal;
    spread = waves.slope_spread;
  }
  lobe.normal = facing(normal, lobe.to_eye);
  const double own = static_cast<double>(hit.roughness) * hit.roughness;
  lobe.alpha = std::max(kLeastAlpha, std::sqrt(own * own + 2 * spread));
  lobe.f0 = is_water(hit.material) ? kWaterF0 : kGlassF0;
  lobe.fresnel = schlick(lobe.f0, dot(lobe.to_eye, lobe.normal));
  return lobe;
}

// Samples a facet's normal; those that face away are turned towards the eye.
Vec3 SpecularLobe::draw(UnitPair chance) const {
  const double cos2 = (1 - chance.u) / (1 + (alpha * alpha - 1) * chance.u);
  const Vec3 facet = facing(around(normal, std::sqrt(std::clamp(cos2, 0.0, 1.0)), chance.v), to_eye);
  const Vec3 out = mirrored(to_eye, facet);
  // a ray into the surface hits the next wave, which reflects it along the surface
  constexpr double kLeastRise = 0.02;
  const double rise = dot(out, outside);
  return rise >= kLeastRise ? out : unit(out + outside * (kLeastRise - rise));
}

double SpecularLobe::share(Vec3 drawn) const { return schlick(f0, dot(to_eye, unit(to_eye + drawn))); }

double SpecularLobe::glint(Vec3 from) const {
  const double in = dot(normal, from), out = dot(normal, to_eye);
  if (in <= 0 || out <= 0 || dot(outside, from) <= 0) return 0;
  const Vec3 half = unit(from + to_eye);
  const double c = dot(normal, half), a2 = alpha * alpha, d = c * c * (a2 - 1) + 1;
  const double facets = a2 / (std::numbers::pi * d * d);
  return facets * seen(alpha, in) * seen(alpha, out) * schlick(f0, dot(from, half)) / (4 * out);
}

}  // namespace citykiln::preview
