// Blends the tints of areas (random variations of the ground's colour) at soft borders, such as between grass and
// scrub.
#pragma once

#include <vector>

#include "compiler/bake/ground/ground_tint.h"
#include "compiler/ground/generate.h"

namespace citykiln::bake {

/// Tints of the vertices that several surfaces with soft borders (ground_tint.h) share.
struct BorderTints {
  std::vector<TintFactor> tints;  ///< One per vertex; meaningful only where is_shared.
  std::vector<bool> is_shared;
};

/// Returns for each shared vertex the mean tint of the surfaces about it. Vertices on the border of a cell (a 128 m
/// square) never count as shared: each cell has only its own faces, and both cells must agree.
///
/// Limits: only tints are blended, not the materials' colours and textures, which would cover large triangles in their
/// neighbour's colour. The transition is as wide as the triangles at the border.
BorderTints border_tints(const ground::GroundMesh& ground, const std::vector<ground::LandCoverPolygon>& surfaces,
                         std::uint64_t seed, plants::Month month = plants::kMidsummer);

}  // namespace citykiln::bake
