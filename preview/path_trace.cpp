#include "preview/path_trace.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "preview/surface/specular.h"

namespace citykiln::preview {
namespace {

constexpr double kPi = std::numbers::pi;

// Samples are clamped to this, twice a white wall in the sun: brighter ones are rare and would stay visible as dots.
constexpr double kBrightest = 12;

// Paths with a smaller weight are continued by Russian roulette: most rays that dark ground reflects do not matter.
constexpr double kSmallWeight = 0.4;

// Fades light where a smooth normal faces it but the flat triangle hides it, which would be a hard edge on large
// triangles. Chiang, Li, Burley, "Taming the Shadow Terminator", SIGGRAPH 2019 talks.
double terminator(const Hit& hit, Vec3 to_light) {
  const double flat = dot(hit.geometric_normal, to_light), smooth = dot(hit.shading_normal, to_light);
  if (flat <= 0 || smooth <= 0) return 0;
  const double g = std::min(1.0, flat / (smooth * dot(hit.geometric_normal, hit.shading_normal)));
  return g * (1 + g - g * g);
}

// The hit seen from its other side.
Hit other_side(Hit hit) {
  hit.geometric_normal = hit.geometric_normal * -1, hit.shading_normal = hit.shading_normal * -1;
  return hit;
}

// The share of paths that continue behind a leaf.
double through_share(const Hit& hit) { return hit.translucency / (1 + hit.translucency); }

// The cosine of light from a direction, for the other side of leaves times their translucency.
double received(const Hit& hit, Vec3 to_light) {
  if (hit.translucency > 0 && dot(hit.geometric_normal, to_light) < 0) {
    Hit behind = other_side(hit);
    behind.translucency = 0;
    return hit.translucency * received(behind, to_light);
  }
  return std::max(0.0, dot(hit.shading_normal, to_light)) * terminator(hit, to_light);
}

Rgb from_sun(const TraceContext& context, const Hit& hit, UnitPair chance) {
  if (!context.lights.has_sun()) return {};
  const Vec3 to_sun = context.lights.sample_sun(chance);
  const double share = received(hit, to_sun) * context.lights.sun_solid_angle() / kPi;
  if (share <= 0 || context.world.is_blocked(leave(hit, to_sun), to_sun)) return {};
  return context.lights.model().sun_radiance * share;
}

// Light of the sky by a shadow ray. @param goes_on  Whether a cosine-weighted ray samples the sky, too.
Rgb from_sky(const TraceContext& context, const Hit& hit, UnitPair chance, bool goes_on) {
  const DirectionSample drawn = context.lights.sample_sky(chance);
  if (drawn.pdf <= 0) return {};
  const double share = received(hit, drawn.direction);
  if (share <= 0 || context.world.is_blocked(leave(hit, drawn.direction), drawn.direction)) return {};
  const bool is_through = dot(hit.geometric_normal, drawn.direction) < 0;
  const double side = is_through ? through_share(hit) : 1 - through_share(hit);
  const double other = goes_on ? side * std::abs(dot(hit.shading_normal, drawn.direction)) / kPi : 0;
  return context.lights.falling(drawn.direction) * (share / kPi / (drawn.pdf + other));
}

// Light of a cosine-weighted ray that hits nothing: from the sky its share by the balance heuristic, from below the
// horizon all of it, since shadow rays do not sample that.
Rgb escaped(const TraceContext& context, const DirectionSample& ray) {
  return context.lights.falling(ray.direction) * (ray.pdf / (ray.pdf + context.lights.sky_pdf(ray.direction)));
}

// Samples a cosine-weighted ray, from a leaf on either side, to which the hit is turned.
DirectionSample sample_onward(Hit& hit, Rgb& weight, PathDraw& draw) {
  double side = 1;
  if (hit.translucency > 0) {
    const bool is_through = draw.next().u < through_share(hit);
    side = is_through ? through_share(hit) : 1 - through_share(hit);
    weight = weight * (1 + hit.translucency);
    if (is_through) hit = other_side(hit);
  }
  DirectionSample ray = sample_cosine(hit.shading_normal, draw.next());
  ray.pdf *= side;
  return ray;
}

// The light that a diffuse surface emits and reflects, along a path of at most `bounces` more surfaces.
Rgb body_light(const TraceContext& context, Hit hit, int bounces, PathDraw& draw) {
  Rgb light{}, weight{1, 1, 1};
  for (int bounce = 0;; ++bounce) {
    light = light + weight * hit.emission;
    weight = weight * hit.albedo;
    const bool goes_on = bounce < bounces;
    light = light + weight * (from_sun(context, hit, draw.next()) + from_sky(context, hit, draw.next(), goes_on));
    if (!goes_on) return light;
    const DirectionSample ray = sample_onward(hit, weight, draw);
    weight = weight * terminator(hit, ray.direction);
    const double carried = std::max({weight[0], weight[1], weight[2]}), kept = std::min(1.0, carried / kSmallWeight);
    if (carried <= 0 || (kept < 1 && draw.next().u >= kept)) return light;
    weight = weight * (1 / kept);
    const auto next = context.world.first_hit(leave(hit, ray.direction), ray.direction);
    if (!next) return light + weight * escaped(context, ray);
    hit = *next;
  }
}

// Light of a specular ray: the diffuse light of what it hits, without a second reflection, or the sky; and the sun's
// glint.
Rgb mirrored_light(const TraceContext& context, const Hit& hit, const SpecularLobe& lobe, PathDraw& draw) {
  const UnitPair chance = draw.next(), sun_chance = draw.next();
  Rgb light{};
  const Vec3 out = lobe.draw(chance);
  const auto met = context.world.first_hit(leave(hit, out), out, lobe.alpha);
  if (met)
    light =
        context.lights.through_air(body_light(context, *met, std::min(context.bounces, 1), draw), out, met->distance_m);
  else
    light = context.lights.seen(out);
  light = light * lobe.share(out);
  if (!context.lights.has_sun()) return light;
  const Vec3 to_sun = context.lights.sample_sun(sun_chance);
  const Rgb glint = context.lights.model().sun_radiance * (lobe.glint(to_sun) * context.lights.sun_solid_angle());
  // far from the highlight no shadow ray is needed
  if (luminance(glint) < 0.002 || context.world.is_blocked(leave(hit, to_sun), to_sun)) return light;
  return light + glint;
}

Rgb surface_light(const TraceContext& context, const Hit& hit, Vec3 direction, PathDraw& draw) {
  const Rgb body = body_light(context, hit, context.bounces, draw);
  if (!is_smooth(hit)) return body;
  const Vec3 origin = context.world.origin();
  const SpecularLobe lobe = specular_lobe_of(hit, direction, in_plan(hit.position + origin), context.pixel_rad);
  return body * (1 - lobe.fresnel) + mirrored_light(context, hit, lobe, draw);
}

}  // namespace

TracedPath trace(const TraceContext& context, Vec3 from, Vec3 direction, PathDraw& draw) {
  assert(context.bounces >= 0 && context.pixel_rad > 0);
  const auto hit = context.world.first_hit(from, direction, context.pixel_rad);
  if (!hit) return {context.lights.seen(direction), {}};
  Rgb light = context.lights.through_air(surface_light(context, *hit, direction, draw), direction, hit->distance_m);
  // a channel that is not a number becomes 0
  for (double& c : light) c = c > 0 ? std::min(c, kBrightest) : 0;
  return {light, {hit->albedo, hit->shading_normal, hit->distance_m, hit->feature}};
}

}  // namespace citykiln::preview
