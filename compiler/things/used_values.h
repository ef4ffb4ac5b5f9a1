// Finds which attributes and random numbers the rules of a thing read.
#pragma once

#include <set>
#include <string>

#include "grammars/language/syntax.h"

namespace citykiln::things {

/// The values that rules read.
struct UsedValues {
  std::set<std::string, std::less<>> attributes;
  bool draws = false;  ///< True if a random number is drawn.
};

/// Returns the values that may be read from a rule on: by it, and by all rules, functions and attributes that it leads
/// to. O(program).
UsedValues used_values(const grammars::Program& program, const std::string& start);

}  // namespace citykiln::things
