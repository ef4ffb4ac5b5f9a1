// Aborts at skeletons with frames, lengths or references that no skeleton may have.
#pragma once

#include <cmath>
#include <cstdlib>

#include "lsystems/rewriting/skeleton.h"

namespace citykiln::lsystems {

inline bool is_finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
inline bool is_sound(const TurtleFrame& f) {
  return is_finite(f.at) && std::abs(length(f.heading) - 1) < 1e-9 && std::abs(dot(f.heading, f.left)) < 1e-9 &&
         length(cross(f.heading, f.left) - f.up) < 1e-9;
}

inline void check_skeleton(const Skeleton& skeleton) {
  for (std::size_t i = 0; i < skeleton.segments.size(); ++i) {
    const Segment& segment = skeleton.segments[i];
    if (!is_sound(segment.start) || !is_finite(segment.end().at) || segment.parent >= static_cast<std::int32_t>(i))
      std::abort();
    if (!(segment.start_radius >= 0) || !(segment.end_radius >= 0) || segment.order < 0) std::abort();
  }
  for (const FlatPolygon& polygon : skeleton.polygons)
    if (polygon.count < 3 || polygon.first + polygon.count > skeleton.vertices.size()) std::abort();
  for (const Vec3 vertex : skeleton.vertices)
    if (!is_finite(vertex)) std::abort();
  for (const Instance& instance : skeleton.instances)
    if (!is_sound(instance.frame)) std::abort();
}

}  // namespace citykiln::lsystems
