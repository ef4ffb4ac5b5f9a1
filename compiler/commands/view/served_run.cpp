#include "compiler/commands/view/served_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "exporters/run_files.h"

namespace citykiln::commands {
namespace {

constexpr std::array<std::pair<std::string_view, const char*>, 9> kTypes = {
    {{".html", "text/html; charset=utf-8"},
     {".js", "text/javascript; charset=utf-8"},
     {".css", "text/css; charset=utf-8"},
     {".json", "application/json; charset=utf-8"},
     {".txt", "text/plain; charset=utf-8"},
     {".wasm", "application/wasm"},
     {".glb", "model/gltf-binary"},
     {".png", "image/png"},
     {".jpg", "image/jpeg"}}};

// True if a header Host names this machine: "127.0.0.1:8000" or "localhost:8000". Pages of others, whose names may be
// made to lead here, have other hosts.
bool is_own_host(std::string_view host, int port) {
  return host == fmt::format("127.0.0.1:{}", port) || host == fmt::format("localhost:{}", port);
}

}  // namespace

ServedRun::ServedRun(std::string folder, const exporters::FileList& files) {
  for (const exporters::ListedFile& file : files) files_.emplace(file.name, folder + "/" + file.name);
  files_.emplace(exporters::kFileListName, folder + "/" + exporters::kFileListName);
}

ServedRun::Answer ServedRun::answer(std::string_view host, std::string_view path, int port) const {
  if (!is_own_host(host, port) || path.find("..") != std::string_view::npos) return {.status = 403};
  if (!path.starts_with('/')) return {};
  const auto found = files_.find(path == "/" ? std::string_view(exporters::kPageIndexName) : path.substr(1));
  if (found == files_.end()) return {};
  return {200, found->second.c_str(), media_type_of(found->first)};
}

const char* media_type_of(std::string_view name) {
  const auto found = std::ranges::find_if(kTypes, [&](const auto& type) { return name.ends_with(type.first); });
  return found == kTypes.end() ? "application/octet-stream" : found->second;
}

}  // namespace citykiln::commands
