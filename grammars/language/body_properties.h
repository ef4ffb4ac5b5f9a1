// Computes properties of bodies that do not depend on the shape to which they are applied, once for each program.
#pragma once

#include "grammars/language/syntax.h"

namespace citykiln::grammars {

/// Sets Body::divides and the members after it. Names must be resolved. Method: a fixed point over all rules, since
/// rules may be recursive. O(text length · longest chain of rules).
void analyse_bodies(Program& program);

/// Returns the name of the terminal (or NIL) if the body is nothing else, like `Wall.`; else null.
const std::string* terminal_of(const Body& body);

}  // namespace citykiln::grammars
