// Drainage along kerbs, which the marking atlas shows above the paint: gutters, gullies, covers of manholes.
#pragma once

#include "compiler/roads/markings/mark.h"
#include "compiler/roads/markings/marking_layout.h"

namespace citykiln::roads {

/// Returns the drainage of a strip between kerbs as marks, in painting order:
/// - gutters along each kerb: two rows of setts, 0.3 m wide; a concrete channel, 0.45 m, in America, Japan and where
///   one drives on the left;
/// - gullies, iron grates of 0.3 m × 0.5 m in the gutter, one a layout, so one every 12 m;
/// - two round covers of manholes, 0.6 m wide, in the 12 m before a junction.
///
/// None for strips that are not asphalt, are raised, or have no kerb. A rotated layout has rotated marks. No map has
/// these: places and measures are usual ones (RAS-Ew; AASHTO Green Book 4.7.2).
Marks drainage_of(const MarkingLayout& layout);

}  // namespace citykiln::roads
