#include "preview/path_trace.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "preview/specular.h"

namespace citykiln::preview {
namespace {

constexpr double kPi = std::numbers::pi;

// A sample brighter than this, twice a white wall in the sun, is rare and would stay as a white dot.
constexpr double kBrightest = 12;

// Paths that carry less than this go on by lot: three in four of the rays that a dark ground throws back do not matter.
constexpr double kSmallWeight = 0.4;

// Where triangles are large, smooth normals see light that the flat triangle's own shadow cuts off with an edge; this
// fades it. Chiang, Li, Burley, "Taming the Shadow Terminator", SIGGRAPH 2019 talks.
double terminator(const Hit& hit, Vec3 to_light) {
  const double flat = dot(hit.geometric_normal, to_light), smooth = dot(hit.shading_normal, to_light);
  if (flat <= 0 || smooth <= 0) return 0;
  const double g = std::min(1.0, flat / (smooth * dot(hit.geometric_normal, hit.shading_normal)));
  return g * (1 + g - g * g);
}

// The same place seen from its other side.
Hit other_side(Hit hit) {
  hit.geometric_normal = hit.geometric_normal * -1, hit.shading_normal = hit.shading_normal * -1;
  return hit;
}

// How many of the paths that meet a leaf go on behind it.
double through_share(const Hit& hit) { return hit.translucency / (1 + hit.translucency); }

// What a white surface sends on of light from a direction, times pi; a leaf also of what falls on its other side.
double received(const Hit& hit, Vec3 to_light) {
  if (hit.translucency > 0 && dot(hit.geometric_normal, to_light) < 0) {
    Hit behind = other_side(hit);
    behind.translucency = 0;
    return hit.translucency * received(behind, to_light);
  }
  return std::max(0.0, dot(hit.shading_normal, to_light)) * terminator(hit, to_light);
}

Rgb from_sun(const TraceContext& stage, const Hit& hit, UnitPair chance) {
  if (!stage.lights.has_sun()) return {};
  const Vec3 to_sun = stage.lights.sample_sun(chance);
  const double share = received(hit, to_sun) * stage.lights.sun_solid_angle() / kPi;
  if (share <= 0 || stage.world.is_blocked(leave(hit, to_sun), to_sun)) return {};
  return stage.lights.dome().sun_radiance * share;
}

// `goes_on`: the path looks for the sky by a cosine-weighted ray as well.
Rgb from_sky(const TraceContext& stage, const Hit& hit, UnitPair chance, bool goes_on) {
  const DirectionSample drawn = stage.lights.sample_sky(chance);
  if (drawn.pdf <= 0) return {};
  const double share = received(hit, drawn.direction);
  if (share <= 0 || stage.world.is_blocked(leave(hit, drawn.direction), drawn.direction)) return {};
  const bool is_through = dot(hit.geometric_normal, drawn.direction) < 0;
  const double side = is_through ? through_share(hit) : 1 - through_share(hit);
  const double other = goes_on ? side * std::abs(dot(hit.shading_normal, drawn.direction)) / kPi : 0;
  return stage.lights.falling(drawn.direction) * (share / kPi / (drawn.pdf + other));
}

// What a cosine-weighted ray that meets nothing brings: all of what comes from below the horizon, its share of the sky.
Rgb escaped(const TraceContext& stage, const DirectionSample& ray) {
  return stage.lights.falling(ray.direction) * (ray.pdf / (ray.pdf + stage.lights.sky_pdf(ray.direction)));
}

// A cosine-weighted ray; from a leaf, on either side, to which the hit is turned.
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

// The light that a diffuse surface sends out, by a path of at most `bounces` more surfaces.
Rgb body_light(const TraceContext& stage, Hit hit, int bounces, PathDraw& draw) {
  Rgb light{}, weight{1, 1, 1};
  for (int bounce = 0;; ++bounce) {
    light = light + weight * hit.emission;
    weight = weight * hit.albedo;
    const bool goes_on = bounce < bounces;
    light = light + weight * (from_sun(stage, hit, draw.next()) + from_sky(stage, hit, draw.next(), goes_on));
    if (!goes_on) return light;
    const DirectionSample ray = sample_onward(hit, weight, draw);
    weight = weight * terminator(hit, ray.direction);
    const double carried = std::max({weight[0], weight[1], weight[2]}), kept = std::min(1.0, carried / kSmallWeight);
    if (carried <= 0 || (kept < 1 && draw.next().u >= kept)) return light;
    weight = weight * (1 / kept);
    const auto next = stage.world.first_hit(leave(hit, ray.direction), ray.direction);
    if (!next) return light + weight * escaped(stage, ray);
    hit = *next;
  }
}

// What a mirrored ray brings: the body of what it meets, without a second mirror, or the sky, or the sun's glint.
Rgb mirrored_light(const TraceContext& stage, const Hit& hit, const SpecularLobe& mirror, PathDraw& draw) {
  const UnitPair chance = draw.next(), sun_chance = draw.next();
  Rgb light{};
  const Vec3 out = mirror.draw(chance);
  const auto met = stage.world.first_hit(leave(hit, out), out, mirror.alpha);
  if (met)
    light = stage.lights.through_air(body_light(stage, *met, std::min(stage.bounces, 1), draw), out, met->distance_m);
  else
    light = stage.lights.seen(out);
  light = light * mirror.share(out);
  if (!stage.lights.has_sun()) return light;
  const Vec3 to_sun = stage.lights.sample_sun(sun_chance);
  const Rgb glint = stage.lights.dome().sun_radiance * (mirror.glint(to_sun) * stage.lights.sun_solid_angle());
  // far from the highlight a shadow ray would be wasted
  if (luminance(glint) < 0.002 || stage.world.is_blocked(leave(hit, to_sun), to_sun)) return light;
  return light + glint;
}

Rgb surface_light(const TraceContext& stage, const Hit& hit, Vec3 direction, PathDraw& draw) {
  const Rgb body = body_light(stage, hit, stage.bounces, draw);
  if (!is_smooth(hit)) return body;
  const Vec3 origin = stage.world.origin();
  const SpecularLobe mirror = specular_lobe_of(hit, direction, in_plan(hit.position + origin), stage.pixel_rad);
  return body * (1 - mirror.fresnel) + mirrored_light(stage, hit, mirror, draw);
}

}  // namespace

Rgb trace(const TraceContext& stage, Vec3 from, Vec3 direction, PathDraw& draw) {
  const auto hit = stage.world.first_hit(from, direction, stage.pixel_rad);
  if (!hit) return stage.lights.seen(direction);
  Rgb light = stage.lights.through_air(surface_light(stage, *hit, direction, draw), direction, hit->distance_m);
  // not std::min: a channel that is not a number becomes the limit's other side, not the picture's
  for (double& c : light) c = c > 0 ? std::min(c, kBrightest) : 0;
  return light;
}

}  // namespace citykiln::preview
