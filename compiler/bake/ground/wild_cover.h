// The cover of steep land of which the map says nothing: slopes that are too steep to build on, to mow and to plough.
#pragma once

#include <optional>

#include "compiler/climate/climate_mix.h"
#include "compiler/geometry/vec.h"
#include "compiler/materials/material.h"

namespace citykiln::bake {

/// The cosine of the gentlest slope that is assumed to be wild, 25°: tractors work on slopes of up to about 20°, and
/// steeper land is tilled or built on only behind retaining walls, which maps show.
inline constexpr double kWildSlopeCosine = 0.906;

/// Returns the material of wild land in a climate: scrub below the tree line, meadow above it. Nothing in deserts and
/// under ice, where land has the ground of its climate.
/// @param belt_m  The altitude of the place as plants::belt_m_at() gives it.
std::optional<materials::Material> wild_material(const climate::ClimateMix& climate, double belt_m);

/// True if a face of unmapped land is wild: steeper than about 25°, a limit that varies with noise of 40 m wavelength.
/// @param normal  Unit, plane frame, z up.
/// @param centre  Plane metres.
bool is_wild(Vec3 normal, Vec3 centre, std::uint64_t seed);

/// True if a face of wild land is rock: the steeper, the more often. A function of the arguments only.
bool is_bare_rock(Vec3 normal, Vec3 centre, std::uint64_t seed);

}  // namespace citykiln::bake
