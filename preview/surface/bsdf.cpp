#include "preview/surface/bsdf.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/trig.h"
#include "preview/turn.h"

namespace citykiln::preview {
namespace {

constexpr Rgb kWhite = {1, 1, 1};

// Microfacets narrower than the sun's disk only add noise.
constexpr double kLeastAlpha = 0.01;

// A shading normal that faces away from the eye is turned to this cosine.
constexpr double kLeastEyeCosine = 0.01;

// Fades light where a smooth normal faces it but the flat triangle hides it, which would be a hard edge on large
// triangles. Chiang, Li, Burley, "Taming the Shadow Terminator", SIGGRAPH 2019 talks.
double terminator(double flat, double smooth, double between) {
  if (flat <= 0 || smooth <= 0) return 0;
  const double g = std::min(1.0, flat / (smooth * between));
  return g * (1 + g - g * g);
}

Vec3 facing(Vec3 normal, Vec3 to_eye) {
  const double cosine = dot(normal, to_eye);
  return cosine >= kLeastEyeCosine ? normal : unit(normal + to_eye * (kLeastEyeCosine - cosine));
}

double grazing(double cosine) {
  const double c = 1 - std::clamp(cosine, 0.0, 1.0), c2 = c * c;
  return c2 * c2 * c;
}

Rgb over(const Rgb& a, const Rgb& b) { return {a[0] / b[0], a[1] / b[1], a[2] / b[2]}; }

// Colour of light that facets reflect more than once (Fdez-Agüera 2019; the mean of Schlick's reflectance is
// f0 + (1 - f0) / 21).
Rgb colour_of_several(const Rgb& f0, double once_mean) {
  Rgb colour;
  for (int c = 0; c < 3; ++c) {
    const double mean = f0[c] + (1 - f0[c]) / 21;
    colour[c] = mean * mean * once_mean / (1 - mean * (1 - once_mean));
  }
  return colour;
}

}  // namespace

Bsdf::Bsdf(const SurfacePoint& surface, Vec3 to_eye, double least_alpha)
    : outside_(surface.geometric_normal),
      frame_(frame_about(facing(surface.shading_normal, to_eye))),
      eye_(frame_.into(to_eye)),
      through_(surface.translucency),
      has_facets_(surface.translucency <= 0) {
  eye_.z = std::max(eye_.z, 1e-4);
  const Rgb albedo = surface.albedo;
  body_ = albedo;
  if (!has_facets_) return;
  const double own = static_cast<double>(surface.roughness) * surface.roughness;
  facets_.alpha = std::clamp(own, std::max(kLeastAlpha, least_alpha), 1.0);
  f0_ = mixed(Rgb{surface.f0, surface.f0, surface.f0}, albedo, surface.metallic);
  reflections_ = SingleReflections(facets_.alpha);
  const SingleReflection once = reflections_.at(eye_.z), mean = reflections_.mean();
  once_ = once.of_white(), seen_ = facets_.seen(eye_);
  once_mean_ = mean.of_white();
  several_ = colour_of_several(f0_, once_mean_);
  energy_ = energy_at(once);
  for (int c = 0; c < 3; ++c) mean_energy_[c] = std::min(mean.of(f0_[c]) + (1 - once_mean_) * several_[c], 0.999);
  body_ = over(albedo * (1 - surface.metallic) * (kWhite - energy_), kWhite - mean_energy_);
  const double facets = luminance(energy_), body = luminance(albedo * (1 - surface.metallic) * (kWhite - energy_));
  // light of several bounces is sampled with the body
  const double most = body <= 0 && once_mean_ > 0.999 ? 1 : 0.9;
  facets_share_ = facets + body > 0 ? std::clamp(facets / (facets + body), 0.05, most) : most;
  body_share_ = 1 - facets_share_;
}

Rgb Bsdf::energy_at(const SingleReflection& once) const {
  const double several = 1 - once.of_white();
  Rgb energy;
  for (int c = 0; c < 3; ++c) energy[c] = std::min(once.of(f0_[c]) + several * several_[c], 1.0);
  return energy;
}

// @param flat, cosine  Of the direction with the geometric and the shading normal.
Rgb Bsdf::of_body(double flat, double cosine) const {
  if (flat * cosine <= 0) return {};
  const double fade = terminator(std::abs(flat), std::abs(cosine), dot(outside_, frame_.z)) * std::abs(cosine) / kPi;
  if (flat < 0) return body_ * (through_ * fade);
  if (!has_facets_) return body_ * fade;
  const SingleReflection once = reflections_.at(cosine);
  // what is left of light that passes the facets, and light that several facets reflect
  const double several = (1 - once_) * (1 - once.of_white()) / std::max(1 - once_mean_, 1e-6);
  return (body_ * (kWhite - energy_at(once)) + several_ * several) * fade;
}

// Adds the facets' light from a direction in the frame.
void Bsdf::add_facets(Vec3 from, Scattering& to) const {
  const Vec3 facet = unit(from + eye_);
  const double cosine = dot(from, facet), density = facets_.density(facet) / (4 * eye_.z);
  to.light = to.light + mixed(f0_, kWhite, grazing(cosine)) * (density * facets_.seen(eye_, from));
  to.pdf += facets_share_ * density * seen_;
}

Scattering Bsdf::scattering(Vec3 from) const {
  const double flat = dot(outside_, from), cosine = dot(frame_.z, from);
  Scattering all{.light = of_body(flat, cosine)};
  const double side = through_ > 0 ? (cosine < 0 ? through_ : 1) / (1 + through_) : cosine > 0 ? 1 : 0;
  all.pdf = body_share_ * side * std::abs(cosine) / kPi;
  if (!has_facets_ || flat <= 0) return all;
  if (cosine > 0) add_facets(frame_.into(from), all);
  // light that facets send below the surface is reflected by the next one along the surface
  const Vec3 below = from - outside_ * (2 * flat);
  if (dot(frame_.z, below) > 0) add_facets(frame_.into(below), all);
  return all;
}

void Bsdf::split() {
  if (facets_share_ > 0) facets_share_ = body_share_ = 1;
}

BsdfSample Bsdf::weighed(Vec3 direction, double lobe_rad) const {
  const Scattering all = scattering(direction);
  return {direction, all.pdf > 0 ? all.light * (1 / all.pdf) : Rgb{}, all.pdf, lobe_rad};
}

BsdfSample Bsdf::sample_facets(UnitPair chance) const {
  const Vec3 local = mirrored(eye_, facets_.sample(eye_, chance));
  // light between facets is added as that of several bounces
  if (local.z <= 0) return {.direction = outside_, .pdf = 0};
  const Vec3 out = frame_.out_of(local);
  const double flat = dot(outside_, out);
  return weighed(unit(flat >= 0 ? out : out - outside_ * (2 * flat)), facets_.alpha);
}

BsdfSample Bsdf::sample_body(double side, UnitPair chance) const {
  const bool is_through = side * (1 + through_) >= 1;
  const double up = std::sqrt(1 - chance.u);
  return weighed(frame_.out_of(at_height(on_circle(chance.v) * std::sqrt(chance.u), is_through ? -up : up)), 1);
}

BsdfSample Bsdf::sample(double lobe, UnitPair chance) const {
  if (lobe < facets_share_) return sample_facets(chance);
  return sample_body((lobe - facets_share_) / (1 - facets_share_), chance);
}

}  // namespace citykiln::preview
