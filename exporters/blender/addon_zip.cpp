#include "exporters/blender/addon_zip.h"

#include <algorithm>
#include <span>
#include <string_view>

#include "exporters/stored_zip.h"

namespace citykiln::exporters {
namespace {

struct AddonText {
  std::string_view name, text;
};

constexpr AddonText kFiles[] = {
#include "exporters/blender/shipped_addon_generated.h"
};

}  // namespace

Result<std::vector<std::byte>> blender_addon_zip() {
  std::vector<ZippedFile> files;
  for (const AddonText& file : kFiles) {
    const auto bytes = std::as_bytes(std::span(file.text));
    files.push_back({std::string(file.name), {bytes.begin(), bytes.end()}});
  }
  return stored_zip(files, 1);
}

}  // namespace citykiln::exporters
