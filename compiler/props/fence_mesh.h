// The mesh of a low fence: bars below a rail, which a texture with holes shows.
#pragma once

#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/props/generate.h"

namespace citykiln::props {

/// The greatest height of a fence with bars, in metres. Higher fences are of boards.
inline constexpr double kBarredFence_m = 1.375;

/// True for low fences at tolerances at which the texture with holes is shown.
bool is_barred(const Barrier& barrier, double tolerance_m);

/// Generates a fence as one sheet on the ground, along its axis, which is seen from both sides
/// (Material::kRailing). Its paint is drawn by its id. Requires is_barred(). O(length).
///
/// Guarantees: error_m <= tolerance_m; vertices are on the 2^-10 m grid, texture coordinates multiples of
/// materials::kTextureCoordinateStep_m.
GeneratedProp fence_mesh(const Barrier& fence, const ground::GradedTerrain& ground, double tolerance_m);

/// Returns the paint of a low fence, drawn by its id: dark metal, green, brown or white.
materials::Tint fence_paint(ObjectId id);

}  // namespace citykiln::props
