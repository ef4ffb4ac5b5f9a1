#include "compiler/assume/footway_strips.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "compiler/assume/room.h"
#include "compiler/assume/side_rays.h"
#include "compiler/assume/verges.h"
#include "compiler/geometry/segment.h"

namespace citykiln::assume {
namespace {

// A footway runs beside a side that has it at this share of its samples; a side is built up with this share of houses.
constexpr double kLeastFootway = 0.5, kBuiltUp = 0.4;
// The strip ends at this quantile of the distances to an edge of the footway.
constexpr double kFarQuantile = 0.8;

// The distances from the kerb to the edges of the footways that samples see.
struct FootwaySide {
  std::vector<double> near_m, far_m;
  std::size_t samples = 0;

  // Finds the footway whose nearer edge is the nearest to the kerb, within kBesideKerb_m of it.
  void look(const Surroundings& surroundings, std::span<const std::uint32_t> near, const SideRay& ray) {
    double nearest_m = std::numeric_limits<double>::infinity(), farther_m = 0;
    const double most_m = ray.kerb_m + kBesideKerb_m + surroundings.widest_half_m;
    for (const std::uint32_t n : near) {
      const MappedLine& line = surroundings.lines[n];
      if (line.way == nullptr || line.kind != MappedLine::Kind::kPath || !is_footway(*line.way)) continue;
      if (std::abs(dot(unit(line.b - line.a), ray.along)) <= kAlong) continue;
      const auto shares = crossing_shares(ray.at, ray.at + ray.out * most_m, line.a, line.b);
      if (!shares || shares->first * most_m <= ray.kerb_m / 2) continue;
      const double middle_m = shares->first * most_m - ray.kerb_m, edge_m = std::max(0.0, middle_m - line.half_m);
      if (edge_m > kBesideKerb_m || edge_m >= nearest_m) continue;
      nearest_m = edge_m, farther_m = middle_m + line.half_m;
    }
    ++samples;
    if (farther_m > 0) near_m.push_back(nearest_m), far_m.push_back(farther_m);
  }
};

double quantile_of(std::vector<double> values_m, double share) {
  const auto at = values_m.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values_m.size() - 1));
  std::ranges::nth_element(values_m, at);
  return *at;
}

bool is_built_up_beside(const SideFacts& facts) {
  const bool is_town =
      facts.land == LandUse::kResidential || facts.land == LandUse::kShops || facts.land == LandUse::kNone;
  return is_town && facts.houses >= kBuiltUp;
}

FootwayStrip strip_of(const FootwaySide& side, const SideFacts& facts, const map::Track& stretch) {
  if (side.near_m.empty() || !is_built_up_beside(facts)) return {};
  if (static_cast<double>(side.near_m.size()) < kLeastFootway * static_cast<double>(side.samples)) return {};
  return {.may_be_verge = facts.land == LandUse::kResidential && has_usual_verge(stretch, facts.houses),
          .near_m = quantile_of(side.near_m, kFarQuantile),
          .far_m = quantile_of(side.far_m, kFarQuantile)};
}

}  // namespace

BothFootwayStrips footway_strips(const Surroundings& surroundings, const map::Track& stretch) {
  FootwaySide left, right;
  const double about_m = farther_kerb_m(stretch.section) + kBesideKerb_m + surroundings.widest_half_m;
  for_each_side_ray(surroundings, stretch, about_m, [&](const SideRay& ray, std::span<const std::uint32_t> near) {
    (ray.is_left ? left : right).look(surroundings, near, ray);
  });
  if (left.near_m.empty() && right.near_m.empty()) return {};
  const BothSides facts = facts_beside(surroundings, stretch);
  return {strip_of(left, facts.left, stretch), strip_of(right, facts.right, stretch)};
}

}  // namespace citykiln::assume
