// The options that `view` and `serve` share.
#pragma once

#include <vector>

#include "compiler/commands/serve/site.h"
#include "compiler/commands/verb.h"

namespace citykiln::commands {

/// The values of the options. Settings of tiles have the meaning that they have for compile.
struct SiteChoices {
  std::string path;  ///< A manifest or the folder of a run.
  CompileSpec spec;
  std::uint64_t cache_bytes = 512'000'000;
};

/// Returns the options, which store their values in the choices. These must outlive them.
std::vector<Option> site_options(SiteChoices& choices);

/// Returns the request for a site. Errors: nothing is at the path; a map, which has to be compiled first; settings that
/// contradict each other.
Result<SiteRequest> site_request(const SiteChoices& choices, bool has_page);

}  // namespace citykiln::commands
