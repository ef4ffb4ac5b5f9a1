// Marks the functions of a rule file whose value is the same for all shapes of a derivation, the tree of shapes that
// the rules make from one building. Such a value is computed once.
#pragma once

#include "grammars/language/syntax.h"

namespace citykiln::grammars {

/// Sets Function::is_constant for functions without parameters that use only constants, attributes that no rule sets,
/// pure built-in functions and other such functions. Names must be resolved. Method: a fixed point over all functions.
/// O(text length · longest chain of functions).
void mark_constants(Program& program);

}  // namespace citykiln::grammars
