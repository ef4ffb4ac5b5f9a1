// Roads whose lanes and markings run through a junction.
#pragma once

#include <span>

#include "compiler/roads/junctions/junction.h"

namespace citykiln::roads {

/// True if one road with two arms runs straight through the junction, all other arms have a lower class, and there are
/// no signals. The lanes and lines of that road then continue across the junction and hide its surface. An arm is a
/// road that leaves the junction.
///
/// @param arms  The entry of arms_of() for this junction.
bool has_through_road(const Junction& junction, std::span<const Road> roads, std::span<const Arm> arms);

}  // namespace citykiln::roads
