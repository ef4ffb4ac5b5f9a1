#include "compiler/assume/footway_strips.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "compiler/assume/room.h"
#include "compiler/assume/verges.h"
#include "compiler/geometry/segment.h"

namespace citykiln::assume {
namespace {

constexpr double kFootwayStep_m = 8;
// A footway runs beside a side that has it at this share of its samples; a side is built up with this share of houses.
constexpr double kLeastFootway = 0.5, kBuiltUp = 0.4;
// The strip ends at this quantile of the distances to an edge of the footway.
constexpr double kFarQuantile = 0.8;

// The distances from the kerb to the edges of the footways that samples see.
struct FootwaySide {
  std::vector<double> near_m, far_m;
  std::size_t samples = 0;

  void look(const Surroundings& surroundings, std::span<const std::uint32_t> near, Vec2 at, Vec2 along, Vec2 out,
            double kerb_m) {
    double nearest_m = std::numeric_limits<double>::infinity(), farther_m = 0;
    const double most_m = kerb_m + kBesideKerb_m;
    for (const std::uint32_t n : near) {
      const MappedLine& line = surroundings.lines[n];
      if (line.way == nullptr || line.kind != MappedLine::Kind::kPath || !is_footway(*line.way)) continue;
      if (std::abs(dot(unit(line.b - line.a), along)) <= kAlong) continue;
      const auto shares = crossing_shares(at, at + out * most_m, line.a, line.b);
      if (!shares || shares->first * most_m <= kerb_m / 2) continue;
      const double edge_m = std::max(0.0, shares->first * most_m - kerb_m - line.half_m);
      if (edge_m < nearest_m) nearest_m = edge_m, farther_m = shares->first * most_m - kerb_m + line.half_m;
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
  const double left_m = left_kerb_m(stretch.section), right_m = right_kerb_m(stretch.section);
  FootwaySide left, right;
  for (std::size_t i = 0; i + 1 < stretch.axis.size(); ++i) {
    const Vec2 a = stretch.axis[i], b = stretch.axis[i + 1], along = unit(b - a), out = left_of(along);
    const Box2 box = box_of_segment(a, b).widened(std::max(left_m, right_m) + kBesideKerb_m);
    const std::vector<std::uint32_t> near = boxes_about(surroundings.line_grid, box);
    const int count = std::max(1, static_cast<int>(std::floor(distance(a, b) / kFootwayStep_m + 0.5)));
    for (int k = 0; k < count; ++k) {
      const Vec2 at = a + (b - a) * ((k + 0.5) / count);
      left.look(surroundings, near, at, along, out, left_m);
      right.look(surroundings, near, at, along, out * -1.0, right_m);
    }
  }
  if (left.near_m.empty() && right.near_m.empty()) return {};
  const BothSides facts = facts_beside(surroundings, stretch);
  return {strip_of(left, facts.left, stretch), strip_of(right, facts.right, stretch)};
}

}  // namespace citykiln::assume
