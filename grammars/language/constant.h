// Finds functions that have one value for all shapes of a derivation.
#pragma once

#include "grammars/language/syntax.h"

namespace citykiln::grammars {

/// Sets Function::is_constant for functions without parameters that use only constants, attributes that no rule sets,
/// pure built-in functions and other such functions. Names must be resolved. Method: a fixed point over all functions.
/// O(text length · longest chain of functions).
void mark_constants(Program& program);

}  // namespace citykiln::grammars
