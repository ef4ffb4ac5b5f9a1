#include "compiler/fields/lane_hedges.h"

#include <algorithm>

#include "compiler/contract/derived_id.h"
#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/plane/plane.h"

namespace citykiln::fields {
namespace {

using map::LandCoverClass;

constexpr double kHedgeStep_m = 4;

bool is_lane(const roads::Road& road) {
  return road.surface == LandCoverClass::kResidentialRoad || road.surface == LandCoverClass::kTertiaryRoad ||
         road.surface == LandCoverClass::kSecondaryRoad;
}

// A line to the left of an axis, with points where the axis bends.
Polyline beside_axis(const Polyline& axis, double left_m) {
  constexpr double kLeastCosine = 0.5;
  Polyline line;
  for (std::size_t i = 0; i < axis.size(); ++i) {
    const Vec2 before = i > 0 ? unit(axis[i] - axis[i - 1]) : unit(axis[1] - axis[0]);
    const Vec2 after = i + 1 < axis.size() ? unit(axis[i + 1] - axis[i]) : before;
    const Vec2 middle = unit(before + after);
    line.push_back(axis[i] + left_of(middle) * (left_m / std::max(dot(middle, after), kLeastCosine)));
  }
  return line;
}

// Collects the stretches of a line that are free.
class HedgeRuns {
 public:
  void add(Vec2 at, bool is_free, bool is_corner) {
    if (!is_free) return finish();
    last_ = snapped_to(map::kMapStep_m, at);
    if (run_.empty() || is_corner) run_.push_back(last_);
  }
  void finish() {
    if (!run_.empty() && run_.back() != last_) run_.push_back(last_);
    if (run_.size() >= 2 && length_m(run_) >= kShortestLaneHedge_m) runs.push_back(run_);
    run_.clear();
  }
  std::vector<Polyline> runs;

 private:
  Polyline run_;
  Vec2 last_;
};

std::vector<Polyline> free_runs(const Polyline& line, const BarrierPlaces& places) {
  HedgeRuns runs;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const int steps = 1 + static_cast<int>(distance(line[i], line[i + 1]) / kHedgeStep_m);
    for (int k = 0; k < steps; ++k) {
      const Vec2 at = line[i] + (line[i + 1] - line[i]) * (static_cast<double>(k) / steps);
      runs.add(at, places.is_beside_lane(at), k == 0);
    }
  }
  if (!line.empty()) runs.add(line.back(), places.is_beside_lane(line.back()), true);
  runs.finish();
  return std::move(runs.runs);
}

}  // namespace

std::vector<map::Barrier> lane_hedges(const FieldInputs& inputs, const BarrierPlaces& places, Report& report) {
  std::vector<map::Barrier> hedges;
  OsmId last{};
  for (const roads::Road& road : inputs.roads) {
    if (!is_lane(road) || road.axis.size() < 2) continue;
    const FieldRule rule = inputs.rule_at(road.axis[road.axis.size() / 2]);
    if (rule.border != FieldBorder::kHedge) continue;
    const RandomSequence draw(inputs.seed, stable_id(road.id), "lane hedge");
    std::uint32_t count = 0;
    for (const double left_m : {roads::left_m(road) + kLaneVerge_m, -roads::right_m(road) - kLaneVerge_m})
      for (Polyline& axis : free_runs(beside_axis(road.axis, left_m), places))
        hedges.push_back({.id = roadside_id(road.id, count++),
                          .axis = std::move(axis),
                          .kind = map::BarrierKind::kHedge,
                          .height_m = 1.5 + 0.125 * draw.below(7, 0),
                          .width_m = 1.25});
    if (count > 0 && last != road.id.osm) report.count_assumed(Assumption::kRoadsides, road.id.osm), last = road.id.osm;
  }
  return hedges;
}

}  // namespace citykiln::fields
