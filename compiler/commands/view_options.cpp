#include "compiler/commands/view_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/contract/parse.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/plane.h"
#include "compiler/spec.h"

namespace citykiln::commands {

Take store_point(std::optional<Vec3>& point) {
  return [&point](const std::string& text) -> Result<Done> {
    const Result<std::vector<double>> n = parse_numbers(text, 3);
    if (!n) return n.error();
    point = Vec3{(*n)[0], (*n)[1], (*n)[2]};
    return Done{};
  };
}

Take store_size(PictureSize& size) {
  return [&size](const std::string& text) -> Result<Done> {
    constexpr int kMax_px = 32768;  // a limit on memory
    const auto sides = numbers_in<int>(text, 'x', 2);
    if (!sides || std::ranges::min(*sides) < 1 || std::ranges::max(*sides) > kMax_px)
      return Error{
          "", fmt::format("expected a size in pixels such as 1280x720, at most {} each, found \"{}\"", kMax_px, text)};
    size = {(*sides)[0], (*sides)[1]};
    return Done{};
  };
}

Result<std::optional<Vec3>> point_of(const std::optional<Vec3>& in_plane, const std::optional<Vec3>& lonlat,
                                     const std::optional<scene::Header>& header) {
  if (in_plane || !lonlat) return in_plane;
  if (!header)
    return Error{"--eye-lonlat", "needs the scene's origin: give the manifest, or the folder that contains it"};
  const Vec2 at = map::Plane(header->origin).forward({lonlat->x, lonlat->y});
  return std::optional<Vec3>(at_height(at, lonlat->z));
}

}  // namespace citykiln::commands
