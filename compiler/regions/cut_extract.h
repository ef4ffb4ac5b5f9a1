// Cuts an extract into one file for each region, in four passes over the file:
//
//     1. relations        which ways are members of areas
//     2. nodes and ways   places of nodes, in an index on disk; elements near a region go to its spool
//     3. relations        areas go to the regions that their box touches
//     4. ways             the members of these areas follow them
//
// Then each spool is sorted and written as a file.
#pragma once

#include <string>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/contract/result.h"
#include "compiler/map/plane.h"
#include "compiler/regions/region.h"
#include "compiler/regions/region_file.h"
#include "compiler/source/osm_data.h"

namespace citykiln::regions {

/// What is cut, and where the files go.
struct Cut {
  std::string map_path;
  std::string folder;        ///< Exists. Gets X_Y.osm.pbf for each region, and survey.osm.pbf.
  source::LonLatBox extent;  ///< Stated in the header of each file.
  int threads = 0;
};

/// The files of all regions, in the order of regions_of(), and that of the survey.
struct CutFiles {
  std::vector<RegionFile> regions;
  RegionFile survey;
  Report report;  ///< The accounts source/node, source/way and source/relation of the whole extract.
};

/// Where a place lies, in the plane. Places farther than 1 degree outside the extent are brought to that distance,
/// where the projection is defined.
Vec2 place_near(const map::Plane& plane, const source::LonLatBox& extent, double lon, double lat);

/// Cuts an extract. A region's file holds, sorted and without metadata:
/// - nodes with tags within the region widened by its halo;
/// - ways, whole, of which a segment's box touches that, or, for ways that may become areas, their own box;
/// - multipolygons and boundaries that may become areas and whose box touches that, with all their ways;
/// - all coastlines near the extent;
/// - each element of another region's file that it owns (owner_of() its place, which is that of its first node).
/// The survey's file holds waterways, coastlines and areas of water near the extent, whole. Nodes without tags are
/// left out: ways have their places (LocationsOnWays). Of duplicates the highest version is kept.
///
/// Guarantees: the same elements give the same bytes; a file is written only where its bytes change, so that its time
/// tells when it changed. Memory: 64 kB a region, 50 bytes for each way that is a member of an area, and the pages of
/// the index of places (16 bytes a node, in FOLDER/.cut) that the system keeps. Linear in the bytes of the extract.
/// Errors: a file that cannot be read; one whose ways come before its nodes; a folder that cannot be written.
Result<CutFiles> cut_extract(const Cut& cut, const map::Plane& plane, const RegionGrid& grid);

/// Ways that lie farther outside of the extent than this are in no file. Coasts are closed 256 m outside.
inline constexpr double kCoastMargin_m = 1024;

/// The box in an extract's header. Errors: those of read_osm(); a header without a box.
Result<source::LonLatBox> header_box_of(const std::string& map_path);

}  // namespace citykiln::regions
