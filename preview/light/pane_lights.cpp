#include "preview/light/pane_lights.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/snap.h"
#include "compiler/geometry/trig.h"

namespace citykiln::preview {
namespace {

// Largest distance along a ray between a shining surface and its pane: coarse levels show windows on the wall.
constexpr double kNear_m = 1.5;

}  // namespace

PaneLights::PaneLights(std::span<const LitPane> panes, Vec3 origin) {
  std::vector<LitPane> sorted(panes.begin(), panes.end());
  std::ranges::stable_sort(sorted, {}, &LitPane::building);
  std::vector<LightBounds> bounds;
  for (const LitPane& p : sorted) {
    panes_.push_back(
        {p.building, p.corner - origin, at_height(p.along, 0), {p.along.y, -p.along.x, 0}, p.width_m, p.height_m});
    const Vec3 a = panes_.back().corner, b = a + panes_.back().along * p.width_m + Vec3{0, 0, p.height_m};
    bounds.push_back({.low = {std::min(a.x, b.x), std::min(a.y, b.y), a.z},
                      .high = {std::max(a.x, b.x), std::max(a.y, b.y), b.z},
                      .axis = panes_.back().outward,
                      .reach_rad = kPi / 2,
                      .flux = kPi * p.width_m * p.height_m * p.luminance});
  }
  tree_ = LightTree(bounds);
}

double PaneLights::Pane::crossing_m(Vec3 at, Vec3 direction) const {
  const double facing = -dot(outward, direction);
  if (!(facing > 0)) return -1;
  const double distance_m = dot(at - corner, outward) / facing;
  const Vec3 through = at + direction * distance_m - corner;
  const double x = dot(through, along);
  return x >= 0 && x <= width_m && through.z >= 0 && through.z <= height_m ? distance_m : -1;
}

std::optional<PaneSample> PaneLights::sample(Vec3 at, Vec3 normal, double chance, UnitPair point) const {
  const std::optional<LightChoice> chosen = tree_.choose(at, normal, chance);
  if (!chosen) return std::nullopt;
  const Pane& pane = panes_[chosen->light];
  const Vec3 to = pane.corner + pane.along * (point.u * pane.width_m) + Vec3{0, 0, point.v * pane.height_m} - at;
  const double distance_m = length(to), facing = -dot(pane.outward, to);
  if (!(facing > 0)) return std::nullopt;
  const double pdf =
      chosen->probability * distance_m * distance_m * distance_m / (facing * pane.width_m * pane.height_m);
  return PaneSample{to * (1 / distance_m), chosen->light, pdf};
}

std::uint32_t PaneLights::pane_of(const Hit& hit, Vec3 at, Vec3 direction) const {
  if (hit.feature == OsmId{}) return kNoPane;
  const double hit_m = dot(hit.position - at, direction);
  std::uint32_t best = kNoPane;
  double nearest_m = kNear_m;
  const auto first = std::ranges::lower_bound(panes_, hit.feature, {}, &Pane::building);
  for (auto pane = first; pane != panes_.end() && pane->building == hit.feature; ++pane) {
    const double crossing_m = pane->crossing_m(at, direction), off_m = std::abs(crossing_m - hit_m);
    if (!(crossing_m > 0) || off_m >= nearest_m) continue;
    nearest_m = off_m, best = static_cast<std::uint32_t>(pane - panes_.begin());
  }
  return best;
}

double PaneLights::pdf(std::uint32_t pane, Vec3 at, Vec3 normal, Vec3 direction) const {
  if (pane == kNoPane) return 0;
  const Pane& of = panes_[pane];
  const double distance_m = of.crossing_m(at, direction), facing = -dot(of.outward, direction);
  if (!(distance_m > 0)) return 0;
  return tree_.probability(pane, at, normal) * distance_m * distance_m / (facing * of.width_m * of.height_m);
}

}  // namespace citykiln::preview
