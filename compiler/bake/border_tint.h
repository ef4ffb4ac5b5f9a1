// Blends tints where areas with soft borders meet.
#pragma once

#include <vector>

#include "compiler/bake/ground_tint.h"
#include "compiler/ground/generate.h"

namespace citykiln::bake {

/// Tints of the vertices that surfaces with soft borders (ground_tint.h) share; undefined at other vertices.
struct BorderTints {
  std::vector<TintFactor> tints;
  std::vector<bool> is_shared;
};

/// Returns for each shared vertex the mean of the surfaces about it, whatever the order of faces. On the border of a
/// cell no vertex is shared: the cells on both sides must agree, and each has only its own faces.
///
/// Limits: only tints are blended, not the materials' colours and textures, and the transition is as wide as the
/// triangles at the border. Blended colours would cover large triangles in their neighbour's colour.
BorderTints border_tints(const ground::GroundMesh& ground, const std::vector<ground::LandCoverPolygon>& surfaces,
                         std::uint64_t seed, plants::Month month = plants::kMidsummer);

}  // namespace citykiln::bake
