// Source: Richtlinien für die Markierung von Straßen RMS-1 (1993): narrow lines 0.12 m and broad ones 0.25 m, 0.15 and
// 0.30 m on motorways; dashes to gaps 1:2 between lanes, 1:1 in broad lines. VwV-StVO zu § 41 gives the same widths.
// RMS dashes are 3, 4 and 6 m. The periods 3:6 and 6:12 do not divide kLayoutLength_m: towns use the 9 m gap of MUTCD
// 3A (10 ft, 30 ft), motorways the dashes of country roads. Edge lines on motorways and on busy roads without kerbs:
// MUTCD 3B and RMS-2.
#include "compiler/roads/markings/marking_rules.h"

namespace citykiln::roads {
namespace {

using map::LandCoverClass;

constexpr LineMeasures kMotorwayLines = {0.15, 0.30, {4, 12}, {6, 12}, true, true};
constexpr LineMeasures kCountryLines = {0.12, 0.25, {4, 12}, {3, 6}, true, false};
constexpr LineMeasures kTownLines = {0.12, 0.25, {3, 12}, {1.5, 3}, true, false};

// Lane widths at which two bicycles or two cars pass each other, so that each direction keeps to its side.
constexpr double kCyclesPass_m = 2.0, kCarsPass_m = 4.5;

}  // namespace

LineMeasures measures_of(const MarkingLayout& layout) {
  if (layout.surface == LandCoverClass::kMotorwayRoad) return kMotorwayLines;
  const bool is_in_town = layout.has_kerb_left || layout.has_kerb_right;
  LineMeasures measures = is_in_town ? kTownLines : kCountryLines;
  measures.has_lane_lines = !is_quiet(layout);
  measures.has_edge_lines =
      layout.surface == LandCoverClass::kPrimaryRoad || layout.surface == LandCoverClass::kSecondaryRoad;
  return measures;
}

bool is_quiet(const MarkingLayout& layout) {
  switch (layout.surface) {
    case LandCoverClass::kMotorwayRoad:
    case LandCoverClass::kPrimaryRoad:
    case LandCoverClass::kSecondaryRoad:
    case LandCoverClass::kTertiaryRoad:
      return false;
    default:
      return true;
  }
}

bool takes_paint(const MarkingLayout& layout) {
  switch (map::values_of(layout.surface).material) {
    case materials::Material::kAsphalt:
    case materials::Material::kOldAsphalt:
    case materials::Material::kPaving:
    case materials::Material::kConcrete:
      return true;
    default:
      return false;
  }
}

LaneSpan arriving_span(const MarkingLayout& layout, std::size_t index) {
  const map::Lane& lane = layout.lanes[index];
  const double low_m = lane_sides_m(layout)[index], high_m = low_m + lane.width_m, middle_m = (low_m + high_m) / 2;
  if (lane.way == map::LaneDirection::kBackward) return {0, 0};
  const double pass_m = lane.kind == map::LaneKind::kCycle ? kCyclesPass_m : kCarsPass_m;
  const bool is_shared =
      lane.way == map::LaneDirection::kBoth && lane.kind != map::LaneKind::kTurn && lane.width_m >= pass_m;
  if (!is_shared) return {low_m, high_m};
  return layout.side == map::DrivingSide::kRight ? LaneSpan{middle_m, high_m} : LaneSpan{low_m, middle_m};
}

bool is_driven(const map::Lane& lane) {
  return lane.kind == map::LaneKind::kDriving || lane.kind == map::LaneKind::kBus || lane.kind == map::LaneKind::kTurn;
}

}  // namespace citykiln::roads
