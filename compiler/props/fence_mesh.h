// The mesh of a low fence: one vertical sheet with the texture of a railing, whose holes are cut out.
#pragma once

#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/props/generate.h"

namespace citykiln::props {

/// The greatest height of a fence that is a railing, in metres. Higher fences are of boards, as gardens have, up to the
/// least height of the bars or the mesh around works.
inline constexpr double kMaxRailingFence_m = 1.375, kLeastWorksFence_m = 1.9375;

/// True for fences of at most kMaxRailingFence_m or at least kLeastWorksFence_m, at tolerances at which the texture with holes is shown.
bool is_barred(const Barrier& barrier, double tolerance_m);

/// Generates a fence as one vertical sheet on the ground, along its axis, which is seen from both sides
/// (Material::kRailing). Its paint is drawn by its id. Requires is_barred(). O(length).
///
/// Guarantees: error_m <= tolerance_m; vertices are on the 2^-10 m grid, texture coordinates multiples of
/// materials::kTextureCoordinateStep_m.
GeneratedProp fence_mesh(const Barrier& fence, const ground::GradedTerrain& ground, double tolerance_m);

/// Returns the paint of a low fence, drawn by its id: dark metal, green, brown or white.
materials::Tint fence_paint(ObjectId id);

}  // namespace citykiln::props
