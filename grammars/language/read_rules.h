// From rule files to a program: imports loaded, every name resolved, every call's arguments counted.
#pragma once

#include <functional>
#include <string>

#include "compiler/contract/result.h"
#include "grammars/language/syntax.h"

namespace citykiln::grammars {

/// The text of a rule file, by the name that import gives. This room reads no files itself.
using Loader = std::function<Result<std::string>(const std::string& file)>;

/// Reads a rule file and all it imports.
///
/// Names of a file imported with a prefix are prefix.name; without one they join the importer's own, which win.
/// Errors: the loader's, the parser's; files that import each other; names of values that nothing defines; arguments
/// of the wrong number or kind of word; operations that do not exist. A name without arguments that no rule defines is
/// no error but a terminal, as in CGA. Cost: the text's length.
Result<Program> read_rules(const std::string& file, const Loader& load);

/// A program of one text that imports nothing.
Result<Program> read_rules_of(const std::string& text, const std::string& file = "rules");

}  // namespace citykiln::grammars
