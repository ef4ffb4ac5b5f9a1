// Pavements and kerbs around the corners of a junction.
#pragma once

#include <span>
#include <vector>

#include "compiler/roads/junctions/junction.h"

namespace citykiln::roads {

/// Returns the pavements around those corners of a junction whose two arms (roads) both have a pavement or cycle track
/// there. Verges outside these do not count. The rings are simple, counter-clockwise and snapped.
///
/// Each ring covers the corner between the axes of its two arms and an arc: the kerb's arc, offset by the width up to
/// the outermost pavement or cycle track (at most 6 m). If that is more than the arc's radius, the arc becomes a sharp
/// corner. The part outside the carriageways is visible pavement. Along the arms a ring ends where its arc touches
/// them; the roads' own pavements continue from there.
///
/// @param arms  The entry of arms_of() for this junction.
std::vector<Ring> stroke_corner_pavements(const Junction& junction, std::span<const Road> roads,
                                          std::span<const Arm> arms);

/// Returns the kerbs around the same corners: rings as above of which the outermost kerb_m are visible, since the
/// carriageways cover the rest. They lie on the pavements' inner edge, and join the kerbs of the arms.
std::vector<Ring> stroke_corner_kerbs(const Junction& junction, std::span<const Road> roads, std::span<const Arm> arms,
                                      double kerb_m);

}  // namespace citykiln::roads
