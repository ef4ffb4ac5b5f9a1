// Properties that many roads of a chunk share, and which the manifest therefore holds once.
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

/// The kinds of roads, each once, the most frequent first, and the index of each road's kind. O(n log n).
struct RoadKinds {
  std::vector<RoadKind> kinds;
  std::vector<std::uint32_t> of_road;
};
RoadKinds kinds_of(std::span<const roads::Road> roads);

/// Whether a road can have this cross-section: lanes wider than 0, at least one of them between the kerbs and none of
/// those raised, and the axis between the kerbs.
bool is_sound(const map::CrossSection& section);

}  // namespace citykiln::exporters
