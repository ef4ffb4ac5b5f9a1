// The kinds of things that are assumed in yards.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "compiler/map/countries/country_group.h"

namespace citykiln::things {

/// Where a thing stands in a yard.
enum class YardSpot : std::uint8_t {
  kRear,         ///< Behind the front yard, on lawn, gravel or earth.
  kBesideHouse,  ///< At a wall of a building.
  kBehindDrive,  ///< At the inner end of a drive, behind it.
  kOverDrive,    ///< Over the inner end of a drive whose yard has no garage.
};

/// A row of yard_kinds.inc.
struct YardKind {
  const char* name;
  double width_m, depth_m, height_m;
  YardSpot spot;
};

inline constexpr YardKind kYardKinds[] = {
#define YARD_KIND(name, width_m, depth_m, height_m, spot) {name, width_m, depth_m, height_m, YardSpot::spot},
#include "compiler/things/yard_kinds.inc"
#undef YARD_KIND
};

/// Shares of yards in percent.
struct YardShare {
  int detached_percent = 0, row_percent = 0;
};

/// Returns the shares of yards that have a kind, in a country.
YardShare yard_share(std::string_view name, map::CountryGroup country);

/// The row of things.txt that gates of yards are.
inline constexpr std::string_view kYardGate = "yard_gate";

/// True if a kind of things is assumed in yards.
constexpr bool is_yard_kind(std::string_view name) {
  return name == kYardGate || std::ranges::any_of(kYardKinds, [&](const YardKind& kind) { return name == kind.name; });
}

}  // namespace citykiln::things
