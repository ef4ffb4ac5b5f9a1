// Levels of detail: replaces the terminals of a node by the node's own surface, if both are within the tolerance. A
// node is one application of a rule to a shape; its trace has the distance between the node's surface and its result.
#pragma once

#include "grammars/derivation/execution.h"

namespace citykiln::grammars {

/// Returns the appearance of a terminal; none if appearances are not kept (DeriveOptions::keep_appearances) or the
/// terminal is not wider than the tolerance.
VisibleAppearances visible_appearance(const Run& run, const Terminal& terminal);

/// Replaces the terminals of a node by one terminal with the faces of `start`, if this has fewer vertices and the
/// displacement in `trace` is within the tolerance. The new terminal gets the appearance of most of the replaced area,
/// and the texture of the largest terminal with that appearance.
///
/// @param start  The shape of the node before its first operation.
/// @param first  The terminals of the node are those of the derivation from this index on.
/// @param trace  The trace of the node; `seen` becomes the appearance of the new terminal.
void simplify_node(const Execution& execution, const Shape& start, std::size_t first, NodeTrace& trace);

}  // namespace citykiln::grammars
