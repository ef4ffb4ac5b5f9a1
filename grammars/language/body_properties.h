// What bodies may do, whatever they are applied to: found once a program, so that derivations need not look.
#pragma once

#include "grammars/language/syntax.h"

namespace citykiln::grammars {

/// Sets the marks of bodies: Body::divides and what follows it. Names have to be resolved. O(what is written), for each
/// rule that others come to by way of many.
void analyse_bodies(Program& program);

/// `Wall.`: of a body that is nothing but the name of a terminal (or NIL), that name; else null.
const std::string* terminal_of(const Body& body);

}  // namespace citykiln::grammars
