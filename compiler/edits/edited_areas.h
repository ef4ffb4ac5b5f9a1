// Changes the areas of a map after the tags and places of their elements have changed.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/edits/edit.h"
#include "compiler/edits/find_matches.h"
#include "compiler/edits/moved_nodes.h"
#include "compiler/source/osm_data.h"

namespace citykiln::edits {

/// True if a way is an area by its tags and nodes, as source::assemble_areas() decides it.
bool describes_area(const source::OsmData& map, const source::Way& way);

/// Updates the areas of matched elements: changes their tags, adds the areas of closed ways that have become areas, and
/// removes those of dropped elements and of ways that are no areas any more.
/// @param were_areas  For each match: true if it is a way that was an area by its tags before.
void change_areas(source::OsmData& map, const Edits& edits, std::span<const Match> matches,
                  const std::vector<bool>& were_areas, Report& report);

/// Moves the rings of areas of these ways, and of the relations that they are members of. Rings of up to kMostMended
/// points are rebuilt by mended_polygons(). An area of which nothing is left, or wider than 5°, is removed and
/// diagnosed kBrokenArea.
/// @param ways  Sorted ids: the ways with moved nodes.
void move_areas(source::OsmData& map, const NodeMoves& moves, std::span<const std::int64_t> ways, Report& report);

/// Appends the area of a closed way, unless nothing is inside its ring, which is diagnosed kBrokenArea. The areas are
/// not sorted after that. @return true if there is an area.
bool append_area(source::OsmData& map, const source::Way& way, Report& report);

/// Sorts the areas of which those from `first` on are new.
void sort_areas(source::OsmData& map, std::size_t first);

}  // namespace citykiln::edits
