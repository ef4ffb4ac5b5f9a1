// Resolves the names of a program: finds the attribute, function, rule, parameter or word that each name refers to.
#pragma once

#include <optional>
#include <string>

#include "compiler/contract/result.h"
#include "grammars/language/syntax.h"

namespace citykiln::grammars {

/// Resolves all names in expressions and bodies of `program`, whose tables are complete, and numbers its bodies. Looks
/// a name up with the prefix of the definition that contains it. Returns the first error, if there is one.
std::optional<Error> resolve(Program& program);

}  // namespace citykiln::grammars
