// Adds the new elements of edits to a map.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/edits/edit.h"
#include "compiler/source/osm_data.h"

namespace citykiln::edits {

/// An element that a map has only since it was edited, and the place that decides which region owns it.
struct AddedElement {
  OsmId id;
  source::Location at;     ///< The place of its first node.
  std::uint32_t line = 0;  ///< Index in Edits::lines.
};

/// Returns the new elements whose points are all there. An element is left out if the map has no node that it names, or
/// if it has an element with its id.
std::vector<AddedElement> elements_to_add(const source::OsmData& map, const Edits& edits);

/// Adds these elements. A way has the nodes that its points name, and new ones at its places. O(map) if there are any.
void add_elements(source::OsmData& map, const Edits& edits, const std::vector<AddedElement>& added, Report& report);

}  // namespace citykiln::edits
