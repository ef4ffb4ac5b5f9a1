// Lots and blocks, which are made of faces.
#pragma once

#include <vector>

#include "compiler/parcels/empty_lots.h"
#include "compiler/parcels/faces.h"
#include "compiler/parcels/parcels.h"

namespace citykiln::parcels {

struct LabelledParcels {
  Parcels parcels;                                   ///< Blocks and lots are in no order.
  std::vector<std::uint32_t> labels;                 ///< The label of each lot.
  std::vector<std::vector<FrontageEdge>> frontages;  ///< The edges of each lot on streets.
};

/// Joins faces into lots, blocks and rest. Indices of lines and footprints are those of the arguments.
///
/// A lot is a connected set of faces of one label with a frontage; a label of a building counts in all faces of its
/// footprint, unless these would be cut off from a frontage. Land without a frontage is rest. O(n log n).
LabelledParcels lots_of_faces(const Faces& faces, const std::vector<Line>& lines,
                              const std::vector<Footprint>& footprints);

}  // namespace citykiln::parcels
