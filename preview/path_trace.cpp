#include "preview/path_trace.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <optional>

#include "preview/surface/bsdf.h"
#include "preview/surface/water_waves.h"

namespace citykiln::preview {
namespace {

// Narrower lobes are mirrors: they see the glass of lamps, and do not count as bounces.
constexpr double kMirrorAlpha = 0.1;
constexpr int kMostMirrors = 6;

// If the first surface of a path is glossier than this, both of its lobes are followed.
constexpr double kSplitAlpha = 0.1;

// Width of the microfacets of surfaces behind a matt reflection. Path regularisation: Kaplanyan, Dachsbacher, 2013.
constexpr double kBlurredAlpha = 0.3;

// The luminance of lamp glass: 2,500 lm from a lantern of 0.1 m².
constexpr double kLampGlass = 8000 / sky::kUnitLuminance_cd_m2;

// The state of a path.
struct Path {
  Vec3 from, direction;
  Rgb weight{1, 1, 1}, light{};
  double spread_rad;
  int bounce = 0, mirrors = 0;
  bool is_first = true;
  bool is_sharp = true;  // the camera's, or a mirror's
  // density of the direction, 0 for the camera's, and the place where it was sampled
  double pdf = 0;
  Vec3 sampled_at{}, normal{};
  bool has_sampled_sky = false;  // there
};

// Turns the normal of water by its waves, and widens its microfacets by those that are shorter than a pixel.
void make_waves(Hit& hit, const TraceContext& context, double spread_rad, Vec3 direction) {
  if (!is_water(hit.material)) return;
  // waves of the plane, turned to the vertical of the place inside of a cylinder
  const InsideLights* inside = context.lights.inside();
  Vec3 place = hit.position + context.world.origin();
  map::BentPoint axes{.at = {}, .east = {1, 0, 0}, .north = {0, 1, 0}, .up = {0, 0, 1}};
  if (inside != nullptr) place = map::flattened(inside->cylinder(), place), axes = map::at(inside->cylinder(), place);
  if (dot(hit.geometric_normal, axes.up) <= 0.9) return;
  // at grazing angles a pixel covers more along the view than across it
  const double across_m = std::max(hit.distance_m * spread_rad, 1e-3);
  const double cosine = std::max(0.02, -dot(direction, hit.shading_normal));
  const Vec2 view{dot(direction, axes.east), dot(direction, axes.north)};
  const Vec2 along = length(view) > 1e-6 ? unit(view) : Vec2{1, 0};
  const Waves waves = waves_at(in_plan(place), {.along = along, .along_m = across_m / cosine, .across_m = across_m},
                               wave_strength(hit.material));
  hit.shading_normal = axes.east * waves.normal.x + axes.north * waves.normal.y + axes.up * waves.normal.z;
  const double own = static_cast<double>(hit.roughness) * hit.roughness;
  hit.roughness = static_cast<float>(std::sqrt(std::sqrt(own * own + 2 * waves.slope_spread)));
}

double balanced(double own, double other) { return own / (own + other); }

bool is_free(const TraceContext& context, const Hit& hit, Vec3 direction,
             double distance_m = std::numeric_limits<double>::infinity()) {
  return !context.world.is_blocked(leave(hit, direction), direction, distance_m);
}

Rgb from_sun(const TraceContext& context, const Hit& hit, const Bsdf& bsdf, UnitPair chance, bool goes_on) {
  if (!context.lights.has_sun()) return {};
  const Vec3 to_sun = context.lights.sample_sun(chance);
  const Scattering scattered = bsdf.scattering(to_sun);
  if (largest_component(scattered.light) <= 0 || !is_free(context, hit, to_sun)) return {};
  const double pdf = 1 / context.lights.sun_solid_angle();
  const double passed = context.lights.sun_passed(hit.position + context.world.origin());
  return context.lights.sun_radiance() * scattered.light * (passed / (pdf + (goes_on ? scattered.pdf : 0)));
}

Rgb from_sky(const TraceContext& context, const Hit& hit, const Bsdf& bsdf, UnitPair chance, bool goes_on) {
  const DirectionSample drawn = context.lights.sample_sky(chance);
  if (drawn.pdf <= 0) return {};
  const Scattering scattered = bsdf.scattering(drawn.direction);
  if (largest_component(scattered.light) <= 0 || !is_free(context, hit, drawn.direction)) return {};
  return context.lights.falling(hit.position + context.world.origin(), drawn.direction) * scattered.light *
         (1 / (drawn.pdf + (goes_on ? scattered.pdf : 0)));
}

// Whether the sky is sampled where a path goes on. Beside a bright sun the sky adds little noise, and the path's next
// direction finds it without a further ray. Measured in a town by day: half the squared error at equal time.
bool samples_sky(const TraceContext& context, bool is_sharp) {
  constexpr double kBrightSun = 0.5, kBrightestSun = 2.5;
  return context.lights.sun_to_sky() < (is_sharp ? kBrightestSun : kBrightSun);
}

// Light of sun and sky: both where the eye sees the surface; else one of them, chosen at random, if both are sampled.
Rgb from_outside(const TraceContext& context, const Hit& hit, const Bsdf& bsdf, const Path& path, PathDraw& draw,
                 bool goes_on) {
  const UnitPair first = draw.next();
  if (goes_on && !samples_sky(context, path.is_sharp)) return from_sun(context, hit, bsdf, first, goes_on);
  if (!context.lights.has_sun()) return from_sky(context, hit, bsdf, first, goes_on);
  if (path.is_sharp)
    return from_sun(context, hit, bsdf, first, goes_on) + from_sky(context, hit, bsdf, draw.next(), goes_on);
  if (first.u < 0.5) return from_sun(context, hit, bsdf, {2 * first.u, first.v}, goes_on) * 2;
  return from_sky(context, hit, bsdf, {2 * first.u - 1, first.v}, goes_on) * 2;
}

// The normal for choosing lights: none where light from both sides is scattered.
Vec3 receiving_normal(const Hit& hit, const Bsdf& bsdf) { return bsdf.is_two_sided() ? Vec3{} : hit.geometric_normal; }

Rgb from_lamp(const TraceContext& context, const Hit& hit, const Bsdf& bsdf, double chance) {
  const auto drawn = context.local.sample_lamp(hit.position, receiving_normal(hit, bsdf), chance);
  if (!drawn) return {};
  // mirrors see the glass of lamps
  const bool is_mirror = bsdf.alpha() < kMirrorAlpha;
  const Rgb reflected = is_mirror ? bsdf.matt(drawn->direction) : bsdf.scattering(drawn->direction).light;
  if (largest_component(reflected) <= 0 || !is_free(context, hit, drawn->direction, drawn->distance_m)) return {};
  return drawn->light * reflected;
}

Rgb from_emitter(const TraceContext& context, const Hit& hit, const Bsdf& bsdf, PathDraw& draw, bool goes_on) {
  const double chance = draw.next().u;
  const auto drawn = context.local.sample_emitter(hit.position, receiving_normal(hit, bsdf), chance, draw.next());
  if (!drawn) return {};
  const Scattering scattered = bsdf.scattering(drawn->direction);
  if (largest_component(scattered.light) <= 0 || !is_free(context, hit, drawn->direction, drawn->distance_m)) return {};
  return drawn->light * scattered.light * (goes_on ? balanced(drawn->pdf, scattered.pdf) : 1);
}

// Light of a lit window whose building may not be generated yet: the ray finds out.
Rgb from_pane(const TraceContext& context, const Hit& hit, const Bsdf& bsdf, PathDraw& draw, bool goes_on) {
  const PaneLights& panes = context.local.pane_lights();
  const double chance = draw.next().u;
  const auto drawn = panes.sample(hit.position, receiving_normal(hit, bsdf), chance, draw.next());
  if (!drawn) return {};
  const Scattering scattered = bsdf.scattering(drawn->direction);
  if (largest_component(scattered.light) <= 0) return {};
  const std::optional<Hit> met = context.world.first_hit(leave(hit, drawn->direction), drawn->direction);
  if (!met || !met->is_front || largest_component(met->emission) <= 0) return {};
  if (panes.pane_of(*met, hit.position, drawn->direction) != drawn->pane) return {};
  return met->emission * scattered.light * (1 / (drawn->pdf + (goes_on ? scattered.pdf : 0)));
}

// Light of the lines inside of a cylinder. Mirrors see their tubes.
Rgb from_line(const TraceContext& context, const InsideLights& lines, const Hit& hit, const Bsdf& bsdf,
              UnitPair chance) {
  const auto drawn = lines.sample(hit.position + context.world.origin(), receiving_normal(hit, bsdf), chance);
  if (!drawn) return {};
  const bool is_mirror = bsdf.alpha() < kMirrorAlpha;
  const Rgb reflected = is_mirror ? bsdf.matt(drawn->direction) : bsdf.scattering(drawn->direction).light;
  if (largest_component(reflected) <= 0 || !is_free(context, hit, drawn->direction, drawn->distance_m)) return {};
  return drawn->light * reflected;
}

Rgb from_local(const TraceContext& context, const Hit& hit, const Bsdf& bsdf, PathDraw& draw, bool goes_on) {
  Rgb light{};
  if (const InsideLights* lines = context.lights.inside(); lines != nullptr && lines->are_lit())
    light = light + from_line(context, *lines, hit, bsdf, draw.next());
  if (context.local.has_lamps()) light = light + from_lamp(context, hit, bsdf, draw.next().u);
  if (context.local.has_emitters()) light = light + from_emitter(context, hit, bsdf, draw, goes_on);
  if (!context.local.pane_lights().is_empty()) light = light + from_pane(context, hit, bsdf, draw, goes_on);
  return light;
}

// Adds the light of a ray that hits nothing.
void add_outside(const TraceContext& context, Path& path) {
  const Lights& lights = context.lights;
  const Vec3 from = path.from + context.world.origin();
  const Rgb sky = path.is_sharp ? lights.seen(from, path.direction, context.pixel_rad, path.is_first)
                                : lights.falling(from, path.direction);
  const bool is_shared = path.pdf > 0 && path.has_sampled_sky;
  path.light = path.light + path.weight * sky * (is_shared ? balanced(path.pdf, lights.sky_pdf(path.direction)) : 1);
  if (path.pdf <= 0 || !lights.is_in_sun(path.direction)) return;
  const double share = balanced(path.pdf, 1 / lights.sun_solid_angle());
  path.light = path.light + path.weight * lights.sun_radiance() * (share * lights.sun_passed(from));
}

// Adds the light that a surface emits.
void add_emission(const TraceContext& context, const Hit& hit, Path& path) {
  if (hit.material == materials::Material::kLampGlass && !context.lights.lamps().empty() && path.is_sharp)
    path.light = path.light + path.weight * kLampGlass;
  if (!hit.is_front || largest_component(hit.emission) <= 0) return;
  if (hit.emitter == kNoEmitter || path.pdf <= 0) {
    const PaneLights& panes = context.local.pane_lights();
    const bool is_sampled = path.pdf > 0 && !panes.is_empty();
    const std::uint32_t pane = is_sampled ? panes.pane_of(hit, path.sampled_at, path.direction) : kNoPane;
    const double other = is_sampled ? panes.pdf(pane, path.sampled_at, path.normal, path.direction) : 0;
    path.light = path.light + path.weight * hit.emission * (path.pdf > 0 ? balanced(path.pdf, other) : 1);
    return;
  }
  const double other = context.local.pdf(hit.emitter, path.sampled_at, path.normal, path.direction, hit.distance_m);
  path.light = path.light + path.weight * context.local.radiance_of(hit.emitter) * balanced(path.pdf, other);
}

// Passes the air before a surface: adds its light and lowers the weight of the path.
void pass_air(const TraceContext& context, double distance_m, Path& path) {
  const sky::AirPath air = context.lights.air(path.from + context.world.origin(), path.direction, distance_m);
  path.light = path.light + path.weight * air.added;
  path.weight = path.weight * air.passed;
}

// Russian roulette: ends paths of little weight at random, and weights the others to make up for them. Returns false
// where the path ends.
bool survives_roulette(const TraceContext& context, Path& path, double chance) {
  const double carried = largest_component(path.weight);
  if (!(carried > 0)) return false;
  if (carried >= context.roulette) return true;
  const double kept = carried / context.roulette;
  if (chance >= kept) return false;
  path.weight = path.weight * (1 / kept);
  return true;
}

// Continues a path in a sampled direction. Returns false where it ends.
bool go_on(const TraceContext& context, const Hit& hit, const Bsdf& bsdf, const BsdfSample& drawn, double chance,
           Path& path) {
  path.weight = path.weight * drawn.weight;
  path.direction = drawn.direction, path.pdf = drawn.pdf, path.from = leave(hit, drawn.direction);
  path.sampled_at = hit.position, path.normal = receiving_normal(hit, bsdf);
  path.has_sampled_sky = samples_sky(context, path.is_sharp);
  path.is_sharp = drawn.lobe_rad < kMirrorAlpha;
  path.spread_rad = std::max(path.spread_rad, std::min(drawn.lobe_rad, kScattered_rad));
  if (!path.is_sharp || ++path.mirrors > kMostMirrors) ++path.bounce;
  return survives_roulette(context, path, chance);
}

// Light that is not finite becomes 0.
Rgb sound(Rgb light) {
  for (double& c : light) c = c > 0 && std::isfinite(c) ? c : 0;
  return light;
}

// A surface on a path.
struct Meeting {
  Hit hit;
  Bsdf bsdf;
};

// Adds the tube of a line that the path meets before a surface. Returns whether it does. Other paths have sampled the
// lines where they come from.
bool meets_tube(const TraceContext& context, Path& path, double distance_m) {
  const InsideLights* lines = context.lights.inside();
  if (lines == nullptr || !path.is_sharp) return false;
  const auto tube = lines->tube(path.from + context.world.origin(), path.direction);
  if (!tube || tube->distance_m >= distance_m) return false;
  pass_air(context, tube->distance_m, path);
  path.light = path.light + path.weight * tube->radiance;
  return true;
}

// The next surface, with all light that it sends along the path but that of the path's next direction. Empty where the
// path leaves the scene.
std::optional<Meeting> meet(const TraceContext& context, Path& path, PathDraw& draw) {
  std::optional<Hit> hit = context.world.first_hit(path.from, path.direction, path.spread_rad);
  if (meets_tube(context, path, hit ? hit->distance_m : std::numeric_limits<double>::infinity())) return std::nullopt;
  if (!hit) {
    add_outside(context, path);
    return std::nullopt;
  }
  if (path.is_sharp) pass_air(context, hit->distance_m, path);
  add_emission(context, *hit, path);
  make_waves(*hit, context, path.spread_rad, path.direction);
  const bool is_behind_matt = path.bounce > 0 && !context.has_caustics;
  if (!path.is_first) hit->pane.reset();
  if (hit->pane) hit->albedo = {};
  Bsdf bsdf(*hit, path.direction * -1, is_behind_matt ? kBlurredAlpha : 0);
  if (path.is_first && bsdf.alpha() < kSplitAlpha) bsdf.split();
  path.is_first = false;
  const bool goes_on = path.bounce < context.bounces;
  path.light = path.light + path.weight * (from_outside(context, *hit, bsdf, path, draw, goes_on) +
                                           from_local(context, *hit, bsdf, draw, goes_on));
  return Meeting{*hit, bsdf};
}

// All light of a path after its first surface.
Rgb light_behind(const TraceContext& context, Path path, PathDraw& draw) {
  path.light = {};
  while (true) {
    const std::optional<Meeting> met = meet(context, path, draw);
    if (!met || path.bounce >= context.bounces) return path.light;
    const UnitPair choice = draw.next();
    const BsdfSample drawn = met->bsdf.sample(choice.u, draw.next());
    if (!go_on(context, met->hit, met->bsdf, drawn, choice.v, path)) return path.light;
  }
}

// Sunlight that falls through a pane to the surface of a room that the eye sees.
Rgb sun_in_room(const TraceContext& context, const Hit& hit, const RoomWay& way, UnitPair chance) {
  if (!context.lights.has_sun()) return {};
  const Vec3 to_sun = context.lights.sample_sun(chance);
  const Pane& pane = *hit.pane;
  const double cosine = dot(way.normal, to_sun), outward = -dot(pane.inward, to_sun);
  if (cosine <= 0 || outward <= 0) return {};
  const Vec3 on_pane = way.seen_at + to_sun * (dot(way.seen_at - pane.corner, pane.inward) / outward);
  const double x = dot(on_pane - pane.corner, pane.across), y = dot(on_pane - pane.corner, pane.up);
  if (x < 0 || y < 0 || x > pane.width_m || y > pane.height_m) return {};
  Hit at_pane = hit;
  at_pane.position = on_pane;
  if (!is_free(context, at_pane, to_sun)) return {};
  const double passed = context.lights.sun_passed(on_pane + context.world.origin());
  return context.lights.sun_radiance() * way.albedo *
         (passed * cosine * context.lights.sun_solid_angle() / std::numbers::pi);
}

// Light through a pane from the room behind it.
Rgb light_of_room(const TraceContext& context, const Hit& hit, const Bsdf& bsdf, Path path, PathDraw& draw) {
  const RoomWay way = way_through_room(*hit.pane, context.world.origin(), hit.position, path.direction, draw);
  const Rgb passed = Rgb{1, 1, 1} - bsdf.facets_energy();
  path.weight = path.weight * passed * passed;
  const Rgb light = path.weight * sun_in_room(context, hit, way, draw.next());
  path.weight = path.weight * way.weight;
  if (largest_component(path.weight) <= 0) return light;
  Hit at_pane = hit;
  at_pane.position = way.from;
  path.from = leave(at_pane, way.direction), path.direction = way.direction;
  path.is_sharp = false, path.pdf = 0, path.spread_rad = kScattered_rad, ++path.bounce;
  return light + light_behind(context, path, draw);
}

// The guides of a path that leaves the scene: the ground around ends at a sharp horizon.
FirstSurface first_outside(const TraceContext& context, Vec3 from, Vec3 direction) {
  const auto distance_m = context.lights.ground_m(from + context.world.origin(), direction);
  if (!distance_m) return {};
  return {.albedo = {1, 1, 1}, .normal = {0, 0, 1}, .distance_m = *distance_m, .feature = {}};
}

}  // namespace

TracedPath trace(const TraceContext& context, Vec3 from, Vec3 direction, PathDraw& draw) {
  assert(context.bounces >= 0 && context.pixel_rad > 0);
  Path path{.from = from, .direction = direction, .spread_rad = context.pixel_rad};
  const std::optional<Meeting> met = meet(context, path, draw);
  if (!met) return {sound(path.light), first_outside(context, from, direction)};
  const Hit& hit = met->hit;
  const Bsdf& bsdf = met->bsdf;
  Rgb light = path.light;
  const UnitPair choice = draw.next();
  const auto follow = [&](const BsdfSample& drawn) {
    Path next = path;
    if (go_on(context, hit, bsdf, drawn, choice.v, next)) light = light + light_behind(context, next, draw);
  };
  const UnitPair chance = draw.next();
  if (context.bounces > 0 && bsdf.is_split()) {
    follow(bsdf.sample_facets(chance));
    if (hit.pane)
      light = light + light_of_room(context, hit, bsdf, path, draw);
    else
      follow(bsdf.sample_body(choice.u, draw.next()));
  } else if (context.bounces > 0) {
    follow(bsdf.sample(choice.u, chance));
  }
  return {sound(light), {hit.albedo, hit.shading_normal, hit.distance_m, hit.feature}};
}

}  // namespace citykiln::preview
