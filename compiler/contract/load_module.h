// Loads modules: shared libraries that are loaded only when needed, because the libraries that they link to take long
// to load.
#pragma once

#include <string>

#include "compiler/contract/result.h"

namespace citykiln {

/// The folders that are searched, relative to the running program's: its own, where a build has the modules; that of an
/// installation; and that of the build for programs in its folder tests/.
inline constexpr const char* kModuleFolders[] = {".", "../libexec/citykiln", ".."};

/// Returns the address of a function in a module: the first file of this name in kModuleFolders. The module stays
/// loaded. Errors: no such file, a file that cannot be loaded, no such function.
Result<void*> load_function(const std::string& module, const std::string& function);

}  // namespace citykiln
