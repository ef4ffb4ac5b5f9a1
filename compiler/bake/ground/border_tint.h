// Blends tints at the borders between areas with soft borders.
#pragma once

#include <vector>

#include "compiler/bake/ground/ground_tint.h"
#include "compiler/ground/generate.h"

namespace citykiln::bake {

/// Tints of the vertices that several surfaces with soft borders (ground_tint.h) share; undefined at other vertices.
struct BorderTints {
  std::vector<TintFactor> tints;
  std::vector<bool> is_shared;
};

/// Returns for each shared vertex the mean tint of the surfaces about it. On the border of a cell no vertex counts as
/// shared, as the cells on both sides must agree, and each knows only its own faces.
///
/// Limits: only tints are blended, not the materials' colours and textures, as these would cover large triangles in
/// their neighbour's colour. The transition is as wide as the triangles at the border.
BorderTints border_tints(const ground::GroundMesh& ground, const std::vector<ground::LandCoverPolygon>& surfaces,
                         std::uint64_t seed, plants::Month month = plants::kMidsummer);

}  // namespace citykiln::bake
