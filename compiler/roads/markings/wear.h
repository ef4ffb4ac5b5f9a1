// Wear of asphalt carriageways, which the marking atlas shows below the paint.
#pragma once

#include "compiler/roads/markings/mark.h"
#include "compiler/roads/markings/marking_layout.h"

namespace citykiln::roads {

/// Returns the wear of a strip as marks: two bands that tyres polish in each lane, whose middles are 1.5 m apart (the
/// track of cars); drops of oil between them; dirt along kerbs; the seam between lanes that were laid one by one. None
/// for strips that are not asphalt or have no traffic lanes. Symmetric about the axis of the strip, which looks alike
/// in both directions.
Marks wear_of(const MarkingLayout& layout);

}  // namespace citykiln::roads
