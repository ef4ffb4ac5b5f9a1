#include "preview/surface/bsdf.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace citykiln::preview {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr Rgb kWhite = {1, 1, 1};

// Microfacets narrower than the sun's disk only add noise.
constexpr double kLeastAlpha = 0.01;

// A shading normal that faces away from the eye is turned to this cosine.
constexpr double kLeastCosine = 0.01;

// Fades light where a smooth normal faces it but the flat triangle hides it, which would be a hard edge on large
// triangles. Chiang, Li, Burley, "Taming the Shadow Terminator", SIGGRAPH 2019 talks.
double terminator(double flat, double smooth, double between) {
  if (flat <= 0 || smooth <= 0) return 0;
  const double g = std::min(1.0, flat / (smooth * between));
  return g * (1 + g - g * g);
}

Vec3 facing(Vec3 normal, Vec3 to_eye) {
  const double cosine = dot(normal, to_eye);
  return cosine >= kLeastCosine ? normal : unit(normal + to_eye * (kLeastCosine - cosine));
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

Bsdf::Bsdf(const Hit& hit, Vec3 to_eye, double least_alpha)
    : outside_(hit.geometric_normal),
      frame_(frame_about(facing(hit.shading_normal, to_eye))),
      eye_(frame_.into(to_eye)),
      through_(hit.translucency),
      has_facets_(hit.translucency <= 0) {
  eye_.z = std::max(eye_.z, 1e-4);
  const Rgb albedo = hit.albedo;
  body_ = albedo;
  if (!has_facets_) return;
  const double own = static_cast<double>(hit.roughness) * hit.roughness;
  facets_.alpha = std::clamp(own, std::max(kLeastAlpha, least_alpha), 1.0);
  f0_ = mixed(Rgb{hit.f0, hit.f0, hit.f0}, albedo, hit.metallic);
  once_ = single_reflection(facets_.alpha, eye_.z).of_white();
  const SingleReflection mean = mean_single_reflection(facets_.alpha);
  once_mean_ = mean.of_white();
  several_ = colour_of_several(f0_, once_mean_);
  energy_ = energy_at(eye_.z);
  for (int c = 0; c < 3; ++c) mean_energy_[c] = std::min(mean.of(f0_[c]) + (1 - once_mean_) * several_[c], 0.999);
  body_ = over(albedo * (1 - hit.metallic) * (kWhite - energy_), kWhite - mean_energy_);
  const double facets = luminance(energy_), body = luminance(albedo * (1 - hit.metallic) * (kWhite - energy_));
  // light of several bounces is sampled with the body
  const double most = body <= 0 && once_mean_ > 0.999 ? 1 : 0.9;
  facets_share_ = facets + body > 0 ? std::clamp(facets / (facets + body), 0.05, most) : most;
  body_share_ = 1 - facets_share_;
}

Rgb Bsdf::energy_at(double cosine) const {
  const SingleReflection once = single_reflection(facets_.alpha, cosine);
  Rgb energy;
  for (int c = 0; c < 3; ++c) energy[c] = std::min(once.of(f0_[c]) + (1 - once.of_white()) * several_[c], 1.0);
  return energy;
}

Rgb Bsdf::of_body(Vec3 from) const {
  const double cosine = dot(frame_.z, from), flat = dot(outside_, from);
  const double fade = terminator(std::abs(flat), std::abs(cosine), dot(outside_, frame_.z)) * std::abs(cosine) / kPi;
  if (flat * cosine <= 0) return {};
  if (flat < 0) return body_ * (through_ * fade);
  if (!has_facets_) return body_ * fade;
  const SingleReflection once = single_reflection(facets_.alpha, cosine);
  // what is left of light that passes the facets, and light that several facets reflect
  const double several = (1 - once_) * (1 - once.of_white()) / std::max(1 - once_mean_, 1e-6);
  Rgb light;
  for (int c = 0; c < 3; ++c) {
    const double energy = std::min(once.of(f0_[c]) + (1 - once.of_white()) * several_[c], 1.0);
    light[c] = (body_[c] * (1 - energy) + several * several_[c]) * fade;
  }
  return light;
}

// The facets' light from a direction in the frame, over the cosine at the eye.
Rgb Bsdf::of_facets(Vec3 from) const {
  if (from.z <= 0) return {};
  const Vec3 facet = unit(from + eye_);
  const double light = facets_.density(facet) * facets_.seen(eye_, from) / (4 * eye_.z);
  const double share = grazing(dot(from, facet));
  return mixed(f0_, kWhite, share) * light;
}

Rgb Bsdf::reflected(Vec3 from) const {
  Rgb light = of_body(from);
  const double flat = dot(outside_, from);
  if (!has_facets_ || flat <= 0) return light;
  // light that facets send below the surface is reflected by the next one along the surface
  light = light + of_facets(frame_.into(from));
  return light + of_facets(frame_.into(from - outside_ * (2 * flat)));
}

double Bsdf::facets_pdf(Vec3 direction) const {
  if (direction.z <= 0) return 0;
  const Vec3 facet = unit(direction + eye_);
  return facets_.pdf(facet, eye_) / (4 * std::max(1e-9, dot(eye_, facet)));
}

double Bsdf::pdf(Vec3 direction) const {
  const double flat = dot(outside_, direction), cosine = dot(frame_.z, direction);
  const double side = through_ > 0 ? (cosine < 0 ? through_ : 1) / (1 + through_) : cosine > 0 ? 1 : 0;
  double pdf = body_share_ * side * std::abs(cosine) / kPi;
  if (facets_share_ > 0 && flat > 0)
    pdf += facets_share_ *
           (facets_pdf(frame_.into(direction)) + facets_pdf(frame_.into(direction - outside_ * (2 * flat))));
  return pdf;
}

void Bsdf::split() {
  if (facets_share_ > 0) facets_share_ = body_share_ = 1;
}

BsdfSample Bsdf::weighed(Vec3 direction, double lobe_rad) const {
  BsdfSample drawn{.direction = direction, .pdf = pdf(direction), .lobe_rad = lobe_rad};
  if (drawn.pdf > 0) drawn.weight = reflected(direction) * (1 / drawn.pdf);
  return drawn;
}

BsdfSample Bsdf::sample_facets(UnitPair chance) const {
  const Vec3 local = mirrored(eye_, facets_.sample(eye_, chance));
  // light between facets is added as that of several bounces
  if (local.z <= 0) return {.direction = outside_};
  const Vec3 out = frame_.out_of(local);
  const double flat = dot(outside_, out);
  return weighed(unit(flat >= 0 ? out : out - outside_ * (2 * flat)), facets_.alpha);
}

BsdfSample Bsdf::sample_body(double side, UnitPair chance) const {
  const bool is_through = side * (1 + through_) >= 1;
  const double r = std::sqrt(chance.u), turn = 2 * kPi * chance.v, up = std::sqrt(1 - chance.u);
  return weighed(unit(frame_.out_of({r * std::cos(turn), r * std::sin(turn), is_through ? -up : up})), 1);
}

BsdfSample Bsdf::sample(double lobe, UnitPair chance) const {
  if (lobe < facets_share_) return sample_facets(chance);
  return sample_body((lobe - facets_share_) / (1 - facets_share_), chance);
}

}  // namespace citykiln::preview
