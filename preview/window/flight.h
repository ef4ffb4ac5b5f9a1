// The flight of a camera by keys and mouse.
#pragma once

#include "preview/camera/camera.h"
#include "preview/window_module/window_io.h"

namespace citykiln::preview {

/// True if input moves or turns the camera.
bool is_moving(const CitykilnInput& input);

/// Returns the camera after input. Keys move it along the view, aside and up, at 20 m/s, or 200 m/s with shift. The
/// mouse turns it about the vertical and tilts it to at most 89°; a drag over the picture's height turns by the field
/// of view. The distance of look_at stays.
Camera moved(const Camera& camera, const CitykilnInput& input);

}  // namespace citykiln::preview
