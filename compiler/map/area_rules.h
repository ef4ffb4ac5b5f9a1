// The table of area_rules.inc: the land cover class of an area by its tags.
#pragma once

#include <span>
#include <string_view>

#include "compiler/map/land_cover_class.h"

namespace citykiln::map {

/// A row: areas with this value of this key have the class. "*" stands for any value.
struct AreaRule {
  std::string_view key, value;
  LandCoverClass surface;
};

/// Returns the rows. The first one that matches an area gives its class.
std::span<const AreaRule> area_rules();

}  // namespace citykiln::map
