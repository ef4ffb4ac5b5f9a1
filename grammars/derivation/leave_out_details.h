// Levels of detail of bodies that are put together: leaves out successors of a rule that lie within the tolerance of
// larger ones, in rules with details(). Pieces of a split or comp stay, since they would leave holes in a surface.
#pragma once

#include "grammars/derivation/execution.h"

namespace citykiln::grammars {

/// Removes the terminals of those children in `execution.details` that are within the tolerance of terminals of other
/// children, and that are narrow or look like these. Adds the largest distance to Derivation::error_m. The smallest
/// children are tried first, and a child near which others were left out stays.
///
/// @param first  The terminals of the node are those of the derivation from this index on.
/// Guarantees: no point of a child that is left out is farther than that distance from the terminals that stay. For
/// each face, one terminal's convex face or edge is found to which all of its corners are near; the distance to a
/// convex set is convex, so it is largest at a corner. Errors of the child's own terminals, and of details left out in
/// it, are added.
/// Cost: O(corners of terminals²) in the worst case; terminals whose boxes are farther apart than the tolerance are
/// skipped.
void leave_out_details(Execution& execution, std::size_t first);

}  // namespace citykiln::grammars
