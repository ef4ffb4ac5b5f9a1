// Lists sets of assumptions by name.
#pragma once

#include <string>
#include <vector>

#include "compiler/contract/findings/assumption.h"

namespace citykiln {

/// Returns the names of the assumptions in a set, in the order of their bits. Unknown bits are ignored.
std::vector<std::string> names_in(Assumptions set);

/// Returns the bits and names of all assumptions: "1 pavements, 2 parking".
std::string bits_text();

}  // namespace citykiln
