#include "preview/light/light_tree.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "compiler/geometry/trig.h"
#include "preview/surface/microfacet.h"

namespace citykiln::preview {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
constexpr int kBins = 12;

Vec3 least(Vec3 a, Vec3 b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
Vec3 most(Vec3 a, Vec3 b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }
Vec3 middle(const LightBounds& b) { return (b.low + b.high) * 0.5; }
double along(Vec3 v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

double angle_between(Vec3 a, Vec3 b) { return std::acos(std::clamp(dot(a, b), -1.0, 1.0)); }

// Turns a unit vector towards another by an angle.
Vec3 turned_towards(Vec3 from, Vec3 towards, double angle) {
  const Vec3 across = unit(towards - from * dot(from, towards));
  const Vec3 side = dot(across, across) > 0 ? across : frame_about(from).x;
  return unit(from * std::cos(angle) + side * std::sin(angle));
}

// Sets the cone of normals around those of both.
void join_cones(LightBounds& joined, const LightBounds& a, const LightBounds& b) {
  joined.reach_rad = std::max(a.reach_rad, b.reach_rad);
  const LightBounds &wide = a.spread_rad >= b.spread_rad ? a : b, &narrow = a.spread_rad >= b.spread_rad ? b : a;
  const double between = angle_between(wide.axis, narrow.axis);
  joined.axis = wide.axis, joined.spread_rad = wide.spread_rad;
  if (std::min(between + narrow.spread_rad, kPi) <= wide.spread_rad) return;
  const double spread = (wide.spread_rad + between + narrow.spread_rad) / 2;
  joined.spread_rad = std::min(spread, kPi);
  if (spread < kPi) joined.axis = turned_towards(wide.axis, narrow.axis, spread - wide.spread_rad);
}

// The solid angle, weighted by cosine, into which a cone of surfaces shines.
double cone_measure(const LightBounds& b) {
  const double spread = b.spread_rad, whole = std::min(spread + b.reach_rad, kPi);
  return 2 * kPi * (1 - std::cos(spread)) + kPi / 2 *
                                                (2 * whole * std::sin(spread) - std::cos(spread - 2 * whole) -
                                                 2 * spread * std::sin(spread) + std::cos(spread));
}

double area_measure(const LightBounds& b) {
  const Vec3 d = b.high - b.low;
  return 2 * (d.x * d.y + d.y * d.z + d.z * d.x);
}

double cost_of(const LightBounds& b) { return b.flux * cone_measure(b) * area_measure(b); }

// Where sources are divided: by bins along an axis.
struct Split {
  int axis = -1;
  int bin = 0;
  double cost = std::numeric_limits<double>::infinity();
};

int bin_of(double at, double low, double high) {
  return std::clamp(static_cast<int>((at - low) / (high - low) * kBins), 0, kBins - 1);
}

Split best_split(std::span<const LightBounds> lights, std::span<const std::uint32_t> of, Vec3 low, Vec3 high) {
  Split best;
  const Vec3 size = high - low;
  const double longest = std::max({size.x, size.y, size.z});
  for (int axis = 0; axis < 3; ++axis) {
    const double from = along(low, axis), to = along(high, axis);
    if (!(to > from)) continue;
    std::array<std::optional<LightBounds>, kBins> bins;
    for (const std::uint32_t light : of) {
      std::optional<LightBounds>& bin = bins[bin_of(along(middle(lights[light]), axis), from, to)];
      bin = bin ? joined(*bin, lights[light]) : lights[light];
    }
    std::array<double, kBins> after{};
    std::optional<LightBounds> all;
    for (int i = kBins - 1; i > 0; --i) {
      if (bins[i]) all = all ? joined(*all, *bins[i]) : *bins[i];
      after[i] = all ? cost_of(*all) : std::numeric_limits<double>::infinity();
    }
    all.reset();
    for (int i = 0; i + 1 < kBins; ++i) {
      if (bins[i]) all = all ? joined(*all, *bins[i]) : *bins[i];
      if (!all) continue;
      // thin boxes are better divided along their length
      const double cost = (cost_of(*all) + after[i + 1]) * longest / (to - from);
      if (cost < best.cost) best = {axis, i, cost};
    }
  }
  return best;
}

// cos(max(0, a - b)) by the sines and cosines of both angles.
double cos_of_difference(double sin_a, double cos_a, double sin_b, double cos_b) {
  return cos_a > cos_b ? 1 : cos_a * cos_b + sin_a * sin_b;
}
double sin_of_difference(double sin_a, double cos_a, double sin_b, double cos_b) {
  return cos_a > cos_b ? 0 : sin_a * cos_b - cos_a * sin_b;
}
double sine_of(double cosine) { return std::sqrt(std::max(0.0, 1 - cosine * cosine)); }

}  // namespace

LightBounds joined(const LightBounds& a, const LightBounds& b) {
  LightBounds all;
  all.low = least(a.low, b.low), all.high = most(a.high, b.high), all.flux = a.flux + b.flux;
  all.is_even = a.is_even || b.is_even;
  join_cones(all, a, b);
  return all;
}

LightTree::LightTree(std::span<const LightBounds> lights) : leaf_of_(lights.size(), kNone) {
  std::vector<std::uint32_t> shining;
  for (std::uint32_t i = 0; i < lights.size(); ++i)
    if (lights[i].flux > 0) shining.push_back(i);
  nodes_.reserve(2 * shining.size());
  if (!shining.empty()) build(lights, shining, 0);
}

// Adds the node of some sources and all below it, parents first.
LightBounds LightTree::build(std::span<const LightBounds> lights, std::span<std::uint32_t> of, std::uint32_t parent) {
  const auto own = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({});
  LightBounds bounds = lights[of.front()];
  std::uint32_t second = 0;
  if (of.size() == 1) {
    leaf_of_[of.front()] = own;
  } else {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    Vec3 low{kFar, kFar, kFar}, high{-kFar, -kFar, -kFar};
    for (const std::uint32_t i : of) low = least(low, middle(lights[i])), high = most(high, middle(lights[i]));
    const Split split = best_split(lights, of, low, high);
    auto half = of.begin() + static_cast<std::ptrdiff_t>(of.size() / 2);
    if (split.axis >= 0) {
      const double from = along(low, split.axis), to = along(high, split.axis);
      const auto is_first = [&](std::uint32_t i) {
        return bin_of(along(middle(lights[i]), split.axis), from, to) <= split.bin;
      };
      const auto after = std::stable_partition(of.begin(), of.end(), is_first);
      if (after != of.begin() && after != of.end()) half = after;
    }
    const auto first = static_cast<std::size_t>(half - of.begin());
    const LightBounds before = build(lights, of.first(first), own);
    second = static_cast<std::uint32_t>(nodes_.size());
    bounds = joined(before, build(lights, of.subspan(first), own));
  }
  nodes_[own] = {.centre = middle(bounds),
                 .half = (bounds.high - bounds.low) * 0.5,
                 .axis = bounds.axis,
                 .radius_m = length(bounds.high - bounds.low) / 2,
                 .flux = bounds.flux,
                 .cos_spread = std::cos(bounds.spread_rad),
                 .sin_spread = std::sin(bounds.spread_rad),
                 .cos_reach = std::cos(bounds.reach_rad),
                 .light = of.front(),
                 .second = second,
                 .parent = parent,
                 .is_even = bounds.is_even};
  return bounds;
}

// An estimate of the light that a group sends to a place: its flux over the square of the distance, times the largest
// cosines, at its surfaces and at the receiving one, of any point in its box. 0 only where no point sends light.
double LightTree::importance(const Node& node, Vec3 at, Vec3 normal) {
  const Vec3 from = at - node.centre;
  const double distance2 = dot(from, from), radius2 = node.radius_m * node.radius_m;
  // of a group around the place, some are nearer than its centre
  constexpr double kNearer = 0.25, kLeast_m2 = 1e-6;
  const double apart2 = std::max({distance2, kNearer * radius2, kLeast_m2});
  double shine = node.flux / apart2;
  if (dot(normal, normal) > 0) {
    const double rise = std::abs(normal.x) * node.half.x + std::abs(normal.y) * node.half.y +
                        std::abs(normal.z) * node.half.z - dot(normal, from);
    if (rise <= 0) return 0;
    shine *= std::min(1.0, rise / std::sqrt(apart2));
  }
  if (distance2 <= radius2) return shine;
  const Vec3 away = from * (1 / std::sqrt(distance2));
  const double sin_sphere = std::sqrt(radius2 / distance2), cos_sphere = sine_of(sin_sphere);
  const double cos_axis = dot(node.axis, away), sin_axis = sine_of(cos_axis);
  const double cos_off = cos_of_difference(sin_axis, cos_axis, node.sin_spread, node.cos_spread);
  const double sin_off = sin_of_difference(sin_axis, cos_axis, node.sin_spread, node.cos_spread);
  const double cos_out = cos_of_difference(sin_off, cos_off, sin_sphere, cos_sphere);
  if (cos_out <= node.cos_reach) return 0;
  if (node.is_even) return shine;
  // surfaces of several directions shine sideways, too
  constexpr double kLeast = 0.05;
  return shine * std::max(cos_out, kLeast);
}

// The probability of the first child; negative if neither lights the place.
double LightTree::first_share(std::uint32_t node, Vec3 at, Vec3 normal) const {
  const double first = importance(nodes_[node + 1], at, normal);
  const double second = importance(nodes_[nodes_[node].second], at, normal);
  return first + second > 0 ? first / (first + second) : -1;
}

// True for groups to be divided: from within about 1.4 radii some sources may be far nearer than the centre, and one
// estimate for all says little.
bool LightTree::is_around(const Node& node, Vec3 at) {
  constexpr double kReach2 = 2;
  const Vec3 from = at - node.centre;
  return node.second != 0 && dot(from, from) < kReach2 * node.radius_m * node.radius_m;
}

LightTree::Parts LightTree::parts_at(Vec3 at, Vec3 normal) const {
  Parts parts;
  boost::container::small_vector<std::uint32_t, 64> waiting = {0};
  while (!waiting.empty()) {
    const std::uint32_t node = waiting.back();
    waiting.pop_back();
    if (is_around(nodes_[node], at)) {
      waiting.push_back(nodes_[node].second), waiting.push_back(node + 1);
      continue;
    }
    const double weight = importance(nodes_[node], at, normal);
    if (weight > 0) parts.each.push_back({node, weight}), parts.sum += weight;
  }
  return parts;
}

std::optional<LightChoice> LightTree::choose(Vec3 at, Vec3 normal, double chance) const {
  if (nodes_.empty()) return std::nullopt;
  const Parts parts = parts_at(at, normal);
  if (parts.each.empty()) return std::nullopt;
  double before = chance * parts.sum;
  std::size_t drawn = 0;
  while (drawn + 1 < parts.each.size() && before >= parts.each[drawn].weight) before -= parts.each[drawn++].weight;
  const Part& part = parts.each[drawn];
  return choose_below(part.node, part.weight / parts.sum, at, normal, before / part.weight);
}

std::optional<LightChoice> LightTree::choose_below(std::uint32_t node, double probability, Vec3 at, Vec3 normal,
                                                   double chance) const {
  while (nodes_[node].second != 0) {
    const double share = first_share(node, at, normal);
    if (share < 0) return std::nullopt;
    const bool is_first = chance < share;
    chance = is_first ? chance / share : (chance - share) / (1 - share);
    chance = std::clamp(chance, 0.0, 1 - 0x1p-53);
    probability *= is_first ? share : 1 - share;
    node = is_first ? node + 1 : nodes_[node].second;
  }
  return LightChoice{nodes_[node].light, probability};
}

double LightTree::probability(std::uint32_t light, Vec3 at, Vec3 normal) const {
  assert(light < leaf_of_.size());
  if (leaf_of_[light] == kNone) return 0;
  // the part that holds the source, and the probability of the source within it
  std::uint32_t part = leaf_of_[light];
  double within = 1, below = 1;
  for (std::uint32_t node = part; node != 0; node = nodes_[node].parent) {
    const std::uint32_t parent = nodes_[node].parent;
    const double share = first_share(parent, at, normal);
    if (share < 0) return 0;
    below *= node == parent + 1 ? share : 1 - share;
    if (!is_around(nodes_[parent], at)) part = parent, within = below;
  }
  const Parts parts = parts_at(at, normal);
  for (const Part& each : parts.each)
    if (each.node == part) return each.weight / parts.sum * within;
  return 0;
}

}  // namespace citykiln::preview
