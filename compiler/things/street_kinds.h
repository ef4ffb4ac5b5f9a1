// The kinds of street furniture that are assumed on pavements.
#pragma once

#include <algorithm>
#include <string_view>

namespace citykiln::things {

/// A row of street_kinds.inc.
struct StreetKind {
  std::string_view name;
  double width_m, depth_m, height_m;
  double beside_shops_per_km, beside_houses_per_km;
};

inline constexpr StreetKind kStreetKinds[] = {
#define STREET_KIND(...) {__VA_ARGS__},
#include "compiler/things/street_kinds.inc"
#undef STREET_KIND
};

/// True if a kind of things is in street_kinds.inc.
constexpr bool is_street_kind(std::string_view name) {
  return std::ranges::find(kStreetKinds, name, &StreetKind::name) != std::end(kStreetKinds);
}

}  // namespace citykiln::things
