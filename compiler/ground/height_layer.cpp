#include "compiler/ground/height_layer.h"

namespace citykiln::ground {
namespace {

HeightLayer layer_of_class(map::LandCoverClass surface) {
  using enum map::LandCoverClass;
  switch (surface) {
    case kPavement:
    case kKerb:
    case kVerge:
    case kIsland:
    case kTrafficIsland:
    case kCycleTrack:
      return HeightLayer::kRoad;
    case kTram:
    case kStreetRails:
    case kParkingLane:
    case kFarmTrack:
      return HeightLayer::kCarriageway;
    default:
      break;
  }
  switch (map::values_of(surface).group) {
    case map::LandCoverGroup::kRoad:
    case map::LandCoverGroup::kRail:
      return HeightLayer::kCarriageway;
    case map::LandCoverGroup::kWater:
      return HeightLayer::kWater;
    default:
      return HeightLayer::kLand;
  }
}

bool is_strip_or_junction(const LandCoverPolygon& surface) { return surface.area_m2 <= kPassedJunctionArea_m2; }

}  // namespace

HeightLayer layer_of(const LandCoverPolygon& surface) {
  const HeightLayer layer = layer_of_class(surface.surface);
  // paths lie on the land, except those with a profile: to bridges and underpasses
  if (surface.is_graded && layer == HeightLayer::kLand) return HeightLayer::kCarriageway;
  return layer == HeightLayer::kWater || is_strip_or_junction(surface) ? layer : HeightLayer::kLand;
}

FaceHeight face_height_of(const LandCoverPolygon& surface) { return {layer_of(surface), surface.level_m}; }

}  // namespace citykiln::ground
