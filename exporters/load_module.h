// Modules: shared libraries that are loaded when they are needed, since what they link to takes long to load.
#pragma once

#include <string>

#include "compiler/contract/result.h"

namespace citykiln::exporters {

/// The address of a function in a module, which stays loaded. The module is looked for beside the program, then at
/// `built_path`, where the build put it. Errors: it is not there, or has no such function.
Result<void*> load_function(const std::string& module, const std::string& built_path, const std::string& function);

}  // namespace citykiln::exporters
