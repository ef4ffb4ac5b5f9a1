// The table of area_rules.inc: the land cover class of an area by its tags.
#pragma once

#include <span>
#include <string_view>

#include "compiler/map/land_cover_class.h"
#include "compiler/map/tags/tag_values.h"

namespace citykiln::map {

/// A row: areas with this value of this key have the class. "*" stands for any value.
struct AreaRule {
  std::string_view key, value;
  LandCoverClass surface;
};

/// Returns the rows. The first one that matches an area gives its class.
std::span<const AreaRule> area_rules();

/// Returns the first row that the tags of an area match, or null.
/// @param tag  Returns the value of a key, "" if it is not tagged.
template <typename Tag>
const AreaRule* area_rule_of(Tag tag) {
  for (const AreaRule& row : area_rules()) {
    const std::string_view value = tag(row.key);
    if (row.value == "*" ? says_yes(value) : value == row.value) return &row;
  }
  return nullptr;
}

}  // namespace citykiln::map
