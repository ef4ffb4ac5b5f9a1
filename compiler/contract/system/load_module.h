// Loads modules: shared libraries that are loaded only when needed, because the libraries that they link to take long
// to load.
#pragma once

#include <string>

#include "compiler/contract/result.h"

namespace citykiln {

/// The folders that are searched, relative to the folder of the running program: that folder, where a build has the
/// modules; the folder of modules of an installation; and the parent folder, for programs in tests/ of a build.
inline constexpr const char* kModuleFolders[] = {".", "../libexec/citykiln", ".."};

/// Returns the address of a function in a module, which is the first file of this name in kModuleFolders. The module
/// stays loaded. Errors: no such file, a file that cannot be loaded, no such function.
Result<void*> load_function(const std::string& module, const std::string& function);

}  // namespace citykiln
