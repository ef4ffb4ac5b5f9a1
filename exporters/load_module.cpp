#include "exporters/load_module.h"

#include <dlfcn.h>

#include <filesystem>

namespace citykiln::exporters {

Result<void*> load_function(const std::string& module, const std::string& built_path, const std::string& function) {
  std::error_code none;
  const std::filesystem::path beside = std::filesystem::read_symlink("/proc/self/exe", none).parent_path() / module;
  for (const std::string& path : {beside.string(), built_path}) {
    void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) continue;
    if (void* address = dlsym(library, function.c_str())) return address;
    break;
  }
  const char* problem = dlerror();
  return Error{module, std::string("cannot be loaded: ") + (problem != nullptr ? problem : "unknown reason")};
}

}  // namespace citykiln::exporters
