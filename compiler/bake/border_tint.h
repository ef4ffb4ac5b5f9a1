// Where soft areas meet, their tints meet halfway.
#pragma once

#include <vector>

#include "compiler/bake/ground_tint.h"
#include "compiler/ground/generate.h"

namespace citykiln::bake {

/// The shade of each vertex that soft surfaces (ground_tint.h) share; elsewhere nothing.
struct BorderTints {
  std::vector<TintFactor> shades;
  std::vector<bool> is_shared;
};

/// The mean of the surfaces about a vertex, whatever the order of faces. On the border of a cell nothing is shared: the
/// cells on both sides must agree, and each sees its own faces alone.
///
/// What this cannot do: it carries the tints, not the materials' colours and textures, and it reaches as far as the
/// triangles at the border do; blending colours that way would paint large triangles in their neighbour's.
BorderTints border_tints(const ground::GroundMesh& ground, const std::vector<ground::LandCoverPolygon>& surfaces,
                         std::uint64_t seed, plants::Month month = plants::kMidsummer);

}  // namespace citykiln::bake
