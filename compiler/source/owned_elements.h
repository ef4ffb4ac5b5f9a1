// Chooses the elements that one of several overlapping extracts counts and diagnoses, so that each is counted once.
#pragma once

#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/source/order_elements.h"
#include "compiler/source/owns_place.h"

namespace citykiln::source {

/// Returns the ids of the elements whose place `owns` accepts, sorted. The place of a way is its first node with a
/// location; the place of a relation is the place of its first member way that has one. Elements without a place are
/// never included. O(n log n).
/// @param elements  Ways must hold the locations of their nodes.
std::vector<OsmId> owned_elements(const Elements& elements, const OwnsPlace& owns);

}  // namespace citykiln::source
