// Reads rule files into a program: loads imports, resolves names, checks arguments.
#pragma once

#include <functional>
#include <string>

#include "compiler/contract/result.h"
#include "grammars/language/syntax.h"

namespace citykiln::grammars {

/// Returns the text of the rule file with the name given in `import`.
using Loader = std::function<Result<std::string>(const std::string& file)>;

/// Reads a rule file and all its imports.
///
/// A name of a file imported with a prefix becomes prefix.name. Names of a file imported without a prefix join those of
/// the importing file, which take precedence. A name without arguments that no rule defines is a terminal, as in CGA.
/// Errors: those of the loader and the parser; circular imports; more than 256 files; undefined values; a wrong number
/// of arguments or a wrong word; unknown operations. O(text length), except analyse_bodies().
Result<Program> read_rules(const std::string& file, const Loader& load);

/// Reads a program from one text without imports. Errors: those of read_rules(); an import.
Result<Program> read_rules_of(const std::string& text, const std::string& file = "rules");

}  // namespace citykiln::grammars
