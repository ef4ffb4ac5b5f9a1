// Colours on materials: as paint of that colour, muted as weather does.
#pragma once

#include <array>
#include <initializer_list>

#include "compiler/map/features.h"
#include "compiler/materials/material.h"

namespace citykiln::buildings {

/// LinearRgb reflectance, 0 … 1.
using LinearRgb = std::array<double, 3>;

/// Paint reflects between 4 and 76 percent, and has lost some of its colour to sun and dust.
LinearRgb paint_reflectance(const map::Srgb& colour);

/// The first material that can be tinted to the paint, since tints only darken; the last, which has to be the lightest,
/// where none can. Glass stays glass: what comes first is taken if it is that.
materials::Material tintable_material(const LinearRgb& paint, std::initializer_list<materials::Material> choice);

/// Shares of the base colour, each 0 … 1; what is beyond is cut off.
materials::Tint tint_of(const LinearRgb& share);

/// The tint that gives the material this colour, as far as it can be tinted to it.
materials::Tint tint_towards(materials::Material material, const LinearRgb& paint);

}  // namespace citykiln::buildings
