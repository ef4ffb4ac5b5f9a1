// Pictures of places in a scene, each from where the place can be seen.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compiler/commands/preview_scene.h"
#include "compiler/contract/result.h"
#include "compiler/stage_timer.h"

namespace citykiln::commands {

/// A place to be shown.
struct PlaceToShow {
  Vec2 at;               ///< Plane metres.
  double extent_m = 0;   ///< Of what is to be seen; the camera is about as far away as this needs.
  bool on_roofs = true;  ///< The picture's middle is the highest surface; else the lowest that can be seen.
  std::string tile{};    ///< Path of a .glb: the picture shows this tile alone; empty: the recipes.
  std::string picture;   ///< Path of the PNG to write.
};

/// Renders a picture of each place. A camera is chosen by rays: low, from the sunny side, where nothing hides the
/// place; from above where no such view is found.
///
/// Recipes are generated near the places only, with errors of up to two pixels. Pictures do not depend on each other.
/// Errors: a file that cannot be written, a tile that cannot be read. Cost: two to three seconds of one core for each
/// picture.
Result<Done> write_place_pictures(const scene::Scene& scene, std::span<const PlaceToShow> places, int threads,
                                  const OnProgress& on_progress);

}  // namespace citykiln::commands
