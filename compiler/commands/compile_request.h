// The command line of `compile` and `plan`: a file of settings, and settings that override it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "compiler/commands/verb.h"
#include "compiler/spec.h"

namespace citykiln::commands {

struct CompileRequest {
  std::string spec_path;
  std::vector<std::pair<const Setting*, std::string>> given;  ///< In the order of the table.
};

/// The options of all settings, and --spec. The request must outlive them.
std::vector<Option> options_of(CompileRequest& request);

/// Reads the file of settings and applies those given. Errors: a file that cannot be read; a wrong value.
Result<CompileSpec> spec_of(const CompileRequest& request);

}  // namespace citykiln::commands
