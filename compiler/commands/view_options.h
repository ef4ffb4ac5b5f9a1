// What preview and bake are told about an eye, in the same words.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "compiler/contract/result.h"
#include "compiler/geometry/vec.h"
#include "compiler/scene/scene.h"

namespace citykiln::commands {

/// Of a picture.
struct PictureSize {
  int width = 1280, height = 720;
};

/// An option's take: three numbers, "X,Y,Z" in metres of the plane or "LON,LAT,HEIGHT" in degrees and metres.
std::function<Result<Done>(const std::string&)> store_point(std::optional<Vec3>& point);

/// "1280x720".
Result<Done> parse_size(const std::string& text, PictureSize& size);

/// Degrees between 0 and 180.
Result<Done> parse_fov(const std::string& text, std::optional<double>& fov_deg);

Result<Done> parse_positive(const std::string& text, double& number);

/// A point in the plane, whichever way it was given; nothing where it was not. Error: by longitude and latitude,
/// without a header that tells the plane.
Result<std::optional<Vec3>> point_of(const std::optional<Vec3>& in_plane, const std::optional<Vec3>& lonlat,
                                     const std::optional<scene::Header>& header);

}  // namespace citykiln::commands
