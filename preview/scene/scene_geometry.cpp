#include "preview/scene/scene_geometry.h"

#include <algorithm>
#include <iterator>

namespace citykiln::preview {

void SceneGeometry::commit() {
  for (const MeshPart& part : parts_) attach(device_, scene_, part);
  unsigned first = 0;
  for (const auto& set : sets_) {
    set->attach_to(device_, scene_, first);
    first += static_cast<unsigned>(set->size());
  }
  // watertight edges: no ray passes between two triangles that share an edge
  rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
  rtcCommitScene(scene_);
}

Hit SceneGeometry::hit_of(const RTCHit& found, const RayFootprint& footprint) const {
  if (found.instID[0] == RTC_INVALID_GEOMETRY_ID) return hit_on(parts_[found.geomID], found, footprint);
  const auto after = std::ranges::upper_bound(sets_, found.instID[0], {}, [](const auto& set) { return set->first(); });
  return (*std::prev(after))->hit_in_world(found, footprint);
}

std::size_t SceneGeometry::bytes() const {
  std::size_t bytes = 0;
  for (const MeshPart& part : parts_) bytes += part.corners.capacity() * sizeof(bake::Float3);
  for (const auto& set : sets_) bytes += set->bytes();
  return bytes;
}

}  // namespace citykiln::preview
