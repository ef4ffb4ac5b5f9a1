// Applies the edits of a file to a map, between reading and locating it.
#pragma once

#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/edits/edit.h"
#include "compiler/source/osm_data.h"
#include "compiler/source/owns_place.h"

namespace citykiln::edits {

/// A map with edits.
struct EditedMap {
  source::OsmData map;
  std::vector<bool> had_effect;  ///< For each of Edits::lines: true if it fits an element, or has added one.
};

/// Returns a map with all edits. Filters see the map as it was read; the changes of all lines that fit an element are
/// made in the order of the lines.
///
/// - Dropping an element removes its object alone: nodes of a dropped way stay in other ways, ways through a dropped
///   node keep their course, and areas of relations keep the shape that a dropped member gave them.
/// - A node moves in all ways and areas that it is a node of. The rings of these areas are rebuilt by
///   mended_polygons(), or only moved, even if they then cross, where they have more than kMostMended points.
/// - A closed way becomes an area, or is none any more, by its new tags; a relation keeps its area.
/// - Added ways whose points are nodes of the map, or equal places of other added ways, are joined there.
///
/// The boxes of the map stay: edits do not change what is compiled. Ledger account "edits/element": elements that lines
/// change or drop; those added count as split. Diagnosed: kBrokenArea where nothing is left of an area.
/// @param map   Its members keep their order; strings and tags are numbered anew if the edits have new ones.
/// @param owns  The places that a region reports; empty for a whole map. The report also counts what is added there.
///
/// Guarantees: a tile of a region equals that of the whole, if all places within the region's radii are the same
/// (regions/radii.h). Cost: that of find_matches(); O(map) if places, or texts that the map does not have, are new.
EditedMap with_edits(source::OsmData map, const Edits& edits, Report& report, const source::OwnsPlace& owns = {});

/// Diagnoses the lines that had no effect (kEditWithoutEffect), and counts all lines in the account "edits/line". Once
/// a run: a region does not know the whole map.
void report_lines(const Edits& edits, const std::vector<bool>& had_effect, Report& report);

}  // namespace citykiln::edits
