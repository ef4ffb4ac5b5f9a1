// Geometry of Embree whose bounds and intersections are computed by functions of ours.
#pragma once

#include <embree3/rtcore.h>

#include <cstddef>

namespace citykiln::preview {

/// Adds a geometry of `count` primitives to a scene.
/// @tparam Calls  Has the static functions bounds(), intersect() and, if rays may be occluded, occluded().
/// @param data  The userPtr of geometryUserPtr in these calls; must outlive the scene.
template <typename Calls>
void attach_user_geometry(RTCDevice device, RTCScene scene, std::size_t count, void* data) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(count));
  rtcSetGeometryUserData(geometry, data);
  rtcSetGeometryBoundsFunction(
      geometry, [](const RTCBoundsFunctionArguments* args) { Calls::bounds(args); }, nullptr);
  rtcSetGeometryIntersectFunction(geometry, [](const RTCIntersectFunctionNArguments* args) { Calls::intersect(args); });
  if constexpr (requires { &Calls::occluded; })
    rtcSetGeometryOccludedFunction(geometry, [](const RTCOccludedFunctionNArguments* args) { Calls::occluded(args); });
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

}  // namespace citykiln::preview
