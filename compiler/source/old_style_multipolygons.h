// Until 2017 a multipolygon's tags could stand on its outer ways. Extracts of those years still have them, and so have
// others here and there.
#pragma once

#include "compiler/contract/report.h"
#include "compiler/source/osm_data.h"

namespace citykiln::source {

/// Gives a multipolygon relation without describing tags the tags that all its outer ways have in common. A closed way
/// whose area merely repeats a multipolygon's, as its outer ring without its own tags or as its inner ring with the
/// same tags, is taken out of data.areas and counted as merged in the account "source/area".
/// @param data  With areas, their tags, ways and relations, all sorted.
void merge_old_style_multipolygons(OsmData& data, Report& report);

}  // namespace citykiln::source
