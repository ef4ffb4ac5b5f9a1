// Old-style multipolygons: until 2017 the tags of a multipolygon could be on its outer ways, and some extracts still
// have such relations.
#pragma once

#include "compiler/contract/report.h"
#include "compiler/source/osm_data.h"

namespace citykiln::source {

/// Gives each multipolygon relation without descriptive tags the tags that all its outer ways share. Removes areas of
/// closed ways that repeat a multipolygon's area (as its outer ring without own tags, or as its inner ring with the
/// same tags) from data.areas and counts them as merged in the account "source/area".
/// @param data  Tagged areas, ways and relations, all sorted.
void merge_old_style_multipolygons(OsmData& data, Report& report);

}  // namespace citykiln::source
