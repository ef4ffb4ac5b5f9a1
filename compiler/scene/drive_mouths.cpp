#include "compiler/scene/drive_mouths.h"

#include "compiler/lots/recipe.h"

namespace citykiln::scene {

std::vector<roads::DriveMouth> drive_mouths_of(const Header& header, const Chunk& chunk) {
  std::vector<roads::DriveMouth> mouths;
  if (!header.has_street_furniture) return mouths;
  for (const lots::Yard& yard : chunk.yards) {
    const lots::Frame frame = lots::frame_at(yard.frame);
    for (const lots::YardStrip& strip : yard.strips)
      if (strip.is_drive)
        mouths.push_back({frame.plane(strip.from.y <= strip.to.y ? strip.from : strip.to), frame.inward * -1.0});
  }
  return mouths;
}

}  // namespace citykiln::scene
