// Pavements around the corners of a junction.
#pragma once

#include <span>
#include <vector>

#include "compiler/roads/junctions/junction.h"

namespace citykiln::roads {

/// Returns the pavements around those corners of a junction whose two arms (roads) both have raised lanes there. The
/// rings are simple, counter-clockwise and snapped.
///
/// Each ring covers the corner between the axes of its two arms and an arc: the kerb's arc, offset by the width of the
/// raised lanes (at most 6 m). If the raised lanes are wider than the arc's radius, the arc becomes a sharp corner. The
/// part outside the carriageways is visible pavement. Along the arms a ring ends where its arc touches them; the roads'
/// own pavements continue from there.
///
/// @param arms  The entry of arms_of() for this junction.
std::vector<Ring> stroke_corner_pavements(const Junction& junction, std::span<const Road> roads,
                                          std::span<const Arm> arms);

}  // namespace citykiln::roads
