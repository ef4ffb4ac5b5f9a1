// Names of a program's expressions and bodies resolved to what they stand for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "grammars/language/syntax.h"

namespace citykiln::grammars {

/// Resolves all names in `program`, whose tables are complete. A name is looked up with the prefix of the definition it
/// stands in. The first error, if there is one.
std::optional<Error> resolve(Program& program);

/// "window." of "window.Frame"; "" of "Frame".
std::string prefix_of(const std::string& name);

}  // namespace citykiln::grammars
