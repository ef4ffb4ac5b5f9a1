// The mesh of a railing: posts, a handrail and rails below it.
//
//     ===================================  handrail, height_m above the ground
//     -----------------------------------  rails
//     ___|____________|____________|_____  posts, at most 2 m apart
#pragma once

#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/props/generate.h"

namespace citykiln::props {

/// Generates a railing on the ground. Every post and rail is closed. From a tolerance on that is the distance
/// between two rails and the depth of a foot the posts are left out; from height_m on there is no mesh. O(length).
///
/// Guarantees: error_m <= tolerance_m; vertices are on the 2^-10 m grid.
GeneratedProp railing_mesh(const Barrier& railing, const ground::GradedTerrain& ground, double tolerance_m);

}  // namespace citykiln::props
