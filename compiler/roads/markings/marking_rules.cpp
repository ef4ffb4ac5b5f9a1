// Source: Richtlinien für die Markierung von Straßen RMS-1 (1993): narrow lines 0.12 m and broad ones 0.25 m, 0.15 and
// 0.30 m on motorways; dashes to gaps 1:2 between lanes, 1:1 in broad lines. VwV-StVO zu § 41 gives the same widths.
// RMS dashes are 3, 4 and 6 m. The periods 3:6 and 6:12 do not divide kLayoutLength_m: towns use the 9 m gap of MUTCD
// 3A (10 ft, 30 ft), motorways the dashes of country roads. Edge lines on motorways and on busy roads without kerbs:
// MUTCD 3B and RMS-2.
#include "compiler/roads/markings/marking_rules.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace citykiln::roads {
namespace {

using map::LandCoverClass;

constexpr LineMeasures kMotorwayLines = {.narrow_m = 0.15,
                                         .broad_m = 0.30,
                                         .broken = {4, 12},
                                         .broad_broken = {6, 12},
                                         .has_lane_lines = true,
                                         .has_edge_lines = true};
constexpr LineMeasures kCountryLines = {.narrow_m = 0.12,
                                        .broad_m = 0.25,
                                        .broken = {4, 12},
                                        .broad_broken = {3, 6},
                                        .has_lane_lines = true,
                                        .has_edge_lines = false};
constexpr LineMeasures kTownLines = {.narrow_m = 0.12,
                                     .broad_m = 0.25,
                                     .broken = {3, 12},
                                     .broad_broken = {1.5, 3},
                                     .has_lane_lines = true,
                                     .has_edge_lines = false};

// The least width of a road with strips for walkers: half a metre on both sides, and a car.
constexpr double kWithWalkersStrip_m = 3.75;

// The strips beside the lines of narrow streets without kerbs (roadside strips of the Road Traffic Act of Japan).
bool has_walkers_strip(const MarkingLayout& layout) {
  return layout.practice == MarkingPractice::kJapanese && width_m(layout) >= kWithWalkersStrip_m &&
         (layout.surface == LandCoverClass::kTertiaryRoad || layout.surface == LandCoverClass::kResidentialRoad);
}

// Lane widths at which two bicycles or two cars pass each other, so that each direction keeps to its side.
constexpr double kCyclesPass_m = 2.0, kCarsPass_m = 4.5;

}  // namespace

// Yellow centre lines: MUTCD 3A.05, the manuals of Latin America that follow it, and GB 5768.3 of China.
MarkingPractice practice_of(map::CountryGroup country) {
  switch (country) {
    case map::CountryGroup::kNorthAmerica:
    case map::CountryGroup::kLatinAmerica:
    case map::CountryGroup::kChina:
      return MarkingPractice::kAmerican;
    case map::CountryGroup::kJapan:
      return MarkingPractice::kJapanese;
    default:
      return MarkingPractice::kVienna;
  }
}

LineMeasures measures_of(const MarkingLayout& layout) {
  if (layout.surface == LandCoverClass::kMotorwayRoad) return kMotorwayLines;
  const bool is_in_town = layout.has_kerb_left || layout.has_kerb_right;
  LineMeasures measures = is_in_town ? kTownLines : kCountryLines;
  measures.has_lane_lines = !is_quiet(layout);
  measures.has_edge_lines = layout.surface == LandCoverClass::kPrimaryRoad ||
                            layout.surface == LandCoverClass::kSecondaryRoad || has_walkers_strip(layout);
  return measures;
}

bool is_quiet(const MarkingLayout& layout) {
  constexpr std::array kBusy = {LandCoverClass::kMotorwayRoad, LandCoverClass::kPrimaryRoad,
                                LandCoverClass::kSecondaryRoad, LandCoverClass::kTertiaryRoad};
  return std::ranges::find(kBusy, layout.surface) == kBusy.end();
}

bool takes_paint(const MarkingLayout& layout) {
  using materials::Material;
  constexpr std::array kHard = {Material::kAsphalt, Material::kOldAsphalt, Material::kPaving, Material::kConcrete};
  return std::ranges::find(kHard, map::values_of(layout.surface).material) != kHard.end();
}

LaneSpan arriving_span(const MarkingLayout& layout, std::size_t index) {
  assert(index < layout.lanes.size());
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
