// The material of a face of the ground: that of its class, unless slope or height change it.
#pragma once

#include <optional>

#include "compiler/geometry/vec.h"
#include "compiler/map/land_cover_class.h"

namespace citykiln::bake {

/// The properties of a face that its material depends on.
struct GroundFace {
  map::LandCoverClass surface{};
  Vec3 normal;                  ///< Unit, upwards.
  Vec3 centre;                  ///< Plane metres.
  bool is_beside_road = false;  ///< Whether it shares a corner with a paved surface.
  bool is_vertical = false;     ///< Built: a retaining wall, a quay, a kerb.
};

/// Steeper land holds neither soil nor grass: the angle of repose of scree is 35 to 40°, grass holds a little more.
/// Cosine of 48°.
inline constexpr double kSteepCosine = 0.669;
/// Snow slides off steeper land: cosine of 58°.
inline constexpr double kSnowCosine = 0.53;
/// The snow line varies by as much, up and down.
inline constexpr double kSnowLineSway_m = 40;

/// Whether a group is land: neither water nor built nor sports ground.
bool is_land(map::LandCoverGroup group);

/// The material of a face: on steep land rock, or masonry in towns and beside roads; masonry on vertical faces of land;
/// snow on land above the snow line, if there is one; else that of its class. Roads, water and built ground keep theirs
/// at any slope and height. A function of the arguments alone, so that tiles agree. Total.
materials::Material material_of(const GroundFace& face, const std::optional<double>& snow_line_m, std::uint64_t seed);

}  // namespace citykiln::bake
