// comp(e): one shape for each edge.
#pragma once

#include "grammars/derivation/execution.h"

namespace citykiln::grammars {

/// Applies the bodies of the selectors to the edges of the shape's faces, each edge once. The shape of an edge has one
/// face of two points, which is not drawn; its scope has x along the edge (upwards, if the edge is vertical), y along
/// the normal of the first face with that edge, and no size along y and z. A primitive fills it after s().
void comp_edges(Execution& execution, const Statement& statement);

}  // namespace citykiln::grammars
