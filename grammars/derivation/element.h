// Elements: windows, doors and other parts of a wall whose detail a picture shows. A level that has no room for the
// detail shows the element as one rectangle.
//
//   ┌─────────┐     The node Window has a rectangle and rules that lead to frames, panes and a blind. If all of it is
//   │ ┌──┬──┐ │     within the tolerance of the rectangle, the rectangle becomes the terminal, and the detail becomes
//   an │ └──┴──┘ │     Element of the derivation. └─────────┘
#pragma once

#include <optional>

#include "grammars/derivation/execution.h"

namespace citykiln::grammars {

/// The largest side of an element. Wider shop fronts have several.
inline constexpr double kMostElementSide_m = 6;

/// A node that becomes an element.
struct ElementPlace {
  Shape shape;         ///< The node's shape with rounded sides (Element): the detail is derived from it.
  Displacement moved;  ///< A bound of the distance between the node's shape and its detail.
};

/// Returns the place of an element if the options ask for elements and the node qualifies: its shape is a rectangle
/// along the scope with sides of kElementStep_m to kMostElementSide_m; the body divides it, changes its appearance, and
/// leaves no part of it as it was (Body::keeps_surface), so that walls of all colours share the element; the detail is
/// within the tolerance (displacement_bound.h). Elements contain no elements.
std::optional<ElementPlace> element_place(Execution& execution, const Body& body);

/// Moves the terminals from `first` on, which are the detail of a node, into a new element, and adds the rectangle as
/// their only terminal. Returns the trace of the node: it shows many appearances, so no ancestor is simplified.
NodeTrace replace_by_element(Run& run, Shape&& rectangle, const ElementPlace& place, std::size_t first);

}  // namespace citykiln::grammars
