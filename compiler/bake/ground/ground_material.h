// The material of a face of the ground, by its land cover class, slope and height.
#pragma once

#include <optional>

#include "compiler/geometry/vec.h"
#include "compiler/ground/cover/dry_cover.h"
#include "compiler/map/land_cover_class.h"

namespace citykiln::bake {

/// The properties of a face that its material depends on.
struct GroundFace {
  map::LandCoverClass surface{};
  Vec3 normal;                  ///< Unit, upwards.
  Vec3 centre;                  ///< Plane metres.
  bool is_beside_road = false;  ///< True if it shares a corner with a paved surface.
  bool is_vertical = false;     ///< True for built vertical faces: retaining walls, quays, kerbs.
  ground::DryShares dry{};      ///< The straw and bare ground of its class at its place.
  /// The material of steep unmapped land here (wild_cover.h); empty where nothing is assumed.
  std::optional<materials::Material> wild{};
};

/// The cosine of the steepest slope with soil and grass, 48°. The angle of repose of scree is 35 to 40°; grass holds on
/// slopes that are a little steeper.
inline constexpr double kSteepCosine = 0.669;
/// The cosine of the steepest slope on which snow lies, 58°.
inline constexpr double kSnowCosine = 0.53;
/// The snow line varies from place to place by up to this height, up and down.
inline constexpr double kSnowLineSway_m = 40;

/// True for groups of natural land: neither water nor built nor sports ground.
bool is_land(map::LandCoverGroup group);

/// The material of a face. Roads, water and built ground have the material of their class at any slope and height.
/// Steep land is rock, or masonry in towns and beside roads; vertical faces of land are masonry; land above the snow
/// line, if there is one, is snow; other land has the material of its class, or the ground of dry climates
/// (dry_ground.h). Unmapped land that is steep is wild where that is assumed (wild_cover.h). A function of the
/// arguments only, so that tiles agree.
materials::Material material_of(const GroundFace& face, const std::optional<double>& snow_line_m, std::uint64_t seed);

}  // namespace citykiln::bake
