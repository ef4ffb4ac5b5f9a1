// Sections: stretches of streets without buildings, each of which is one lot before it is split (empty_lots.h).
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/parcels/fronts.h"

namespace citykiln::parcels {

/// The side of the cells in which sections of streets without buildings end, in metres.
inline constexpr double kSection_m = 128;

/// Cuts the spans without an owner (kRest) into sections, gives each section a label from first_label on, and returns
/// the usual size of lots of each. Sections end at corners, at buildings' land, and where they leave a cell of
/// kSection_m that begins at whole multiples of it, so that they are local. They do not end within a usual front of a
/// corner or a building's land.
/// @param fronts  The spans, which are cut and labelled.
std::vector<LotSize> label_sections(const Strips& strips, const std::vector<LotSize>& sizes, std::uint32_t first_label,
                                    Fronts& fronts);

}  // namespace citykiln::parcels
