#include "compiler/structures/risers.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/snap.h"

namespace citykiln::structures {
namespace {

constexpr double kRiserSpacing_m = 0.5;

// All that a way climbs and descends.
double climb_m(const Polyline& axis, const ground::GradedTerrain& ground) {
  double climb = 0, last_m = ground::land_m(ground, axis.front());
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
    const double count = std::max(1.0, std::ceil(distance(axis[i], axis[i + 1]) / kRiserSpacing_m));
    for (double k = 1; k <= count; ++k) {
      const double z_m = ground::land_m(ground, axis[i] + (axis[i + 1] - axis[i]) * (k / count));
      climb += std::abs(z_m - last_m), last_m = z_m;
    }
  }
  return climb;
}

}  // namespace

std::vector<roads::Road> with_risers(std::span<const roads::Road> without, std::span<const map::Track> tracks,
                                     const ground::GradedTerrain& ground, Report& report) {
  std::vector<roads::Road> roads(without.begin(), without.end());
  for (roads::Road& road : roads) {
    if (road.surface != map::LandCoverClass::kSteps) continue;
    const auto track = std::ranges::lower_bound(tracks, road.id, {}, &map::Track::id);
    if (track == tracks.end() || track->id != road.id) continue;
    road.handrails = track->handrails;
    if (track->step_count == 0) continue;
    const double riser_m = climb_m(road.axis, ground) / track->step_count;
    if (riser_m >= kLowestRiser_m && riser_m <= kHighestRiser_m)
      road.riser_m = snapped(riser_m);
    else
      report.add(Code::kStepCountContradicts, road.id.osm, riser_m);
  }
  return roads;
}

}  // namespace citykiln::structures
