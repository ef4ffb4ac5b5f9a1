// Functions that are worth the same for every shape of a building: those of attributes alone.
#pragma once

#include "grammars/language/syntax.h"

namespace citykiln::grammars {

/// Sets Function::is_constant where a function without parameters asks for nothing but constants, attributes that no
/// rule changes, mathematics, and other such functions: neither for the shape nor for dice. Names have to be resolved.
/// O(what is written).
void mark_constants(Program& program);

}  // namespace citykiln::grammars
