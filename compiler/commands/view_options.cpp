#include "compiler/commands/view_options.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "compiler/geometry/snap.h"
#include "compiler/map/plane.h"
#include "compiler/spec.h"

namespace citykiln::commands {

std::function<Result<Done>(const std::string&)> store_point(std::optional<Vec3>& point) {
  return [&point](const std::string& text) -> Result<Done> {
    const Result<std::vector<double>> n = parse_numbers(text, 3);
    if (!n) return n.error();
    point = Vec3{(*n)[0], (*n)[1], (*n)[2]};
    return Done{};
  };
}

Result<Done> parse_size(const std::string& text, PictureSize& size) {
  const std::size_t cross = text.find('x');
  const Result<std::int64_t> width = parse_whole(text.substr(0, cross), 1);
  const Result<std::int64_t> height = parse_whole(cross == std::string::npos ? "" : text.substr(cross + 1), 1);
  // a limit on memory
  if (!width || !height || *width > 32768 || *height > 32768) {
    return Error{"", fmt::format("expected a size in pixels such as 1280x720, at most 32768 each, found \"{}\"", text)};
  }
  size = {static_cast<int>(*width), static_cast<int>(*height)};
  return Done{};
}

Result<Done> parse_fov(const std::string& text, std::optional<double>& fov_deg) {
  const Result<double> given = parse_number(text);
  if (!given || *given <= 0 || *given >= 180)
    return Error{"", fmt::format("expected degrees between 0 and 180, such as 45, found \"{}\"", text)};
  fov_deg = *given;
  return Done{};
}

Result<Done> parse_positive(const std::string& text, double& number) {
  const Result<double> given = parse_number(text);
  if (!given || *given <= 0) return Error{"", fmt::format("expected a number above 0, found \"{}\"", text)};
  number = *given;
  return Done{};
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
