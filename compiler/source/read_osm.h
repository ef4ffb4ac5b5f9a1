// Reads OpenStreetMap extracts: .osm, .osm.gz, .osm.bz2, .osm.pbf.
#pragma once

#include <string>

#include "compiler/contract/findings/report.h"
#include "compiler/contract/result.h"
#include "compiler/source/osm_data.h"
#include "compiler/source/owns_place.h"

namespace citykiln::source {

/// Returns the elements of an extract, decoded with libosmium, with its areas assembled.
///
/// - Elements may be in any order, and the result does not depend on it. If an element occurs several times, its
///   highest version is used.
/// - If ways hold the locations of their nodes (LocationsOnWays), the nodes need not be in the file, and only ways can
///   be diagnosed as missing members.
/// - Areas of which members are missing are closed along the box in the file's header, where that is possible without
///   doubt (close_cut_areas.h).
///
/// Diagnosed: missing nodes and members, deleted elements, broken areas. Ledger accounts "source/node", "source/way",
/// "source/area" and "source/relation". Errors: a file that is missing, empty, cut off, malformed, or not of the format
/// of its name; three ways or more of which none has a place, as in an answer of Overpass without nodes. Cost: about
/// three times that of decoding the file.
/// @param threads  At least 1; does not change the result.
/// @param owns     If not empty, report and ledger cover only the elements whose place it accepts. The place of a way
///                 is its first node with a location, that of a relation the place of its first member way that has
///                 one. The result has all elements.
Result<OsmData> read_osm(const std::string& path, int threads, Report& report, const OwnsPlace& owns = {});

}  // namespace citykiln::source
