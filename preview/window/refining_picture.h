// A picture that is rendered in the background, from a camera that may change at any time.
#pragma once

#include <memory>
#include <optional>

#include "preview/render.h"

namespace citykiln::preview {

/// A picture that is rendered by a separate thread. Refers to the world and its lights, which must outlive this object.
///
/// While the camera moves, pictures are a quarter as wide and high, with 1 sample a pixel. Once it rests, the whole
/// picture is rendered, and refined until all of its samples are taken.
class RefiningPicture {
 public:
  RefiningPicture(const World& world, const Lights& lights, const LocalLights& local, Options options);
  ~RefiningPicture();

  /// Starts again with another camera. A full picture that is being rendered is stopped; a small one is finished first
  /// if the camera still moves.
  void restart(const Camera& camera, bool is_moving);
  /// Returns the picture with the samples taken until now, if it is newer than the picture returned before; else empty.
  std::optional<Image> take_newer();

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace citykiln::preview
