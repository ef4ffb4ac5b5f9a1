#include "compiler/verify/standing/taken_land.h"

namespace citykiln::verify {

const ground::LandCoverPolygon* taken_land_at(const ground::LandCoverIndex& land_cover, Vec2 p) {
  const std::uint32_t top = ground::land_cover_at(land_cover, p);
  if (top == ground::kNoLandCover) return nullptr;
  const ground::LandCoverPolygon& surface = land_cover.surfaces[top];
  if (surface.surface == map::LandCoverClass::kPedestrianStreet) return nullptr;
  switch (map::values_of(surface.surface).group) {
    case map::LandCoverGroup::kRoad:
    case map::LandCoverGroup::kRail:
    case map::LandCoverGroup::kBuilding:
    case map::LandCoverGroup::kWater:
      return &surface;
    default:
      return nullptr;
  }
}

OsmId taken_element_at(const ground::LandCoverIndex& land_cover, Vec2 p) {
  const ground::LandCoverPolygon* land = taken_land_at(land_cover, p);
  return land != nullptr ? land->id.osm : OsmId{};
}

}  // namespace citykiln::verify
