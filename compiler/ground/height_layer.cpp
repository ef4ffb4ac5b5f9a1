#include "compiler/ground/height_layer.h"

namespace citykiln::ground {
namespace {

HeightLayer layer_of_class(map::SurfaceClass surface) {
  using enum map::SurfaceClass;
  switch (surface) {
    case kPavement:
    case kKerb:
    case kVerge:
    case kIsland:
    case kTrafficIsland:
    case kCycleTrack:
      return HeightLayer::kRoad;
    case kTram:
    case kParkingLane:
    case kFarmTrack:
      return HeightLayer::kCarriageway;
    default:
      break;
  }
  switch (map::values_of(surface).group) {
    case map::SurfaceGroup::kRoad:
    case map::SurfaceGroup::kRail:
      return HeightLayer::kCarriageway;
    case map::SurfaceGroup::kWater:
      return HeightLayer::kWater;
    default:
      return HeightLayer::kLand;
  }
}

bool is_strip_or_junction(const Surface& surface) { return surface.area_m2 <= kPassedJunctionArea_m2; }

}  // namespace

HeightLayer layer_of(const Surface& surface) {
  const HeightLayer layer = layer_of_class(surface.surface);
  // paths follow the land, but for those that lead to bridges and underpasses
  if (surface.is_graded && layer == HeightLayer::kLand) return HeightLayer::kCarriageway;
  return layer == HeightLayer::kWater || is_strip_or_junction(surface) ? layer : HeightLayer::kLand;
}

FaceHeight face_height_of(const Surface& surface) { return {layer_of(surface), surface.level_m}; }

}  // namespace citykiln::ground
