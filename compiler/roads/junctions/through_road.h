// Roads whose lanes and markings run through a junction.
#pragma once

#include <span>

#include "compiler/roads/junctions/junction.h"

namespace citykiln::roads {

/// True if one road with two arms runs straight through, all other arms have a lower class, and there are no signals.
/// Its lanes and lines then continue across the junction and hide the junction's surface.
///
/// @param arms  The entry of arms_of() for this junction.
bool has_through_road(const Junction& junction, std::span<const Road> roads, std::span<const Arm> arms);

}  // namespace citykiln::roads
