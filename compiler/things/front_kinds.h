// The kinds of things that are assumed before shop fronts, and in streets.
#pragma once

#include <algorithm>
#include <string_view>

#include "compiler/map/front_tags.h"

namespace citykiln::things {

/// A row of front_kinds.inc. Name and size are those of the row of the table of things (things.txt), without tags.
struct FrontThingKind {
  map::FrontKind front;
  std::string_view name;
  double width_m, depth_m, height_m;
  double percent;  ///< The share of fronts of this kind that have it.
};

inline constexpr FrontThingKind kFrontThings[] = {
#define FRONT_THING(front, ...) {map::FrontKind::front, __VA_ARGS__},
#include "compiler/things/front_kinds.inc"
#undef FRONT_THING
};

/// The rows of things.txt that stand at the mouths of streets for walkers, along these, and on islands of crossings.
inline constexpr std::string_view kBollard = "bollard", kPlanter = "planter", kRefuge = "refuge";

/// True for kinds in kFrontThings, bollards and refuges; false for planters, which are in street_kinds.inc.
constexpr bool is_front_kind(std::string_view name) {
  return name == kBollard || name == kRefuge ||
         std::ranges::find(kFrontThings, name, &FrontThingKind::name) != std::end(kFrontThings);
}

}  // namespace citykiln::things
