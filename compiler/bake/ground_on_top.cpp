#include "compiler/bake/ground_on_top.h"

#include "compiler/ground/height_layer.h"

namespace citykiln::bake {

double ground_on_top_m(const ground::LandCoverIndex& land_cover, const ground::GradedTerrain& graded, Vec2 p) {
  const std::uint32_t top = ground::land_cover_at(land_cover, p);
  if (top == ground::kNoLandCover) return land_m(graded, p);
  return ground::layer_height_m(ground::heights_at(graded, p), ground::face_height_of(land_cover.surfaces[top]));
}

}  // namespace citykiln::bake
