#include "compiler/bake/ground/shown_ground.h"

#include <algorithm>

#include "compiler/bake/layer.h"
#include "compiler/scene/clip.h"

namespace citykiln::bake {

namespace {

bool is_beyond(std::uint32_t surface, const scene::LandCover& cover) {
  return surface != ground::kNoLandCover && cover.surfaces[surface].id == scene::kBeyondClip;
}

// A vertical face without a land cover is a wall between two layers; it goes with the ground at its foot.
RemovedEdges edges_beyond(const ground::GroundMesh& ground, const scene::LandCover& cover) {
  RemovedEdges edges;
  for (std::uint32_t f = 0; f < ground.first_vertical; ++f) {
    if (!is_beyond(ground.face_cover[f], cover)) continue;
    const Triangle& t = ground.mesh.triangles[f];
    for (std::size_t i = 0; i < 3; ++i)
      edges.emplace(ground.mesh.positions[t[i]], ground.mesh.positions[t[(i + 1) % 3]]);
  }
  return edges;
}

// The layer that hides a face, or is it: the ground below a building is seen only without the building.
Layer layer_below(map::LandCoverClass surface) {
  return surface == map::LandCoverClass::kBuilding ? Layer::kBuildings : layer_of(surface);
}

}  // namespace

RemovedEdges remove_beyond_clip(ground::GroundMesh& ground, const scene::LandCover& cover) {
  const auto is_any = [&](std::uint32_t surface) { return is_beyond(surface, cover); };
  if (std::ranges::none_of(ground.face_cover, is_any)) return {};
  RemovedEdges edges = edges_beyond(ground, cover);
  std::size_t kept = 0;
  std::uint32_t kept_flat = 0;
  for (std::uint32_t f = 0; f < ground.face_cover.size(); ++f) {
    if (is_any(ground.face_cover[f])) continue;
    kept_flat += f < ground.first_vertical;
    ground.mesh.triangles[kept] = ground.mesh.triangles[f];
    ground.face_cover[kept++] = ground.face_cover[f];
  }
  ground.mesh.triangles.resize(kept), ground.face_cover.resize(kept);
  ground.first_vertical = kept_flat;
  return edges;
}

bool shows_land_for_others(const scene::Shown& shown) {
  return is_shown(shown, Layer::kGround) &&
         !(is_shown(shown, Layer::kRoads) && is_shown(shown, Layer::kWater) && is_shown(shown, Layer::kBuildings));
}

ground::GroundMesh shown_ground(ground::GroundMesh ground, const scene::LandCover& cover, const scene::Shown& shown) {
  for (std::uint32_t& surface : ground.face_cover)
    if (surface != ground::kNoLandCover && !is_shown(shown, layer_below(cover.surfaces[surface].surface)))
      surface = ground::kNoLandCover;
  return ground;
}

}  // namespace citykiln::bake
