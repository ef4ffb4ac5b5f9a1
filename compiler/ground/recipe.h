// The ground's part of the scene: what covers it, and how high it is (a map::Heightfield).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/polygon.h"
#include "compiler/map/land_cover_class.h"

namespace citykiln::ground {

/// A piece of the plane with one class, covered where the winding numbers of its rings add up to more than zero. Rings
/// may overlap and cross.
struct LandCoverPolygon {
  ObjectId id;
  map::LandCoverClass surface{};
  std::uint32_t area_m2 = 0;  ///< Of the whole, before any trimming, rounded; the constants below for strips and
                              ///< junctions. Of two surfaces with one priority the smaller wins, then the lower id.
  std::vector<Ring> rings;    ///< Plane metres, snapped.
  std::uint32_t piece = 0;  ///< Tells the pieces of one road apart, which are made when it is baked: 1, 2 … along it.
  std::optional<double> level_m{};  ///< Of standing water: plane height, a multiple of kProfileQuantum_m.
  bool is_graded = false;           ///< Covered by a road that has a profile: it lies on that, whatever its class.
  bool operator==(const LandCoverPolygon&) const = default;
};

/// Strips lie over areas of their priority, junctions over strips, but for those that a road goes through.
inline constexpr std::uint32_t kJunctionArea_m2 = 0, kStripArea_m2 = 1, kPassedJunctionArea_m2 = 2;

/// True where `a` lies on top of `b`. A strict total order of different ids and classes.
bool covers(const LandCoverPolygon& a, const LandCoverPolygon& b);

}  // namespace citykiln::ground
