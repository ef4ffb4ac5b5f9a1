// Reads OpenStreetMap extracts: .osm, .osm.gz, .osm.bz2, .osm.pbf, sorted or not.
#pragma once

#include <string>

#include "compiler/contract/report.h"
#include "compiler/contract/result.h"
#include "compiler/source/osm_data.h"
#include "compiler/source/owns_place.h"

namespace citykiln::source {

/// Reads an extract with libosmium and assembles its areas.
///
/// Guarantees: the result does not depend on the order of elements in the file; of duplicate elements the highest
/// version is kept; ways that state the places of their nodes (LocationsOnWays) need no nodes, and only ways count as
/// missing members there. Missing nodes and members, deleted elements and broken areas are diagnosed; ledger accounts
/// "source/node", "source/way", "source/area" and "source/relation". Errors: a file that is missing, empty, truncated,
/// malformed, or not of the format of its name. Cost: about three times that of decoding the file; unsorted files are
/// sorted in memory.
/// @param owns  If not empty, the report is limited to the elements whose place it owns (owned_elements.h).
Result<OsmData> read_osm(const std::string& path, int threads, Report& report, const OwnsPlace& owns = {});

}  // namespace citykiln::source
