// The ground's part of the scene: what covers it, and how high it is (a map::Heightfield).
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/polygon.h"
#include "compiler/map/surface_class.h"

namespace citykiln::ground {

/// A piece of the plane with one class, covered where the winding numbers of its rings add up to more than zero. Rings
/// may overlap and cross.
struct Surface {
  ObjectId id;
  map::SurfaceClass surface{};
  std::uint32_t area_m2 = 0;  ///< Of the whole, before any trimming, rounded; kStripArea_m2 for strips, 0 for
                              ///< junctions. Of two surfaces with one priority the smaller wins, then the lower id.
  std::vector<Ring> rings;    ///< Plane metres, snapped.
  bool operator==(const Surface&) const = default;
};

/// Strips lie over areas of their priority, junctions over strips.
inline constexpr std::uint32_t kStripArea_m2 = 1;

/// True where `a` lies on top of `b`. A strict total order of different ids and classes.
bool covers(const Surface& a, const Surface& b);

}  // namespace citykiln::ground
