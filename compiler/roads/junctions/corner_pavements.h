// Pavements and kerbs around the corners of a junction.
#pragma once

#include <span>
#include <vector>

#include "compiler/roads/junctions/junction.h"

namespace citykiln::roads {

/// Returns the pavements around the corners of a junction between two arms that both have a pavement or cycle track
/// there. Verges outside these do not count. The rings are simple, counter-clockwise and snapped.
///
/// Each ring covers the corner between the axes of its two arms, out to the outermost pavement or cycle track of each
/// arm (at most 6 m). The radius of the kerb's arc is reduced by the smaller width; at 0 the corner is sharp. The
/// carriageways cover the inner part. A ring ends where its arc touches the arms. A corner whose arc reaches beyond the
/// junction has none.
///
/// @param arms  The entry of arms_of() for this junction; as many as junction.cuts.
std::vector<Ring> stroke_corner_pavements(const Junction& junction, std::span<const Road> roads,
                                          std::span<const Arm> arms);

/// Returns the kerbs around the same corners: rings like those above, kerb_m wide at most. The carriageways cover all
/// of them but the outermost kerb_m, which joins the kerbs of the arms.
std::vector<Ring> stroke_corner_kerbs(const Junction& junction, std::span<const Road> roads, std::span<const Arm> arms,
                                      double kerb_m);

}  // namespace citykiln::roads
