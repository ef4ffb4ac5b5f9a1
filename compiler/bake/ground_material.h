// What a face of the ground is made of: its class, unless it is too steep or too high for that.
#pragma once

#include <optional>

#include "compiler/geometry/vec.h"
#include "compiler/map/land_cover_class.h"

namespace citykiln::bake {

/// A face as its material depends on it.
struct GroundFace {
  map::LandCoverClass surface{};
  Vec3 normal;                  ///< Unit, upwards.
  Vec3 centre;                  ///< Plane metres.
  bool is_beside_road = false;  ///< A corner of it is a road's.
  bool is_vertical = false;     ///< Built: a retaining wall, a quay, a kerb.
};

/// Land steeper than this does not hold soil or grass; the angle of repose of scree is 35 to 40°, grass holds a little
/// more. Cosine of 48°.
inline constexpr double kSteepCosine = 0.669;
/// Snow slides off what is steeper: cosine of 58°.
inline constexpr double kSnowCosine = 0.53;
/// The snow line wanders by as much, up and down.
inline constexpr double kSnowLineSway_m = 40;

/// Is it land: neither water nor built nor sporting ground?
bool is_land(map::LandCoverGroup group);

/// Rock where land is steep, masonry where that is in a town or beside a road, or land stands upright; snow on land
/// above the line, if there is one; else the class's own. Roads, water and what is built keep theirs at any slope and
/// height. A function of the arguments alone, so that tiles agree. Total.
materials::Material material_of(const GroundFace& face, const std::optional<double>& snow_line_m, std::uint64_t seed);

}  // namespace citykiln::bake
