// Pavements along a street, from its tags.
#pragma once

#include "compiler/map/osm_reader.h"

namespace citykiln::map {

/// Widths beyond the kerbs, seen along the way; 0 where there is none. Multiples of 1/4 m.
struct Pavements {
  double left_m = 0, right_m = 0;
};

/// Reads sidewalk=*, sidewalk:left|right|both=* and their :width. Pavements that are ways of their own (separate) are
/// none of the street's; a street without tags has none. A width that cannot be read is diagnosed kBadTagValue.
Pavements pavements_of(const Reading& reading, OsmId id, source::Range tags);

}  // namespace citykiln::map
