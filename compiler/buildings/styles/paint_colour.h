// Converts colours to tints of materials.
#pragma once

#include <array>
#include <initializer_list>

#include "compiler/map/features.h"
#include "compiler/materials/material.h"

namespace citykiln::buildings {

/// Linear reflectance, 0 … 1.
using LinearRgb = std::array<double, 3>;

/// Returns the reflectance of weathered paint of a colour. Each channel is moved by a quarter towards the colour's
/// grey, then scaled linearly from 0 … 1 to 0.04 … 0.76.
LinearRgb paint_reflectance(const map::Srgb& colour);

/// Returns the first material that can be tinted to the paint; tints only darken. If no material can be tinted so,
/// returns the last one. If the first material is glass, it is returned.
/// @param choice  Not empty; the last material is the lightest.
materials::Material tintable_material(const LinearRgb& paint, std::initializer_list<materials::Material> choice);

/// Returns the tint that multiplies the base colour by these factors, clamped to 0 … 1.
materials::Tint tint_of(const LinearRgb& share);

/// Returns the tint that brings the material as close to the paint as darkening can.
materials::Tint tint_towards(materials::Material material, const LinearRgb& paint);

}  // namespace citykiln::buildings
