// The worst places of a run, by kind, for the page about a map's quality.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compiler/outputs/findings.h"
#include "compiler/verify/check_results.h"
#include "compiler/verify/heights/measure_earthworks.h"

namespace citykiln::verify {

/// A place with a violated guarantee, a shortfall, an earthwork or a diagnosis.
struct WorstPlace {
  std::vector<OsmId> ids;
  double size = 0;           ///< In the unit that the kind's text states.
  std::string text;          ///< Details; may be empty.
  std::optional<Vec2> at{};  ///< Plane metres.
  /// The file of the tile in whose mesh it is, relative to the run's folder; empty: it is in the recipes.
  std::string file{};
  bool is_usual = false;  ///< True if the size is at most half of the limit of its kind, so that no picture is needed.
};

/// All places of one kind.
struct PlacesOfKind {
  std::string name, text;         ///< "TooSteep" and its meaning.
  std::size_t count = 0;          ///< The number of all places, of which `worst` has the worst ones.
  std::vector<WorstPlace> worst;  ///< The largest first.
  bool on_roofs = false;          ///< True if the places are on roofs; else they are on the ground or on a road.
};

/// Returns all kinds that have places: violated guarantees, clearances, cuts and fills, ways
/// into walls and blank walls, then diagnoses. Diagnoses that
/// do not concern quality (objects outside the box or without a model) are left out. Each kind lists an object once.
/// O(n log n).
/// @param most  The largest number of places per kind. > 0.
std::vector<PlacesOfKind> worst_places(const CheckResults& results, std::span<const Earthwork> earthworks,
                                       std::span<const outputs::Finding> findings, const map::Plane& plane,
                                       std::size_t most);

}  // namespace citykiln::verify
