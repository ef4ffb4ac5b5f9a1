#include "preview/scene/scene_geometry.h"

#include <algorithm>
#include <iterator>

namespace citykiln::preview {

namespace {

RTCBounds triangle_bounds(const MeshPart& part, const std::array<std::uint32_t, 3>& triangle) {
  const bake::Float3 &a = part.corners[triangle[0]], &b = part.corners[triangle[1]], &c = part.corners[triangle[2]];
  RTCBounds box{};
  box.lower_x = std::min({a[0], b[0], c[0]}), box.upper_x = std::max({a[0], b[0], c[0]});
  box.lower_y = std::min({a[1], b[1], c[1]}), box.upper_y = std::max({a[1], b[1], c[1]});
  box.lower_z = std::min({a[2], b[2], c[2]}), box.upper_z = std::max({a[2], b[2], c[2]});
  return box;
}

}  // namespace

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

void SceneGeometry::add_to(CellExtent& extent) const {
  for (const MeshPart& part : parts_)
    for (const auto& triangle : part.primitive->triangles) extent.add(triangle_bounds(part, triangle));
  for (const auto& set : sets_)
    for (std::size_t i = 0; i < set->size(); ++i) extent.add(set->box_of(i));
}

std::size_t SceneGeometry::bytes() const {
  std::size_t bytes = 0;
  for (const MeshPart& part : parts_)
    bytes += part.corners.capacity() * sizeof(bake::Float3) + part.pictures.capacity() * sizeof(TexelRectangle);
  for (const auto& set : sets_) bytes += set->bytes();
  return bytes;
}

}  // namespace citykiln::preview
