#include "compiler/map/land_cover_class.h"

#include <cassert>
#include <cstddef>

namespace citykiln::map {
namespace {

using materials::Material;

constexpr LandCoverValues kLandCoverValues[] = {
#define LAND_COVER(name, group, priority, material) \
  {std::string_view(#name).substr(1), LandCoverGroup::group, priority, Material::material},
#include "compiler/map/land_cover_classes.inc"
#undef LAND_COVER
};

}  // namespace

const LandCoverValues& values_of(LandCoverClass surface) {
  assert(surface < LandCoverClass::kCount);
  return kLandCoverValues[static_cast<std::size_t>(surface)];
}

Family family_of(LandCoverClass surface) {
  if (surface == LandCoverClass::kRunway) return Family::kOther;
  if (surface == LandCoverClass::kFarmTrack) return Family::kStreet;
  const LandCoverGroup group = values_of(surface).group;
  return group == LandCoverGroup::kRoad   ? Family::kStreet
         : group == LandCoverGroup::kPath ? Family::kPath
                                          : Family::kOther;
}

bool is_street(LandCoverClass surface) {
  return values_of(surface).group == LandCoverGroup::kRoad && surface != LandCoverClass::kRunway;
}

}  // namespace citykiln::map
