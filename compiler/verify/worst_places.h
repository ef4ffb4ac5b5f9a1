// The worst places of a run, by kind: what the report of a map's quality shows first.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compiler/verify/check_results.h"
#include "compiler/verify/findings.h"
#include "compiler/verify/measure_earthworks.h"

namespace citykiln::verify {

/// A place where something is not as it should be.
struct WorstPlace {
  std::vector<OsmId> ids;
  double size = 0;           ///< In the unit that the kind's text states.
  std::string text;          ///< More about it; may be empty.
  std::optional<Vec2> at{};  ///< Plane metres.
  std::string file{};        ///< Of a tile in whose mesh it is, relative to the run's folder; empty: in the recipes.
  bool is_usual = false;     ///< Less than half of what is unusual for its kind: no picture of it is needed.
};

/// All places of one kind.
struct PlacesOfKind {
  std::string name, text;         ///< "TooSteep" and what it means.
  std::size_t count = 0;          ///< Of all, also those that are not among `worst`.
  std::vector<WorstPlace> worst;  ///< The largest first.
  bool on_roofs = false;          ///< The places are on the highest surfaces; else on the ground, or on a road.
};

/// Returns every kind that has places: guarantees that do not hold, clearances, cuts and fills, then diagnoses, without
/// those that say nothing about quality (what lies outside of the box, or has no model). An object is listed once for
/// each kind. O(n log n).
/// @param most  Places of each kind. > 0.
std::vector<PlacesOfKind> worst_places(const CheckResults& results, std::span<const Earthwork> earthworks,
                                       std::span<const Finding> findings, const map::Plane& plane, std::size_t most);

}  // namespace citykiln::verify
