// Properties that many roads of a chunk share. A chunk holds the recipes of one tile; the manifest holds each
// combination (road kind) once per chunk.
#pragma once

#include <compare>
#include <span>
#include <vector>

#include "compiler/roads/recipe.h"

namespace citykiln::exporters {

/// A combination of such properties.
struct RoadKind {
  map::LandCoverClass surface{};
  map::CrossSection section;
  map::DrivingSide side{};
  bool is_lit = false, is_link = false, is_roundabout = false;
  map::CountryGroup country{};
  Assumptions assumed = kNoAssumptions;
  std::uint8_t assumed_sides = 0, kerb_parking = 0;
  bool operator==(const RoadKind&) const = default;
};

/// Returns the kind of a road.
RoadKind kind_of(const roads::Road& road);
/// Sets the properties of a road to the values of a kind.
void set_kind(const RoadKind& kind, roads::Road& road);

/// The distinct kinds of roads, the most frequent first, and the index of each road's kind.
struct RoadKinds {
  std::vector<RoadKind> kinds;
  std::vector<std::uint32_t> of_road;
};
/// Returns the kinds of roads. O(n log n).
RoadKinds kinds_of(std::span<const roads::Road> roads);

/// True if a road can have this cross-section: all lanes are wider than 0, at least one lies between the kerbs, no lane
/// there is raised, and the axis lies between the kerbs.
bool is_sound(const map::CrossSection& section);

}  // namespace citykiln::exporters
