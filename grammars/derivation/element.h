// Elements: windows, doors and other parts of a wall whose detail a picture shows. A level that has no room for the
// detail shows the element as one rectangle.
//
//   ┌─────────┐     The node Window has a rectangle, and rules that
//   │ ┌──┬──┐ │     derive frames, panes and a blind. If all of this
//   │ └──┴──┘ │     is within the tolerance of the rectangle, the
//   └─────────┘     rectangle becomes the terminal. The detail becomes
//                   an Element of the derivation.
#pragma once

#include <optional>

#include "grammars/derivation/execution.h"

namespace citykiln::grammars {

/// The largest side of an element. Wider shop fronts have several.
inline constexpr double kMostElementSide_m = 6;

/// A node that becomes an element.
struct ElementPlace {
  Shape shape;         ///< The node's shape with rounded sides (Element): the detail is derived from it.
  Displacement moved;  ///< Upper bounds of the distances between the node's shape and its detail.
};

/// Returns the place of an element if the options ask for elements and the node qualifies: its shape is a rectangle
/// along the scope with sides of kElementStep_m to kMostElementSide_m; the body divides it, changes its appearance, and
/// replaces all of its surface (Body::keeps_surface is false), so the element does not depend on the colour of the wall
/// around it; the detail is within the tolerance (displacement_bound.h). Elements contain no elements.
std::optional<ElementPlace> element_place(Execution& execution, const Body& body);

/// Moves the terminals from `first` on, which are the detail of a node, into a new element, and adds the rectangle as
/// their only terminal. Returns the trace of the node, which has several appearances, so that none of
/// its ancestors is simplified.
NodeTrace replace_by_element(Run& run, Shape&& rectangle, const ElementPlace& place, std::size_t first);

}  // namespace citykiln::grammars
