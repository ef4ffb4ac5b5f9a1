// Levels of detail: replaces the result of a node by the node's own surface if that is within the tolerance.
#pragma once

#include "grammars/derivation/run.h"

namespace citykiln::grammars {

/// Returns the appearance of a terminal if appearances are kept and the terminal is wider than the tolerance.
VisibleAppearances visible_appearance(const Run& run, const Terminal& terminal);

/// Replaces the terminals from index `first` on, which are the result of the node, by one terminal with the faces of
/// `start`, if that has fewer vertices and `trace` is within the tolerance. It gets the appearance of most of the area,
/// and the texture of the largest terminal with that appearance.
///
/// @param start  The shape of the node before its first operation.
/// @param trace  The trace of the node; `seen` is updated.
void simplify_node(const Execution& execution, const Shape& start, std::size_t first, NodeTrace& trace);

}  // namespace citykiln::grammars
