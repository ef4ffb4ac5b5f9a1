// The mesh of a fence: one vertical sheet with a texture of bars, boards, pickets or chain-link, whose holes are cut
// out.
#pragma once

#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/props/generate.h"

namespace citykiln::props {

/// The greatest height of a fence that is a railing, in metres. Higher fences are of boards, as gardens have, up to the
/// least height of the bars or the mesh around works.
inline constexpr double kMaxRailingFence_m = 1.375, kLeastWorksFence_m = 1.9375;

/// True for fences, at tolerances at which textures with holes are shown.
bool is_sheet(const Barrier& barrier, double tolerance_m);

/// Generates a fence as one vertical sheet on the ground, along its axis, which is seen from both sides. Its paint is
/// drawn by its id. Requires is_sheet(). O(length).
///
/// Guarantees: error_m <= tolerance_m; vertices are on the 2^-10 m grid, texture coordinates multiples of
/// materials::kTextureCoordinateStep_m.
GeneratedProp fence_mesh(const Barrier& fence, const ground::GradedTerrain& ground, double tolerance_m);

/// Returns the kind of a fence; that of a mapped one by its height: kAny for bars, else kBoards.
map::FenceKind kind_of_fence(const Barrier& fence);

/// Returns the paint of a fence for the material of its sheet, drawn by its id: weathered wood for boards, mostly white
/// for pickets, zinc or green for mesh; dark metal, green, brown or white for bars.
materials::SurfaceMaterial fence_surface(const Barrier& fence);

}  // namespace citykiln::props
