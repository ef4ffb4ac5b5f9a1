// A picture that is rendered in the background, from a camera that may change at any time.
#pragma once

#include <memory>
#include <optional>

#include "preview/render.h"

namespace citykiln::preview {

/// Renders on a thread of its own. Refers to world and lights, which must outlive it.
///
/// While the camera moves, pictures are a quarter as wide and high, with 1 sample a pixel; once it rests, the whole
/// picture is rendered, and refined until its samples are taken.
class RefiningPicture {
 public:
  RefiningPicture(const World& world, const Lights& lights, const LocalLights& local, Options options);
  ~RefiningPicture();

  /// Starts anew with another camera, as soon as the pass of the one before is stopped.
  void restart(const Camera& camera, bool is_moving);
  /// The picture so far, if it is newer than the one taken before.
  std::optional<Image> take_newer();
  /// The last picture of full size; empty before the first.
  const Image& latest() const;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace citykiln::preview
