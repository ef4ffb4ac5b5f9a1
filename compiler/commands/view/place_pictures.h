// Renders pictures of places in a scene, each from a camera that sees the place.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compiler/commands/view/preview_scene.h"
#include "compiler/contract/result.h"
#include "compiler/stage_timer.h"

namespace citykiln::commands {

/// A place to render.
struct PlaceToShow {
  Vec2 at;               ///< Plane metres.
  double extent_m = 0;   ///< The size of the object, from which the camera's distance follows.
  bool on_roofs = true;  ///< True: the picture's middle is the highest surface; false: the lowest that can be seen.
  std::string tile{};    ///< The path of a .glb, which is then shown alone; empty: the recipes are shown.
  std::string picture;   ///< The path of the PNG to write.
};

/// Renders a picture of each place. Rays choose the camera: the first that sees the place, of 16 directions from the
/// south on, at 14, 25, 40 and 60 degrees above the horizon; if all are hidden, from 82 degrees.
///
/// Recipes are generated only near the places, with errors of up to two pixels. Pictures do not depend on each other.
/// Errors: a file that cannot be written, a tile that cannot be read. Cost: two to three seconds of one core per
/// picture.
Result<Done> write_place_pictures(const scene::Scene& scene, std::span<const PlaceToShow> places, int threads,
                                  const OnProgress& on_progress);

}  // namespace citykiln::commands
