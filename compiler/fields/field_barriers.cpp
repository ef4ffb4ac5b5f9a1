#include "compiler/fields/field_barriers.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "compiler/contract/derived_id.h"
#include "compiler/fields/add_fields.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/plane/plane.h"

namespace citykiln::fields {
namespace {

using map::LandCoverClass;

constexpr double kAreaBucket_m = 128;
// Places along a border are tested this far apart.
constexpr double kTestStep_m = 3;

bool is_farmed(LandCoverClass surface) {
  return surface == LandCoverClass::kFarmland || surface == LandCoverClass::kMeadow ||
         surface == LandCoverClass::kUnknown;
}

lots::Capsules waters_of(const map::FeatureView& features) {
  std::vector<lots::Capsule> strips;
  for (const map::Waterway& water : features.waterways) {
    if (water.passage != map::Passage::kGround) continue;
    const double half_m = std::max(water.width_m, water.most_width_m) / 2;
    for (std::size_t i = 0; i + 1 < water.axis.size(); ++i)
      strips.push_back({water.axis[i], water.axis[i + 1], half_m});
  }
  return lots::index_capsules(std::move(strips));
}

map::Barrier barrier_of(FieldBorder border, const RandomSequence& draw) {
  const bool is_hedge = border == FieldBorder::kHedge;
  const double height_m = is_hedge ? 1.5 + 0.125 * draw.below(9, 1) : 0.75 + 0.125 * draw.below(4, 1);
  return {.id = {},
          .axis = {},
          .kind = is_hedge ? map::BarrierKind::kHedge : map::BarrierKind::kWall,
          .height_m = height_m,
          .width_m = is_hedge ? 1.25 : 0.5};
}

// From and to, in metres along a line.
using Stretch = std::pair<double, double>;

// The parts of a stretch that are free at every kTestStep_m, of kShortestBarrier_m or more.
std::vector<Stretch> free_stretches(Stretch whole, const std::function<bool(double)>& is_free) {
  std::vector<Stretch> found;
  const int steps = std::max(1, static_cast<int>(std::ceil((whole.second - whole.first) / kTestStep_m)));
  const auto at = [&](int i) { return whole.first + (whole.second - whole.first) * i / steps; };
  int first = -1;
  for (int i = 0; i <= steps + 1; ++i) {
    const bool is_in = i <= steps && is_free(at(i));
    if (is_in && first < 0) first = i;
    if (is_in || first < 0) continue;
    if (at(i - 1) - at(first) >= kShortestBarrier_m) found.emplace_back(at(first), at(i - 1));
    first = -1;
  }
  return found;
}

}  // namespace

BarrierPlaces::BarrierPlaces(const map::FeatureView& features, const FieldInputs& inputs)
    : mapped_(lots::mapped_things(features, inputs.roads, inputs.junctions, {})), waters_(waters_of(features)) {
  std::vector<Box2> boxes;
  for (const map::AreaFeature& area : features.areas) {
    if (is_farmed(area.surface) || area.polygon.outer.empty()) continue;
    areas_.push_back(&area), boxes.push_back(box_of(area.polygon.outer));
  }
  if (!boxes.empty()) areas_grid_ = grid_of(boxes, kAreaBucket_m);
}

bool BarrierPlaces::is_free(Vec2 at, const map::AreaFeature& land) const {
  for (const lots::Capsules* things : {&mapped_.roads, &mapped_.paths, &mapped_.drives, &mapped_.walls,
                                       &mapped_.barriers, &mapped_.trees, &mapped_.junction_zones, &waters_})
    if (lots::clearance_m(*things, at, kClear_m) < kClear_m) return false;
  // gardens of unmapped towns have no hedges of fields
  if (land.surface == LandCoverClass::kUnknown && lots::clearance_m(mapped_.walls, at, kFromHouses_m) < kFromHouses_m)
    return false;
  return !lots::is_inside_any(mapped_.buildings, at) && !is_on_other_land(at, land);
}

bool BarrierPlaces::is_beside_lane(Vec2 at) const {
  // any area of another use is smaller than this land
  static const map::AreaFeature kOpen{.id = {}, .polygon = {}, .area_m2 = 1e15};
  for (const lots::Capsules* ways : {&mapped_.roads, &mapped_.paths, &mapped_.drives})
    if (lots::clearance_m(*ways, at, kOffLane_m) < kOffLane_m) return false;
  for (const lots::Capsules* things : {&mapped_.barriers, &mapped_.trees, &mapped_.junction_zones, &waters_})
    if (lots::clearance_m(*things, at, kClear_m) < kClear_m) return false;
  return lots::clearance_m(mapped_.walls, at, kFromHouses_m) >= kFromHouses_m && !is_on_other_land(at, kOpen);
}

bool BarrierPlaces::is_on_other_land(Vec2 at, const map::AreaFeature& land) const {
  if (areas_.empty()) return false;
  const auto is_on = [&](std::uint32_t i) {
    const map::AreaFeature& area = *areas_[i];
    const bool is_above =
        area.area_m2 < land.area_m2 || map::values_of(area.surface).priority > map::values_of(land.surface).priority;
    return is_above && contains(area.polygon, at);
  };
  return std::ranges::any_of(boxes_about(areas_grid_, at), is_on);
}

std::vector<map::Barrier> barriers_on(const FieldBoundary& line, FieldBorder border, ObjectId land,
                                      const IsFree& is_free, const RandomSequence& draw) {
  const double whole_m = distance(line.from, line.to);
  const Vec2 along = unit(line.to - line.from);
  // an opening near the middle of lines that lead from one side to the other
  const double gate_m = whole_m * (0.4 + 0.2 * draw.unit(2));
  std::vector<map::Barrier> barriers;
  for (const auto& [from_m, to_m] : {Stretch{0, gate_m - kGate_m / 2}, Stretch{gate_m + kGate_m / 2, whole_m}})
    for (const Stretch& free :
         free_stretches({from_m, to_m}, [&](double m) { return is_free(line.from + along * m); })) {
      map::Barrier barrier = barrier_of(border, draw);
      barrier.id = field_id(land, line.number + static_cast<std::uint32_t>(barriers.size()));
      for (const double m : {free.first, free.second})
        barrier.axis.push_back(snapped_to(map::kMapStep_m, line.from + along * m));
      barriers.push_back(std::move(barrier));
    }
  return barriers;
}

}  // namespace citykiln::fields
