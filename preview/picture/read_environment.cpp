#include "preview/picture/read_environment.h"

#include <cmath>
#include <utility>

#include "compiler/contract/system/load_module.h"
#include "preview/image_module/picture_io.h"

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

// Moves columns, around both sides, so that those of a picture with the bearing `turn_deg` in its middle are where
// EnvironmentMap has them, with east in its middle.
std::vector<float> turned_rows(const EnvironmentMap& map, double turn_deg) {
  const double shift = (90 - turn_deg) / 360 * map.width, whole = std::floor(shift);
  const auto share = static_cast<float>(shift - whole);
  const auto column = [&](int x) {
    const auto moved = static_cast<int>(std::fmod(x + whole, map.width));
    return static_cast<std::size_t>(moved < 0 ? moved + map.width : moved);
  };
  std::vector<float> rgb(map.rgb.size());
  const auto width = static_cast<std::size_t>(map.width);
  for (std::size_t i = 0; i < rgb.size(); ++i) {
    const std::size_t row = i / 3 / width * width, c = i % 3;
    const int x = static_cast<int>(i / 3 - row);
    const float near = map.rgb[(row + column(x)) * 3 + c], next = map.rgb[(row + column(x + 1)) * 3 + c];
    rgb[i] = share > 0 ? near * (1 - share) + next * share : near;
  }
  return rgb;
}

}  // namespace

Result<ReadEnvironment> read_environment(const std::string& path, double turn_deg) {
  if (!path.ends_with(".exr") && !path.ends_with(".hdr"))
    return Error{path, "expected an environment map, a name that ends in .exr or .hdr"};
  const auto function = load_function("citykiln_image.so", "citykiln_read_picture");
  if (!function) return function.error();
  ReadEnvironment read;
  char error[512] = "";
  const auto read_picture = reinterpret_cast<decltype(&citykiln_read_picture)>(*function);
  if (read_picture(path.c_str(), allocate, &read.map, error, sizeof error) != 0) {
    const std::string problem = problem_of(read.map);
    return Error{path, problem.empty() ? std::string("cannot be read: ") + error : problem};
  }
  read.mended = mend(read.map.rgb);
  read.map.rgb = turned_rows(read.map, turn_deg);
  return read;
}

}  // namespace citykiln::preview
