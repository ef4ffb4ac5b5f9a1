#include "compiler/ground/profiles/smoothing/profile_knots.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/geometry/snap.h"

namespace citykiln::ground {
namespace {

constexpr double kKnotStep_m = 0.125;

struct KnotCandidate {
  Knot knot;
  bool is_kept = false;
};

// Direction of an axis at increasing distances: at a vertex half-way between both segments.
class Directions {
 public:
  explicit Directions(const Polyline& axis) : axis_(axis) {}

  Vec2 at(double at_m) {
    while (segment_ + 2 < axis_.size() && passed_m_ + own_m() <= at_m - 1e-3) passed_m_ += own_m(), ++segment_;
    const Vec2 before = along(segment_);
    const bool is_vertex = segment_ + 2 < axis_.size() && std::abs(passed_m_ + own_m() - at_m) < 1e-3;
    return is_vertex ? unit(before + along(segment_ + 1)) : before;
  }

 private:
  double own_m() const { return snapped(distance(axis_[segment_], axis_[segment_ + 1])); }
  Vec2 along(std::size_t i) const { return unit(axis_[i + 1] - axis_[i]); }

  const Polyline& axis_;
  std::size_t segment_ = 0;
  double passed_m_ = 0;
};

// Returns the height of a knot `after_m` beside its station such that the profile has the station's height at the
// station.
double height_beside(std::span<const Station> stations, std::size_t s, std::span<const double> z_m, double after_m) {
  const double own_m = z_m[stations[s].node];
  const std::size_t other = after_m > 0 ? s - 1 : s + 1;
  if (after_m == 0 || other >= stations.size()) return own_m;
  return own_m + (z_m[stations[other].node] - own_m) * after_m / (stations[other].at_m - stations[s].at_m);
}

// A station and the place of its knot, on the profile's grid.
struct Placed {
  std::size_t station;
  double at_m;
};

// If two stations are rounded to one place, the way's end gets the knot. But an end that meets nothing leaves its knot
// to a junction beside it, since rounding of two knots so close would tilt the piece between them.
std::vector<Placed> knot_places_of(const ProfileGraph& graph, std::span<const Station> stations) {
  const auto is_free_end = [&](std::size_t s) { return graph.legs_of(stations[s].node).size() == 1; };
  const auto is_meeting = [&](std::size_t s) { return graph.legs_of(stations[s].node).size() > 2; };
  std::vector<Placed> places;
  for (std::size_t s = 0; s < stations.size(); ++s) {
    const bool is_last = s + 1 == stations.size(), is_second = places.size() == 1;
    const double at_m =
        is_last ? std::floor(stations[s].at_m / kKnotStep_m) * kKnotStep_m : snapped_to(kKnotStep_m, stations[s].at_m);
    const double gap_m = places.empty() ? at_m + 1 : at_m - places.back().at_m;
    if (is_last && !is_second && gap_m <= kKnotStep_m && is_free_end(s) && is_meeting(places.back().station))
      places.back().at_m = at_m;
    else if (!is_last && is_second && gap_m <= kKnotStep_m && is_free_end(0) && is_meeting(s))
      places.back().station = s;
    else if (is_last && !is_second && gap_m <= 0)
      places.back() = {s, at_m};
    else if (is_last || gap_m > 0)
      places.push_back({s, at_m});
  }
  return places;
}

std::vector<KnotCandidate> candidates_of(const ProfileGraph& graph, const GraphWay& way, const JunctionPlanes& planes) {
  std::vector<KnotCandidate> candidates;
  Directions directions(way.track->axis);
  const std::span<const Station> stations = graph.stations_of(way);
  const std::vector<Placed> places = knot_places_of(graph, stations);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto [s, at_m] = places[i];
    const bool is_last = i + 1 == places.size();
    const std::uint32_t node = stations[s].node;
    // level beyond the last
    const double after_m = is_last ? std::max(0.0, at_m - stations[s].at_m) : at_m - stations[s].at_m;
    const double z_m = height_beside(stations, s, planes.z_m, after_m);
    const double tilt = dot(planes.gradient[node], left_of(directions.at(stations[s].at_m)));
    const Knot knot{at_m, snapped_to(kProfileQuantum_m, z_m), snapped_to(kTiltQuantum, tilt)};
    const bool is_new_stretch =
        i > 0 && std::floor(at_m / kKnotStretch_m) > std::floor(places[i - 1].at_m / kKnotStretch_m);
    candidates.push_back({knot, i == 0 || is_last || is_new_stretch || graph.legs_of(node).size() != 2});
  }
  return candidates;
}

double miss_m(const Knot& a, const Knot& b, const Knot& k) {
  const double t = (k.at_m - a.at_m) / (b.at_m - a.at_m);
  const double z = a.z_m + (b.z_m - a.z_m) * t, tilt = a.tilt + (b.tilt - a.tilt) * t;
  return std::max(std::abs(k.z_m - z), std::abs(k.tilt - tilt) * kTiltArm_m);
}

void keep_bends(std::vector<KnotCandidate>& candidates, std::size_t first, std::size_t last) {
  double worst_m = kKnotError_m;
  std::size_t at = first;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double m = miss_m(candidates[first].knot, candidates[last].knot, candidates[i].knot);
    if (m > worst_m) worst_m = m, at = i;
  }
  if (at == first) return;
  candidates[at].is_kept = true;
  keep_bends(candidates, first, at);
  keep_bends(candidates, at, last);
}

}  // namespace

Profile knots_of(const ProfileGraph& graph, const GraphWay& way, const JunctionPlanes& planes) {
  assert(planes.z_m.size() == graph.nodes.size() && planes.gradient.size() == graph.nodes.size());
  std::vector<KnotCandidate> candidates = candidates_of(graph, way, planes);
  for (std::size_t first = 0, i = 1; i < candidates.size(); ++i) {
    if (!candidates[i].is_kept) continue;
    keep_bends(candidates, first, i);
    first = i;
  }
  Profile profile;
  for (const KnotCandidate& c : candidates)
    if (c.is_kept) profile.push_back(c.knot);
  return profile;
}

}  // namespace citykiln::ground
