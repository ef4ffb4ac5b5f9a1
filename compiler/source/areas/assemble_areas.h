// Assembles areas from closed ways and from multipolygon and boundary relations with libosmium's assembler.
#pragma once

#include <string_view>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/source/order_elements.h"
#include "compiler/source/osm_data.h"

namespace citykiln::source {

/// True for keys that can describe an area; false for type, source, note, created_by and the like.
bool is_descriptive(std::string_view key);

/// Areas with their rings and points, in the form of the members of OsmData with these names. `tags` of the areas is
/// empty.
struct AssembledAreas {
  std::vector<Area> areas;
  std::vector<AreaRing> rings;
  std::vector<Location> ring_points;
};

/// Assembles areas from two sources: closed ways of at least four nodes that have a descriptive tag and no area=no, and
/// relations of type multipolygon or boundary with at least one way member.
///
/// - Relations as members: if a member of a multipolygon is itself such a relation, its rings are used. So an island
///   that is a relation is a hole of its lake.
/// - Missing data: missing nodes are left out of rings. If members of a relation are missing, the others are assembled;
///   an outer ring that would consist of members with the role inner is left out.
/// - Cut areas: close_cut_areas() may have closed a relation along the box of the map before, and have added ways for
///   its closed rings. Then the area is made of these ways alone, and is diagnosed kAreaClosed.
/// - Broken rings: rings that cross or touch are mended (mended_rings.h) and diagnosed kAreaMended. Lines that remain
///   open are diagnosed kIncompleteArea if member ways are missing, else kBrokenArea. Failed candidates without a tag
///   of a visible thing (bodies.h) are counted as without_body and not diagnosed.
///
/// Ledger account "source/area". Cannot fail.
///
/// Guarantees: areas are sorted by id; outer rings run counter-clockwise and inner ones clockwise; each ring starts at
/// its westernmost point, the southernmost of several. Cost: O(n log n) per area if few segments overlap in longitude;
/// parallel. Mending takes O(n²).
AssembledAreas assemble_areas(const Elements& elements, int threads, Report& report);

}  // namespace citykiln::source
