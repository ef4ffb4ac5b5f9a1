// Finds the known name that is nearest to a mistyped one, for "did you mean …?".
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace citykiln {

/// Returns the known name with the fewest typing errors (letters inserted, left out, replaced, or swapped with their
/// neighbour), and the first of several such names. Empty if every name differs in more than a third of its letters.
/// O(names · length²).
std::string_view nearest_name(std::string_view typed, std::span<const std::string> known);

/// Returns "; did you mean NAME?", or "" if nearest_name() finds none.
std::string did_you_mean(std::string_view typed, std::span<const std::string> known);

}  // namespace citykiln
