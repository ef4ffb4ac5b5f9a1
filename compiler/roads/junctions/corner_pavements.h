// Pavements round the corners of a junction.
#pragma once

#include <span>
#include <vector>

#include "compiler/roads/junctions/junction.h"

namespace citykiln::roads {

/// Where something is raised on both sides of a corner: from the axes of the two arms to the arc that lies as far
/// outside the kerbs' as the raised lanes are wide (their edges' own corner, where they are wider than the kerbs' arc).
/// Simple counter-clockwise rings, snapped; what shows of them beside the carriageways is pavement. Along the arms
/// they end where the arcs touch: the strips' own pavements pass there. Of what is raised 6 m at most goes round.
///
/// @param arms  arms_at(roads, junction.places, junction.family).
std::vector<Ring> stroke_corner_pavements(const Junction& junction, std::span<const Road> roads,
                                          std::span<const Arm> arms);

}  // namespace citykiln::roads
