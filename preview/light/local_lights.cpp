#include "preview/light/local_lights.h"

#include <cmath>

#include "compiler/contract/system/for_each_slot.h"
#include "compiler/geometry/trig.h"
#include "compiler/sky/generate.h"
#include "preview/surface/microfacet.h"

namespace citykiln::preview {
namespace {

const double kLanternRise_rad = std::asin(props::kLanternRise);

// The colour of a temperature, with a luminance of 1.
Rgb colour_of(double temperature_k) {
  const auto [r, g, b] = props::black_body_colour(temperature_k);
  return {r, g, b};
}

double area_of(const Emitter& e) { return length(cross(e.edge1, e.edge2)) / 2; }

LightBounds bounds_of(const Emitter& e) {
  const Vec3 a = e.corner, b = a + e.edge1, c = a + e.edge2;
  return {.low = {std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})},
          .high = {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})},
          .axis = unit(cross(e.edge1, e.edge2)),
          .reach_rad = kPi / 2,
          .flux = kPi * area_of(e) * luminance(e.radiance)};
}

// The share of an emitter's light that goes farther than across a room, by rays from its middle.
double far_share(const World& world, const Emitter& emitter) {
  constexpr int kSide = 4;
  constexpr double kRoom_m = 4, kOff_m = 0.002;
  const Vec3 normal = unit(cross(emitter.edge1, emitter.edge2));
  if (!(dot(normal, normal) > 0)) return 0;
  const Vec3 from = emitter.corner + (emitter.edge1 + emitter.edge2) * (1.0 / 3) + normal * kOff_m;
  const Frame frame = frame_about(normal);
  int free = 0;
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j) {
      const double sine2 = (i + 0.5) / kSide, turn = 2 * kPi * (j + 0.5) / kSide, r = std::sqrt(sine2);
      const Vec3 out = frame.out_of({r * std::cos(turn), r * std::sin(turn), std::sqrt(1 - sine2)});
      if (!world.is_blocked(from, unit(out), kRoom_m)) ++free;
    }
  return static_cast<double>(free) / (kSide * kSide);
}

}  // namespace

LocalLights::LocalLights(const World& world, std::span<const StreetLamp> lamps, int threads,
                         std::span<const LitPane> panes)
    : emitters_(world.emitters()), emitter_tree_({}), lamp_tree_({}), panes_(panes, world.origin()) {
  std::vector<LightBounds> bounds = for_each_slot<LightBounds>(emitters_.size(), threads, [&](std::size_t i) {
    LightBounds of = bounds_of(emitters_[i]);
    of.flux *= far_share(world, emitters_[i]);
    return of;
  });
  for (const LightBounds& of : bounds) is_sampled_.push_back(of.flux > 0);
  emitter_tree_ = LightTree(bounds);
  bounds.clear();
  for (const StreetLamp& lamp : lamps) {
    const props::Luminaire& of = lamp.light;
    const double candela = of.lumen / props::beam_sr(of.beam) / sky::kUnitLuminance_cd_m2;
    // lanterns and heads are sized by the lamp's height (compiler/props)
    constexpr double kHead = 0.045;
    const bool shines_down = of.beam == props::Beam::kDown;
    lamps_.push_back(
        {lamp.at - world.origin(), kHead * lamp.height_m, colour_of(of.temperature_k) * candela, shines_down, lamp.up});
    const Lamp& made = lamps_.back();
    bounds.push_back({.low = made.at,
                      .high = made.at,
                      .axis = lamp.up * -1,
                      .reach_rad = shines_down ? kPi / 2 : kPi / 2 + kLanternRise_rad,
                      .flux = kPi * candela,
                      .is_even = !shines_down});
  }
  lamp_tree_ = LightTree(bounds);
}

std::optional<LightSample> LocalLights::light_of(const Lamp& lamp, Vec3 at) const {
  const Vec3 to = lamp.at - at;
  const double distance_m = length(to);
  if (distance_m <= lamp.radius_m) return std::nullopt;
  const Vec3 direction = to * (1 / distance_m);
  double share = dot(direction, lamp.up);  // the cosine below an arm's head
  if (!lamp.shines_down) share = share > -props::kLanternRise ? 1 : 0;
  if (share <= 0) return std::nullopt;
  return LightSample{direction, distance_m - lamp.radius_m, lamp.intensity * (share / (distance_m * distance_m)), 0};
}

std::optional<LightSample> LocalLights::light_of(const Emitter& e, Vec3 at, UnitPair point) const {
  // uniform by area (Heitz, "A Low-Distortion Map Between Triangle and Square", 2019)
  const double u = point.u < point.v ? point.u / 2 : point.u - point.v / 2;
  const double v = point.u < point.v ? point.v - point.u / 2 : point.v / 2;
  const Vec3 to = e.corner + e.edge1 * u + e.edge2 * v - at, across = cross(e.edge1, e.edge2);
  const double distance2 = dot(to, to), facing = -dot(across, to);
  if (!(facing > 0) || !(distance2 > 0)) return std::nullopt;
  const double distance_m = std::sqrt(distance2);
  // per steradian: distance² over cosine and area, where facing = 2 area · cosine · distance
  const double pdf = 2 * distance2 * distance_m / facing;
  // a shadow ray ends before the triangle
  constexpr double kBefore = 1 - 1e-4;
  return LightSample{to * (1 / distance_m), distance_m * kBefore, e.radiance * (1 / pdf), pdf};
}

std::optional<LightSample> LocalLights::sample_lamp(Vec3 at, Vec3 normal, double chance) const {
  const std::optional<LightChoice> chosen = lamp_tree_.choose(at, normal, chance);
  if (!chosen) return std::nullopt;
  std::optional<LightSample> drawn = light_of(lamps_[chosen->light], at);
  if (drawn) drawn->light = drawn->light * (1 / chosen->probability);
  return drawn;
}

std::optional<LightSample> LocalLights::sample_emitter(Vec3 at, Vec3 normal, double chance, UnitPair point) const {
  const std::optional<LightChoice> chosen = emitter_tree_.choose(at, normal, chance);
  if (!chosen) return std::nullopt;
  std::optional<LightSample> drawn = light_of(emitters_[chosen->light], at, point);
  if (drawn) drawn->light = drawn->light * (1 / chosen->probability), drawn->pdf *= chosen->probability;
  return drawn;
}

double LocalLights::pdf(std::uint32_t emitter, Vec3 at, Vec3 normal, Vec3 direction, double distance_m) const {
  if (!is_sampled(emitter)) return 0;
  const Emitter& e = emitters_[emitter];
  const double facing = -dot(cross(e.edge1, e.edge2), direction);
  if (!(facing > 0)) return 0;
  return emitter_tree_.probability(emitter, at, normal) * 2 * distance_m * distance_m / facing;
}

}  // namespace citykiln::preview
