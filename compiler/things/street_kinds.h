// The kinds of street furniture that are assumed on pavements.
#pragma once

#include <algorithm>
#include <string_view>

#include "compiler/map/things/thing_table.h"

namespace citykiln::things {

/// A row of street_kinds.inc. Name, direction and size are those of the row of the table of things (things.txt),
/// without tags.
struct StreetKind {
  std::string_view name;
  map::Facing facing;
  double width_m, depth_m, height_m;
  double beside_shops_per_km, beside_houses_per_km;  ///< Pieces drawn on a kilometre of pavement.
};

inline constexpr StreetKind kStreetKinds[] = {
#define STREET_KIND(name, facing, ...) {name, map::Facing::facing, __VA_ARGS__},
#include "compiler/things/street_kinds.inc"
#undef STREET_KIND
};

/// True if a kind of things is in street_kinds.inc.
constexpr bool is_street_kind(std::string_view name) {
  return std::ranges::find(kStreetKinds, name, &StreetKind::name) != std::end(kStreetKinds);
}

}  // namespace citykiln::things
