// Areas of closed ways and of multipolygon and boundary relations, by libosmium's area assembler.
#pragma once

#include <string_view>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/source/order_elements.h"
#include "compiler/source/osm_data.h"

namespace citykiln::source {

/// True where the element may say what an area is: a key other than type, source, note, created_by and the like.
bool is_descriptive(std::string_view key);

/// As the vectors of the same names in OsmData; the areas without tags.
struct AssembledAreas {
  std::vector<Area> areas;
  std::vector<AreaRing> rings;
  std::vector<Location> ring_points;
};

/// Assembles the areas. Candidates are closed ways of at least four nodes with a tag that describes and without
/// area=no, and relations of type multipolygon or boundary with a way among their members.
///
/// Missing nodes are left out of the ring. Of a relation with missing members the present ones are assembled, and outer
/// rings that turn out to be made of inner members are left out. What cannot be assembled is diagnosed kBrokenArea.
/// Account "source/area". Guarantees: sorted by id; outer rings counter-clockwise, inner ones clockwise, each starting
/// at its westernmost point (southernmost of these). Cost: O(n log n) a candidate, where few segments share their range
/// of longitudes; parallel over candidates.
AssembledAreas assemble_areas(const Elements& elements, int threads, Report& report);

}  // namespace citykiln::source
