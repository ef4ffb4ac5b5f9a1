// Adds the page and, where there is none, a tileset to a finished run.
#pragma once

#include <string>

#include "compiler/commands/console.h"
#include "compiler/contract/result.h"
#include "compiler/spec.h"

namespace citykiln::commands {

/// Settings of the tileset and the page of a run.
struct PageRequest {
  std::string folder;  ///< The folder of the run.
  Outputs outputs;     ///< How a tileset is baked, but for its levels, which are the run's.
  int threads = 0;
};

/// Writes what the page needs into the folder of a run, unless it has it: the tileset, of the run's levels, and the
/// page. All other files stay as they are; report.json and files.json list the new ones. Errors: a folder without a
/// finished run, or without a manifest, from which tiles are baked.
Result<Done> complete_page(const PageRequest& request, const Console& console);

}  // namespace citykiln::commands
