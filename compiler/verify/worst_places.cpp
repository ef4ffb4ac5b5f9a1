#include "compiler/verify/worst_places.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

namespace citykiln::verify {
namespace {

// Diagnoses of the map's or the product's quality, in the order of the page.
constexpr Code kShown[] = {
    Code::kToleranceNotMet,
    Code::kCrossingWithoutOrder,
    Code::kStepAtCrossing,
    Code::kTooSteep,
    Code::kTunnelLowered,
    Code::kTunnelNotMeshed,
    Code::kBridgeWithoutGround,
    Code::kNoPlaceForPier,
    Code::kRiverOffTerrain,
    Code::kWaterwayRises,
    Code::kWaterwayOffLake,
    Code::kWaterwayOffNeighbours,
    Code::kLakeLevelMoved,
    Code::kShoreSpike,
    Code::kRiverAreaWithoutAxis,
    Code::kWaterwayReversed,
    Code::kHeightRaised,
    Code::kUnsupportedBuilding,
    Code::kBuildingOnRoad,
    Code::kRoadNarrowed,
    Code::kRoofFallback,
    Code::kRuleErrors,
    Code::kDuplicateBuilding,
    Code::kMinHeightNotBelowHeight,
    Code::kTreeOnRoad,
    Code::kTreeMoved,
    Code::kBrokenArea,
    Code::kDegenerateRing,
    Code::kNoLength,
    Code::kBadTagValue,
};

constexpr Code kOnRoofs[] = {Code::kHeightRaised, Code::kUnsupportedBuilding, Code::kRoofFallback,
                             Code::kRuleErrors,   Code::kDuplicateBuilding,   Code::kMinHeightNotBelowHeight};

// Keeps the largest place of each object, and of these the `most` largest.
void keep_worst_places(PlacesOfKind& kind, std::size_t most) {
  std::ranges::stable_sort(kind.worst, std::ranges::greater{}, &WorstPlace::size);
  std::set<std::vector<OsmId>> known;
  std::erase_if(kind.worst,
                [&](const WorstPlace& place) { return !place.ids.empty() && !known.insert(place.ids).second; });
  kind.count = kind.worst.size();
  if (kind.worst.size() > most) kind.worst.resize(most);
}

PlacesOfKind failures_of(const Check& check) {
  PlacesOfKind kind{"broken guarantee", "expected: " + check.claim, 0, {}};
  for (const Failure& failure : check.failures)
    kind.worst.push_back({failure.ids, failure.size, failure.text, failure.at, failure.file});
  return kind;
}

WorstPlace place_of(const ClearanceShortfall& s) {
  const std::string pair = fmt::format("{} over {}", to_string(s.upper), to_string(s.lower));
  return {{s.upper, s.lower}, s.missing_m, s.tags.empty() ? pair : fmt::format("{} ({})", pair, s.tags), s.at};
}

void add_shortfalls(const Clearances& clearances, std::vector<PlacesOfKind>& kinds) {
  PlacesOfKind& missing = kinds.emplace_back(PlacesOfKind{
      "missing clearance", "a line passes too closely over another line or over water (size: metres missing)", 0, {}});
  for (const ClearanceShortfall& s : clearances.shortfalls) missing.worst.push_back(place_of(s));
  PlacesOfKind& contradictory = kinds.emplace_back(PlacesOfKind{
      std::string(name_of(Code::kLayersContradict)), std::string(text_of(Code::kLayersContradict)), 0, {}});
  for (const ClearanceShortfall& s : clearances.contradictions) contradictory.worst.push_back(place_of(s));
}

// The cuts, or the fills, of one kind of line.
void add_earthworks(std::span<const Earthwork> earthworks, bool is_cut, std::vector<PlacesOfKind>& kinds) {
  std::map<std::string_view, PlacesOfKind> by_line;
  for (const Earthwork& e : earthworks) {
    if ((e.depth_m > 0) != is_cut) continue;
    PlacesOfKind& kind = by_line[e.line];
    kind.name = fmt::format("{} of a {}", is_cut ? "cut" : "fill", e.line);
    const double limit_m = earthwork_limit_m(e.line), depth_m = std::abs(e.depth_m);
    kind.text = fmt::format(
        "the {} lies {} the terrain (size: metres; more than {} are unusual, up to half of that has no picture)",
        e.line, is_cut ? "below" : "above", limit_m);
    kind.worst.push_back({{e.id}, depth_m, {}, e.at, {}, depth_m <= limit_m / 2});
  }
  for (auto& [line, kind] : by_line) kinds.push_back(std::move(kind));
}

// Ways that meet a building, and blank walls.
void add_walls(const CheckResults& results, std::vector<PlacesOfKind>& kinds) {
  PlacesOfKind& ways = kinds.emplace_back(PlacesOfKind{
      "way into a wall", "a way meets a building that has no opening for it (size: square metres of wall)", 0, {}});
  for (const WayIntoWall& w : results.ways_into_walls)
    ways.worst.push_back(
        {{w.way, w.building}, w.area_m2, fmt::format("{} into {}", to_string(w.way), to_string(w.building)), w.at});
  PlacesOfKind& blank = kinds.emplace_back(
      PlacesOfKind{"blank wall", "a foundation stands out of the ground (size: square metres over a storey)", 0, {}});
  for (const BlankWall& w : results.blank_walls) blank.worst.push_back({{w.building}, w.area_m2, {}, w.at});
}

WorstPlace place_of(const outputs::Finding& finding, const map::Plane& plane) {
  WorstPlace place;
  place.size = finding.diagnosis.size;
  if (finding.diagnosis.object.type != OsmType::kNone) place.ids = {finding.diagnosis.object};
  if (finding.at) place.at = plane.forward(*finding.at);
  if (finding.diagnosis.other.type != OsmType::kNone) place.ids.push_back(finding.diagnosis.other);
  place.text = finding.level ? fmt::format("level {}", *finding.level) : finding.tags;
  return place;
}

void add_diagnoses(std::span<const outputs::Finding> findings, const map::Plane& plane,
                   std::vector<PlacesOfKind>& kinds) {
  for (const Code code : kShown) {
    PlacesOfKind kind{std::string(name_of(code)), std::string(text_of(code)), 0, {}};
    kind.on_roofs = std::ranges::find(kOnRoofs, code) != std::end(kOnRoofs);
    for (const outputs::Finding& finding : findings)
      if (finding.diagnosis.code == code) kind.worst.push_back(place_of(finding, plane));
    kinds.push_back(std::move(kind));
  }
}

}  // namespace

std::vector<PlacesOfKind> worst_places(const CheckResults& results, std::span<const Earthwork> earthworks,
                                       std::span<const outputs::Finding> findings, const map::Plane& plane,
                                       std::size_t most) {
  std::vector<PlacesOfKind> kinds;
  for (const Check* check : all_of(results)) kinds.push_back(failures_of(*check));
  add_shortfalls(results.clearances, kinds);
  for (const bool is_cut : {true, false}) add_earthworks(earthworks, is_cut, kinds);
  add_walls(results, kinds);
  add_diagnoses(findings, plane, kinds);
  for (PlacesOfKind& kind : kinds) keep_worst_places(kind, most);
  std::erase_if(kinds, [](const PlacesOfKind& kind) { return kind.worst.empty(); });
  return kinds;
}

}  // namespace citykiln::verify
