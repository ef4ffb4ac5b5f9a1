// How keys and the mouse move a camera.
#pragma once

#include "preview/camera/camera.h"
#include "preview/window_module/window_io.h"

namespace citykiln::preview {

/// Whether input moves or turns the camera.
bool is_moving(const CitykilnInput& input);

/// The camera after input: keys move along the view, aside and up, the mouse turns about the vertical and tilts to at
/// most 89°. 20 m/s, and 200 m/s with shift; the picture's height of mouse turns by the field of view. The distance of
/// look_at stays.
Camera moved(const Camera& camera, const CitykilnInput& input);

}  // namespace citykiln::preview
