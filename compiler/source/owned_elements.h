// The elements of a part of a map that the part reports, when parts overlap.
#pragma once

#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/source/order_elements.h"
#include "compiler/source/owns_place.h"

namespace citykiln::source {

/// The elements whose place belongs to the part, sorted. The place of a way is that of its first node that has one; of
/// a relation that of its first such member way. Elements without a place belong to no part. O(n log n).
/// @param elements  With places in ways.
std::vector<OsmId> owned_elements(const Elements& elements, const OwnsPlace& owns);

}  // namespace citykiln::source
