// Parsers of the viewer options that preview, bake and chart have in common.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "compiler/contract/result.h"
#include "compiler/geometry/vec.h"
#include "compiler/scene/scene.h"

namespace citykiln::commands {

/// The size of a picture in pixels.
struct PictureSize {
  int width = 1280, height = 720;
};

/// Stores three numbers: "X,Y,Z" in plane metres or "LON,LAT,HEIGHT" in degrees and metres.
std::function<Result<Done>(const std::string&)> store_point(std::optional<Vec3>& point);

/// Parses "1280x720".
Result<Done> parse_size(const std::string& text, PictureSize& size);

/// Parses degrees between 0 and 180, exclusive.
Result<Done> parse_fov(const std::string& text, std::optional<double>& fov_deg);

Result<Done> parse_positive(const std::string& text, double& number);

/// The point in plane metres, given in the plane or by longitude and latitude; empty if not given. Error: longitude and
/// latitude without a header, which defines the plane.
Result<std::optional<Vec3>> point_of(const std::optional<Vec3>& in_plane, const std::optional<Vec3>& lonlat,
                                     const std::optional<scene::Header>& header);

}  // namespace citykiln::commands
