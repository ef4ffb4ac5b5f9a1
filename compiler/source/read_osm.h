// Reads OpenStreetMap extracts: .osm, .osm.gz, .osm.bz2, .osm.pbf. Elements may be in any order.
#pragma once

#include <string>

#include "compiler/contract/findings/report.h"
#include "compiler/contract/result.h"
#include "compiler/source/osm_data.h"
#include "compiler/source/owns_place.h"

namespace citykiln::source {

/// Reads an extract with libosmium and assembles its areas.
///
/// Guarantees: the result does not depend on the order of elements in the file. If an element occurs several times, its
/// highest version is used. If ways hold the locations of their nodes (LocationsOnWays), the nodes need not be in the
/// file, and only ways can be diagnosed as missing members. Missing nodes and members, deleted elements and broken
/// areas are diagnosed. Areas of which members are missing are closed along the box in the file's header, where that is
/// possible without doubt (close_cut_areas.h). Ledger accounts "source/node", "source/way", "source/area" and
/// "source/relation". Errors: a file that is missing, empty, cut off, malformed, or not of the format of its name.
/// Cost: about three times that of decoding the file.
/// @param owns  If not empty, the report covers only the elements whose place it accepts (read_osm.cpp).
Result<OsmData> read_osm(const std::string& path, int threads, Report& report, const OwnsPlace& owns = {});

}  // namespace citykiln::source
