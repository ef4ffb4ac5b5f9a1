// Modules: shared libraries that are loaded when they are needed, since what they link to takes long to load.
#pragma once

#include <string>

#include "compiler/contract/result.h"

namespace citykiln {

/// The folders that are searched, relative to that of the running program: its own, where the build leaves modules;
/// where an installation has them; the build's, for programs of its folder tests/.
inline constexpr const char* kModuleFolders[] = {".", "../libexec/citykiln", ".."};

/// The address of a function in a module, which stays loaded. The module is the first of its name in kModuleFolders.
/// Errors: it is in none of them, or has no such function.
Result<void*> load_function(const std::string& module, const std::string& function);

}  // namespace citykiln
