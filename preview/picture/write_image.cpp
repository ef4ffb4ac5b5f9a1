#include <dlfcn.h>

#include <cstdio>
#include <filesystem>

#include "preview/image_module/picture_io.h"
#include "preview/picture/image.h"
#include "preview/picture/tone_map.h"

namespace citykiln::preview {
namespace {

using WritePicture = decltype(&citykiln_write_picture);

// Loads the module beside the program, or where the build put it.
Result<WritePicture> load_module() {
  const std::filesystem::path beside =
      std::filesystem::read_symlink("/proc/self/exe").parent_path() / "citykiln_image.so";
  for (const std::string& path : {beside.string(), std::string(CITYKILN_IMAGE_MODULE)})
    if (void* module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL))
      return reinterpret_cast<WritePicture>(dlsym(module, "citykiln_write_picture"));
  return Error{"citykiln_image.so", std::string("cannot be loaded: ") + dlerror()};
}

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

}  // namespace

Result<Done> write_image(const Image& image, const std::string& path) {
  const bool is_exr = ends_with(path, ".exr");
  if (!is_exr && !ends_with(path, ".png")) return Error{path, "expected a name that ends in .png or .exr"};
  const auto module = load_module();
  if (!module) return module.error();
  std::vector<std::uint8_t> bytes;
  if (!is_exr) {
    bytes.reserve(image.rgb.size());
    for (std::size_t i = 0; i + 2 < image.rgb.size(); i += 3)
      for (const std::uint8_t byte : tone_map(&image.rgb[i])) bytes.push_back(byte);
  }
  // a temporary name with the same extension, renamed at the end
  const std::string part = path.substr(0, path.size() - 4) + ".part" + path.substr(path.size() - 4);
  char error[512] = "";
  const void* pixels = is_exr ? static_cast<const void*>(image.rgb.data()) : bytes.data();
  if ((*module)(part.c_str(), image.width, image.height, pixels, is_exr ? 1 : 0, error, sizeof error) != 0) {
    std::remove(part.c_str());
    return Error{path, std::string("cannot be written: ") + error};
  }
  if (std::rename(part.c_str(), path.c_str()) != 0) {
    std::remove(part.c_str());
    return Error{path, "cannot be written: the finished picture could not be renamed"};
  }
  return Done{};
}

}  // namespace citykiln::preview
