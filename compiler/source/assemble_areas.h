// Assembles areas from closed ways and from multipolygon and boundary relations with libosmium's assembler.
#pragma once

#include <string_view>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/source/order_elements.h"
#include "compiler/source/osm_data.h"

namespace citykiln::source {

/// True for keys that can describe an area; false for type, source, note, created_by and the like.
bool is_descriptive(std::string_view key);

/// The vectors of the same names in OsmData; areas have no tags yet.
struct AssembledAreas {
  std::vector<Area> areas;
  std::vector<AreaRing> rings;
  std::vector<Location> ring_points;
};

/// Assembles closed ways of at least four nodes that have a descriptive tag and no area=no, and relations of type
/// multipolygon or boundary with at least one way member.
///
/// Missing nodes are left out of rings. If members of a relation are missing, the present ones are assembled, and outer
/// rings made of inner members are left out. Failures are diagnosed kBrokenArea. Ledger account "source/area".
/// Guarantees: sorted by id; outer rings counter-clockwise, inner ones clockwise, each starting at its westernmost
/// point (of equal ones the southernmost). Cost: O(n log n) for each area, if few segments overlap in longitude;
/// parallel.
AssembledAreas assemble_areas(const Elements& elements, int threads, Report& report);

}  // namespace citykiln::source
