// Reads OpenStreetMap extracts: .osm, .osm.gz, .osm.bz2, .osm.pbf, sorted or not.
#pragma once

#include <string>

#include "compiler/contract/report.h"
#include "compiler/contract/result.h"
#include "compiler/source/osm_data.h"

namespace citykiln::source {

/// Reads an extract with libosmium and assembles its areas.
///
/// Guarantees: the product does not depend on the order of elements in the file; of elements that occur twice the
/// highest version stays. Missing nodes and members, deleted elements and rings that cannot be assembled are diagnosed;
/// ledger "source/node", "source/way", "source/area", "source/relation". Errors: a file that is missing, empty,
/// truncated, malformed, or of another kind than its name says. Cost: about three decodings of the file on its own;
/// unsorted files are sorted in memory (stated in README).
Result<OsmData> read_osm(const std::string& path, int threads, Report& report);

}  // namespace citykiln::source
