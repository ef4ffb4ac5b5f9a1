#include "compiler/map/lanes/lane_widths.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/geometry/snap.h"

namespace citykiln::map {
namespace {

constexpr double kLeastWidth_m = 0.3, kMostWidth_m = 80;

// A row of parked cars that no tag states.
constexpr double kParkedRow_m = 2.5;

double inside_m(const PerFlow<std::vector<RoadsideLane>>& roadsides) {
  double sum = 0;
  for (const Flow flow : kFlows)
    for (const RoadsideLane& lane : roadsides[flow]) sum += lane.inside_m;
  return sum;
}

// Divides a width into whole quanta; the first lanes get one more each if it does not divide evenly.
void share(double width_m, std::span<Lane* const> lanes) {
  const auto quanta = static_cast<std::int64_t>(std::llround(width_m / kQuantum_m));
  const auto n = static_cast<std::int64_t>(lanes.size());
  for (std::int64_t i = 0; i < n; ++i)
    lanes[static_cast<std::size_t>(i)]->width_m =
        static_cast<double>(quanta / n + (i < quanta % n ? 1 : 0)) * kQuantum_m;
}

// Merges two lanes that no tag counted into one, of their flow or of both.
void merge_two_lanes(MovingLanes& moving) {
  const std::vector<Lane*> lanes = moving.all();
  if (moving.is_tagged || lanes.size() != 2 || lanes[0]->kind != lanes[1]->kind) return;
  Lane one = *lanes[0];
  std::vector<Lane>& place = one.way == lanes[1]->way && one.way != LaneDirection::kBoth
                                 ? moving.flows[one.way == LaneDirection::kForward ? Flow::kForward : Flow::kBackward]
                                 : moving.middle;
  if (one.way != lanes[1]->way) one.way = LaneDirection::kBoth;
  for (const Flow flow : kFlows) moving.flows[flow].clear();
  place = {one};
}

// Diagnoses the tag of the width, which contradicts the lanes.
void add_bad_width(const LaneTags& tags) { tags.add_bad_value(tags("width").empty() ? "est_width" : "width"); }

// True if a width of the carriageway can be that of these lanes.
bool is_credible(double width_m, const PerFlow<std::vector<RoadsideLane>>& roadsides, const MovingLanes& moving) {
  if (!moving.is_tagged) return true;
  double beside_m = inside_m(roadsides);
  for (const Flow flow : kFlows)
    if (roadsides[flow].empty()) beside_m += kParkedRow_m;
  return width_m - beside_m <= kWidestLane_m * moving.counted;
}

}  // namespace

std::optional<double> tagged_width_m(const LaneTags& tags) {
  for (const char* key : {"width", "est_width"})
    if (const auto tagged = tagged_length_m(tags.context, tags.id, tags.tags, key, kLeastWidth_m, kMostWidth_m))
      return std::max(kQuantum_m, snapped(*tagged));
  return std::nullopt;
}

std::optional<double> credible_width_m(const LaneTags& tags, const PerFlow<std::vector<RoadsideLane>>& roadsides,
                                       const MovingLanes& moving) {
  const auto tagged_m = tagged_width_m(tags);
  if (!tagged_m || is_credible(*tagged_m, roadsides, moving)) return tagged_m;
  add_bad_width(tags);
  return std::nullopt;
}

void share_widths(const LaneTags& tags, const LaneClass& lane_class, std::optional<double> tagged_m,
                  const PerFlow<std::vector<RoadsideLane>>& roadsides, MovingLanes& moving) {
  assert(!moving.all().empty());
  const double inside = inside_m(roadsides);
  if (tagged_m && *tagged_m - inside < kNarrowestMeeting_m) merge_two_lanes(moving);

  // widths that width:lanes has set
  double listed_m = 0, driven = 0;
  std::vector<Lane*> open;
  for (Lane* lane : moving.all()) {
    listed_m += lane->width_m;
    driven += lane->kind == LaneKind::kCycle ? 0 : 1;
    if (lane->width_m == 0) open.push_back(lane);
  }
  if (open.empty()) return;
  const auto n = static_cast<double>(open.size());
  double rest_m = snapped(lane_class.width_m_of(moving.counted));
  // the other lanes have the width they would have without width:lanes
  if (listed_m > 0) rest_m = snapped(lane_class.width_m_of(driven) * n / driven);
  if (tagged_m) {
    rest_m = *tagged_m - inside - listed_m;
    const bool is_alone = open.size() == 1 && inside + listed_m == 0;
    if (!is_alone && rest_m < n * kNarrowestLane_m) {
      add_bad_width(tags);
      rest_m = n * kNarrowestLane_m;
    }
  }
  share(rest_m, open);
}

}  // namespace citykiln::map
