// "Did you mean …?": the known name that is nearest to a mistyped one.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace citykiln {

/// Returns the known name with the fewest typing errors (letters inserted, left out, replaced, or swapped with their
/// neighbour), the first of several; empty where every name needs more than a third of its letters changed.
/// O(names · length²).
std::string_view nearest_name(std::string_view typed, std::span<const std::string> known);

/// Returns "; did you mean NAME?", or nothing where no known name is near.
std::string did_you_mean(std::string_view typed, std::span<const std::string> known);

}  // namespace citykiln
