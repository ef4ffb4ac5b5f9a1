#include "compiler/commands/view/view_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/contract/texts/parse.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/plane/plane.h"
#include "compiler/parse_values.h"

namespace citykiln::commands {

StoreValue store_point(std::optional<GivenPoint>& point) {
  return [&point](const std::string& text) -> Result<Done> {
    std::string numbers = text;
    const std::size_t height = numbers.rfind(',') + 1;
    const bool is_above_ground = numbers.substr(height).starts_with('+');
    if (is_above_ground) numbers.erase(height, 1);
    const Result<std::vector<double>> n = parse_numbers(numbers, 3);
    if (!n) return n.error();
    point = GivenPoint{{(*n)[0], (*n)[1], (*n)[2]}, is_above_ground};
    return Done{};
  };
}

StoreValue store_point(std::optional<Vec3>& point) {
  return [&point](const std::string& text) -> Result<Done> {
    const Result<std::vector<double>> n = parse_numbers(text, 3);
    if (!n) return n.error();
    point = Vec3{(*n)[0], (*n)[1], (*n)[2]};
    return Done{};
  };
}

StoreValue store_size(PictureSize& size) {
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

Result<std::optional<Vec3>> point_of(const std::optional<GivenPoint>& in_plane, const std::optional<GivenPoint>& lonlat,
                                     const std::optional<scene::Header>& header, const GroundHeight& ground_m) {
  if (!in_plane && !lonlat) return std::optional<Vec3>();
  if (!in_plane && !header)
    return Error{"--eye-lonlat", "needs the scene's origin: give the manifest, or the folder that contains it"};
  const GivenPoint& given = in_plane ? *in_plane : *lonlat;
  const Vec2 at = in_plane ? in_plan(given.at) : map::Plane(header->origin).forward({given.at.x, given.at.y});
  if (!given.is_above_ground) return std::optional<Vec3>(at_height(at, given.at.z));
  const std::optional<double> ground = ground_m(at);
  if (!ground)
    return Error{fmt::format("+{}", given.at.z), "there is no ground at this place; give a height without +"};
  return std::optional<Vec3>(at_height(at, *ground + given.at.z));
}

void note_if_below_ground(Vec3 eye, const GroundHeight& ground_m, const Console& console) {
  const std::optional<double> ground = ground_m(in_plan(eye));
  if (ground && eye.z < *ground)
    console.print_line(
        fmt::format("note: the eye is {:.1f} m below the ground, which is at {:.1f} m there; +2 as the "
                    "third number means 2 m above the ground",
                    *ground - eye.z, *ground));
}

}  // namespace citykiln::commands
