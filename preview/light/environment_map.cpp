#include "preview/light/environment_map.h"

#include <cmath>

#include "preview/image_module/picture_io.h"
#include "preview/picture/load_module.h"

namespace citykiln::preview {
namespace {

// Gives the image module memory for a picture within the limits.
float* allocate(void* owner, int width, int height) {
  EnvironmentMap& map = *static_cast<EnvironmentMap*>(owner);
  map.width = width, map.height = height;
  if (width < 1 || height < 1 || width > kMostEnvironmentWidth || height > kMostEnvironmentHeight) return nullptr;
  if (width != 2 * height) return nullptr;
  map.rgb.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
  return map.rgb.data();
}

// Why a size was refused; "" if it was not.
std::string problem_of(const EnvironmentMap& map) {
  if (map.width == 0 || !map.rgb.empty()) return "";
  const std::string size = std::to_string(map.width) + " x " + std::to_string(map.height) + " pixels";
  if (map.width > kMostEnvironmentWidth || map.height > kMostEnvironmentHeight)
    return "has " + size + "; at most " + std::to_string(kMostEnvironmentWidth) + " x " +
           std::to_string(kMostEnvironmentHeight) + " can be read";
  return "has " + size + "; expected a panorama that is twice as wide as high";
}

std::size_t mend(std::vector<float>& rgb) {
  std::size_t mended = 0;
  for (std::size_t i = 0; i < rgb.size(); i += 3) {
    bool is_mended = false;
    for (std::size_t c = i; c < i + 3; ++c)
      if (!std::isfinite(rgb[c]) || rgb[c] < 0) rgb[c] = 0, is_mended = true;
    mended += is_mended ? 1 : 0;
  }
  return mended;
}

}  // namespace

Result<ReadEnvironment> read_environment(const std::string& path) {
  if (!path.ends_with(".exr") && !path.ends_with(".hdr"))
    return Error{path, "expected an environment map, a name that ends in .exr or .hdr"};
  const auto function = load_function("citykiln_image.so", CITYKILN_IMAGE_MODULE, "citykiln_read_picture");
  if (!function) return function.error();
  ReadEnvironment read;
  char error[512] = "";
  const auto read_picture = reinterpret_cast<decltype(&citykiln_read_picture)>(*function);
  if (read_picture(path.c_str(), allocate, &read.map, error, sizeof error) != 0) {
    const std::string problem = problem_of(read.map);
    return Error{path, problem.empty() ? std::string("cannot be read: ") + error : problem};
  }
  read.mended = mend(read.map.rgb);
  return read;
}

}  // namespace citykiln::preview
