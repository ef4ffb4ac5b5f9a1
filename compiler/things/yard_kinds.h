// The kinds of things that are assumed in yards.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string_view>

#include "compiler/map/countries/country_group.h"

namespace citykiln::things {

/// Where a thing stands in a yard.
enum class YardSpot : std::uint8_t {
  kRear,         ///< Behind the front yard, on lawn, gravel or earth.
  kBesideHouse,  ///< At a wall of a building.
  kBehindDrive,  ///< At the inner end of a drive, behind it.
  kOverDrive,    ///< Over the inner end of a drive whose yard has no garage.
  kBorder,       ///< Along the border, its front to the middle of the yard.
};

/// The use of a ground that is no garden of a house.
enum class YardUse : std::uint8_t {
  kApartments,
  kCourt,  ///< Behind the houses of a closed block.
  kShop,
  kWorks,
  kSchool,
  kChurch,
  kStorage,    ///< A yard of industry without a building of its own.
  kGreen,      ///< Rough grass.
  kAllotment,  ///< One plot of allotments.
  kSite,       ///< A building site.
  kNone
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

/// How many of a kind a ground has at most, and the chance of each in percent.
struct YardNumber {
  int percent = 0;
  std::uint32_t most = 0;
};

/// No ground has more of one kind.
inline constexpr std::uint32_t kMostOfKind = 8;

/// Returns how many of a kind a ground of a use has; none without a row.
YardNumber yard_number(std::string_view name, YardUse use);

/// True if a kind is assumed in gardens of houses or on grounds of one of these uses. Fences are of schools and sites,
/// cranes of sites.
bool is_kind_of(std::string_view name, std::span<const YardUse> uses);

/// The panel of the fence around a building site, and the crane of one: rows of things.txt.
inline constexpr std::string_view kSiteFence = "site_fence", kSiteCrane = "crane";

/// The row of things.txt that gates of yards are.
inline constexpr std::string_view kYardGate = "yard_gate";

/// True if a kind of things is assumed in yards.
constexpr bool is_yard_kind(std::string_view name) {
  return name == kYardGate || name == kSiteFence || name == kSiteCrane ||
         std::ranges::any_of(kYardKinds, [&](const YardKind& kind) { return name == kind.name; });
}

}  // namespace citykiln::things
