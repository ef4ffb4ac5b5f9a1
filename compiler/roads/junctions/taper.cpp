#include "compiler/roads/junctions/taper.h"

#include <algorithm>
#include <cassert>

#include "compiler/geometry/snap.h"

namespace citykiln::roads {
namespace {

// The width of the taper at a point of an axis.
struct TaperStation {
  Vec2 at;
  double left_m, right_m;  // seen along the direction from the first arm to the other
};

// By how much the other arm is wider on either side.
struct Excess {
  double left_m, right_m;
};

Excess excess_of(const ArmPath& arm, const ArmPath& other) {
  return {std::max(0.0, other.right_m - arm.left_m), std::max(0.0, other.left_m - arm.right_m)};
}

// The stations from the node to the cut, with widths as seen along the arm.
std::vector<TaperStation> taper_stations_of(const ArmPath& arm, double cut_m, const ArmPath& other) {
  const Excess excess = excess_of(arm, other);
  std::vector<TaperStation> stations;
  double along_m = 0;
  for (std::size_t i = 0; i < arm.axis.size(); ++i) {
    Vec2 at = arm.axis[i];
    const double step_m = i > 0 ? distance(arm.axis[i - 1], at) : 0;
    const bool is_last = along_m + step_m >= cut_m;
    if (is_last && i > 0) at = arm.axis[i - 1] + (at - arm.axis[i - 1]) * ((cut_m - along_m) / step_m);
    along_m = std::min(cut_m, along_m + step_m);
    const double share = 1 - along_m / cut_m;
    const double drift_m = arm.drift * along_m;
    stations.push_back(
        {at, arm.left_m + drift_m + share * excess.left_m, arm.right_m - drift_m + share * excess.right_m});
    if (is_last) break;
  }
  return stations;
}

// The mitre at a station: the offset vector for one metre to the left.
std::optional<Vec2> across(const std::vector<TaperStation>& stations, std::size_t i) {
  constexpr double kSharpestCosine = 0.5;
  const std::size_t last = stations.size() - 1;
  const Vec2 before = unit(stations[std::max<std::size_t>(i, 1)].at - stations[std::max<std::size_t>(i, 1) - 1].at);
  const Vec2 after = i < last ? unit(stations[i + 1].at - stations[i].at) : before;
  if (dot(before, after) < kSharpestCosine) return std::nullopt;
  return mitre_of(before, after);
}

}  // namespace

bool is_taper(Family family, std::span<const ArmLine> lines) {
  constexpr double kStraightCosine = -0.866;
  return family == Family::kStreet && lines.size() == 2 && dot(lines[0].along, lines[1].along) < kStraightCosine;
}

double taper_length_m(const ArmPath& arm, const ArmPath& other) {
  assert(arm.axis.size() >= 2 && other.axis.size() >= 2);
  constexpr double kSlope = 5, kLeast_m = 1;
  const Excess excess = excess_of(arm, other);
  return std::max(kLeast_m, kSlope * std::max(excess.left_m, excess.right_m));
}

std::optional<Ring> taper_ring(const ArmPath& arm, double cut_m, const ArmPath& other, double other_cut_m) {
  assert(arm.axis.size() >= 2 && other.axis.size() >= 2);
  if (cut_m <= 0 || other_cut_m <= 0) return std::nullopt;
  std::vector<TaperStation> stations = taper_stations_of(arm, cut_m, other);
  std::ranges::reverse(stations);
  for (TaperStation& s : stations) std::swap(s.left_m, s.right_m);
  const std::vector<TaperStation> onward = taper_stations_of(other, other_cut_m, arm);
  stations.insert(stations.end(), onward.begin() + 1, onward.end());
  Ring left, ring;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const auto off = across(stations, i);
    if (!off) return std::nullopt;
    left.push_back(snapped(stations[i].at + *off * stations[i].left_m));
    ring.push_back(snapped(stations[i].at - *off * stations[i].right_m));
  }
  ring.insert(ring.end(), left.rbegin(), left.rend());
  return without_repeats(ring);
}

}  // namespace citykiln::roads
