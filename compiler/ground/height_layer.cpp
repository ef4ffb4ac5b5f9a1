#include "compiler/ground/height_layer.h"

namespace citykiln::ground {

HeightLayer layer_of(map::SurfaceClass surface) {
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

}  // namespace citykiln::ground
