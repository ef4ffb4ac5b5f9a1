// A window in which a person flies through a scene while the picture refines.
#pragma once

#include <functional>

#include "compiler/contract/result.h"
#include "preview/render.h"

namespace citykiln::preview {

/// A function that writes a picture, whose light is multiplied by `exposure` already.
using WritePicture = std::function<void(const Image& image, const Camera& camera, double exposure)>;

/// Checks that a window can be shown. Errors: the window module is not installed, or there is no display.
Result<Done> check_window();

/// Opens a window and returns when it is closed. Keys W, A, S, D, Q and E move, the mouse turns while a button is held,
/// shift is faster, + and - change the exposure, P calls `write` with the picture so far, Esc ends. `options.exposure`
/// is the exposure at the start. Errors: the errors of check_window().
Result<Done> show_interactive(const World& world, const Lights& lights, const LocalLights& local, const Camera& camera,
                              const Options& options, const WritePicture& write);

}  // namespace citykiln::preview
