#include "compiler/contract/system/load_module.h"

#include <dlfcn.h>

#include <filesystem>

namespace citykiln {

Result<void*> load_function(const std::string& module, const std::string& function) {
  std::error_code none;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", none).parent_path();
  for (const char* folder : kModuleFolders) {
    const std::filesystem::path path = program / folder / module;
    if (!std::filesystem::exists(path, none)) continue;
    void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* address = library != nullptr ? dlsym(library, function.c_str()) : nullptr;
    if (address != nullptr) return address;
    const char* problem = dlerror();
    return Error{path.string(), std::string("cannot be loaded: ") + (problem != nullptr ? problem : "unknown reason")};
  }
  return Error{module, "cannot be loaded: it is neither beside the program nor in ../libexec/citykiln"};
}

}  // namespace citykiln
