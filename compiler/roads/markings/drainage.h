// Drainage along kerbs, which the marking atlas shows above the paint: gutters, gullies, covers of manholes.
#pragma once

#include "compiler/roads/markings/mark.h"
#include "compiler/roads/markings/marking_layout.h"

namespace citykiln::roads {

/// Returns the marks of the drainage of a layout:
///
/// - gutters along each kerb: two rows of setts, 0.3 m wide, in countries of MarkingPractice::kVienna that drive on the
///   right; elsewhere a concrete channel, 0.45 m wide;
/// - gullies: iron grates as wide as the gutter and 0.5 m long, one per kerb in each layout of kLayoutLength_m (12 m);
/// - two round manhole covers, 0.6 m wide with a frame of 0.06 m, in the 12 m before a junction.
///
/// There are none for strips that are not asphalt, are raised, have panels, have no kerb, or are narrower than 1.5 m. A
/// layout that is turned by 180 degrees has turned marks. Maps do not have drainage: sizes are usual (RAS-Ew;
/// AASHTO 4.7.2).
Marks drainage_of(const MarkingLayout& layout);

}  // namespace citykiln::roads
