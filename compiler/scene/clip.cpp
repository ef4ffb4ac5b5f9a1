#include "compiler/scene/clip.h"

#include <algorithm>
#include <utility>

#include "compiler/geometry/polygons/clip_polygon.h"

namespace citykiln::scene {
namespace {

// Tiles with less ground than this have nothing to show.
constexpr double kLeastGround_m2 = 1;

Ring ring_of(const Box2& box) { return {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}; }

// The rings of a clip near a box: with the same winding numbers in it.
std::vector<Ring> rings_near(const Clip& clip, const Box2& box) {
  std::vector<Ring> rings;
  for (const Polygon& polygon : clip)
    for (const Ring* ring : rings_of(polygon))
      if (Ring near = trimmed_to(*ring, box); !near.empty()) rings.push_back(std::move(near));
  return rings;
}

}  // namespace

ground::LandCoverPolygon beyond_clip(const Clip& clip, const Box2& box) {
  ground::LandCoverPolygon beyond{.id = kBeyondClip, .surface = map::LandCoverClass::kUnknown, .rings = {}};
  beyond.raised_priority = 0xff;
  if (clip.empty()) return beyond;
  beyond.rings.push_back(ring_of(box));
  for (Ring& ring : rings_near(clip, box)) {
    std::ranges::reverse(ring);
    beyond.rings.push_back(std::move(ring));
  }
  return beyond;
}

ClipTest::ClipTest(const Clip& clip, const Box2& box)
    : is_clipped_(!clip.empty()), beyond_(ground::band_rings(beyond_clip(clip, box))) {}

bool touches_clip(const Clip& clip, const Box2& box) {
  if (clip.empty()) return true;
  double inside_m2 = 0;
  for (const Polygon& part : united_in(rings_near(clip, box), box)) inside_m2 += area_m2(part);
  return inside_m2 >= kLeastGround_m2;
}

}  // namespace citykiln::scene
