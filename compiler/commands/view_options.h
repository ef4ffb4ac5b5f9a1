// Parsers of the viewer options that preview, bake and chart have in common.
#pragma once

#include <optional>

#include "compiler/commands/verb.h"
#include "compiler/contract/result.h"
#include "compiler/geometry/vec.h"
#include "compiler/scene/scene.h"

namespace citykiln::commands {

/// The size of a picture in pixels.
struct PictureSize {
  int width = 1280, height = 720;
};

/// Stores three numbers: "X,Y,Z" in plane metres or "LON,LAT,HEIGHT" in degrees and metres.
Take store_point(std::optional<Vec3>& point);

/// Stores "1280x720".
Take store_size(PictureSize& size);

/// Degrees of a field of view.
inline constexpr NumberRange kFieldsOfView_deg{0, 180};

/// The point in plane metres, given in the plane or by longitude and latitude; empty if not given. Error: longitude and
/// latitude without a header, which defines the plane.
Result<std::optional<Vec3>> point_of(const std::optional<Vec3>& in_plane, const std::optional<Vec3>& lonlat,
                                     const std::optional<scene::Header>& header);

}  // namespace citykiln::commands
