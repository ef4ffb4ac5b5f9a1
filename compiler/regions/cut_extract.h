// Cuts an extract into one file per region, in four passes over the extract:
//
//     1. relations        finds the ways that are members of areas; again for areas that are members, if there are any
//     2. nodes and ways   stores places of nodes in an index on disk; copies elements near a region to its spool
//     3. relations        copies areas, and buildings of parts, to the spools of the regions that their box touches
//     4. ways             copies the members of these areas
//
// Two more passes over the ways close areas that the box of the map cuts (source/areas/close_cut_areas.h), if there are
// any. Then each spool is sorted and written as a file.
#pragma once

#include <string>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/contract/result.h"
#include "compiler/edits/edit.h"
#include "compiler/map/plane/plane.h"
#include "compiler/regions/region.h"
#include "compiler/regions/region_file.h"
#include "compiler/source/osm_data.h"

namespace citykiln::regions {

/// The arguments of cut_extract().
struct CutRequest {
  std::string map_path;
  std::string folder;        ///< Must exist. X_Y.osm.pbf is written for each region, and survey.osm.pbf.
  source::LonLatBox extent;  ///< The box in the header of each file.
  int threads = 0;
  /// Edits that are made when the files are read; null: none. The files have what they need for that.
  const edits::Edits* edits = nullptr;
};

/// Counts of the files that were written. `regions` has the order of regions_of(); `survey` is the file with coastlines
/// and waters of the whole extent.
struct CutFiles {
  std::vector<RegionFile> regions;
  RegionFile survey;
  std::vector<bool> edits_had_effect{};  ///< For each line of the edits: true if an element of the map fits it.
  Report report;  ///< The accounts source/node, source/way and source/relation of the whole extract.
};

/// Returns the plane coordinates of a place, in metres. A place more than 1 degree outside the extent is first moved to
/// that distance, where the projection is still defined.
Vec2 place_near(const map::Plane& plane, const source::LonLatBox& extent, double lon, double lat);

/// Cuts an extract. The file of a region holds these elements, sorted and without metadata. "Near" means touching the
/// square of the region widened by its halo (for_each_region_near()).
/// - nodes with tags near the region;
/// - whole ways with a segment whose box is near, or, if they may become areas, whose own box is near;
/// - multipolygons and boundaries that may become areas, and relations of type building, whose box is near, with all
///   their ways, and with the areas that are their members (islands) and the ways of these;
/// - the rings that close cut areas along the box in the header of the map, or along that of its nodes;
/// - all coastlines whose box touches the extent widened by kCoastMargin_m;
/// - each way and area that the region owns and that is in another region's file: owner_of() the way's first node, or
///   of the area's first member way.
/// With edits, an element whose tags a line changes counts as one that may become an area and water, and distances are
/// longer by edits::longest_move_m(): the halo of the grid has to be, too.
///
/// The file of the survey holds these coastlines, and whole waterways and areas of water whose box touches the same
/// box. Nodes without tags are left out, since ways hold the locations of their nodes (LocationsOnWays). If an element
/// occurs several times, its highest version is kept.
///
/// Guarantees: equal elements give equal bytes. A file is replaced only if its bytes change, so that its time says when
/// it last changed. Memory: 64 kB per region, 64 bytes per way that is a member of an area and 8 per file that it is
/// in, the elements of the largest file, and the pages of the index of places (16 bytes per node, in FOLDER/.cut) that
/// the system caches. Linear in the bytes of the extract.
/// Errors: a file that cannot be read, or whose ways come before its nodes; a folder that cannot be written.
Result<CutFiles> cut_extract(const CutRequest& cut, const map::Plane& plane, const RegionGrid& grid);

/// Coastlines and waters farther than this outside the extent are not in the file of the survey, in metres, nor are
/// such coastlines in the files of all regions. Coasts are closed 256 m outside the extent.
inline constexpr double kCoastMargin_m = 1024;

/// Returns the box in the header of an extract. Errors: those of read_osm(); a header without a box.
Result<source::LonLatBox> header_box_of(const std::string& map_path);

}  // namespace citykiln::regions
