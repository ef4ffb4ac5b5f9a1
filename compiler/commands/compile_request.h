// The command line of `compile` and `plan`: a file of settings, and settings that override it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "compiler/commands/verb.h"
#include "compiler/settings.h"

namespace citykiln::commands {

/// The settings given on the command line.
struct CompileRequest {
  std::string spec_path;
  std::vector<std::pair<const Setting*, std::string>> given;  ///< In the order of the table of settings.
};

/// Returns the options of all settings, and --spec. They store their values in the request, which must outlive them.
std::vector<Option> options_of(CompileRequest& request);

/// Reads the file of settings and applies the given ones. Errors: a file that cannot be read; a wrong value.
Result<CompileSpec> spec_of(const CompileRequest& request);

}  // namespace citykiln::commands
