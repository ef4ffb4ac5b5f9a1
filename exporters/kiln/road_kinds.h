// What many roads of a chunk have in common, so that it is written once.
#pragma once

#include <compare>
#include <span>
#include <vector>

#include "compiler/roads/recipe.h"

namespace citykiln::exporters {

struct RoadKind {
  map::LandCoverClass surface{};
  map::CrossSection section;
  map::DrivingSide side{};
  bool is_lit = false, is_link = false, is_roundabout = false;
  bool operator==(const RoadKind&) const = default;
};

RoadKind kind_of(const roads::Road& road);
void set_kind(const RoadKind& kind, roads::Road& road);

/// All kinds of the roads, each once, the commonest first, and which of them each road is. O(n log n).
struct RoadKinds {
  std::vector<RoadKind> kinds;
  std::vector<std::uint32_t> of_road;
};
RoadKinds kinds_of(std::span<const roads::Road> roads);

/// A cross-section that a road can have: lanes of a width, at least one between the kerbs, none of them raised, and the
/// axis among them.
bool is_sound(const map::CrossSection& section);

}  // namespace citykiln::exporters
