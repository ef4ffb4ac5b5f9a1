// Lots and blocks, which are made of faces.
#pragma once

#include <vector>

#include "compiler/parcels/faces.h"
#include "compiler/parcels/parcels.h"

namespace citykiln::parcels {

/// Joins faces into lots, blocks and rest. Indices of lines and footprints are those of the arguments.
///
/// A lot is a connected set of faces of one label with a front; a label of a building counts in all faces of its
/// footprint, unless these would be cut off from a front. What has no front is rest. O(n log n).
Parcels lots_of_faces(const Faces& faces, const std::vector<Line>& lines, const std::vector<Footprint>& footprints);

}  // namespace citykiln::parcels
