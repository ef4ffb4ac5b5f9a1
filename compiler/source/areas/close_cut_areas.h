// Closes areas that an extract has cut, along the box in the header of the map.
//
// The decision is made once for the whole map: by read_osm() when it reads a map, and by cut_extract() when it writes
// the files of regions. It is stored as added ways and members (closing_ring.h), so that both give the same areas.
#pragma once

#include <cstdint>
#include <optional>
#include <osmium/memory/buffer.hpp>
#include <osmium/osm/tag.hpp>
#include <span>
#include <vector>

#include "compiler/source/areas/close_along_box.h"
#include "compiler/source/order_elements.h"

namespace citykiln::source {

// Decides from tags which incomplete areas can be closed along the box of a map (close_cut_areas.h), and which ways are
// evidence of where such an area lies.

/// The kinds of areas that can be closed: rivers, standing water, built-up land, other land cover, parks. Each kind has
/// a column of votes in area_evidence.inc.
enum class CutAreaKind : std::uint8_t { kRiver, kStanding, kBuiltUp, kCover, kPark };

/// Returns the kind of a multipolygon of water, land cover, land use or park; nothing for other elements, such as
/// buildings and boundaries.
std::optional<CutAreaKind> cut_area_kind(const osmium::TagList& tags);

/// Returns the votes of a way with these tags for lying inside an area of the kind: below 0 if it lies outside such
/// areas, 0 if it is no evidence, as bridges and tunnels are. The votes are those of area_evidence.inc.
int votes_of(const osmium::TagList& tags, CutAreaKind kind);

/// A multipolygon that is cut, whose remaining lines lead from side to side of the box.
struct CutArea {
  const osmium::Relation* relation = nullptr;
  CutAreaKind kind = CutAreaKind::kCover;
  CutLines lines;
  PartsOfBox parts;
  LocationBox near;  ///< The lines' box, widened by about 500 m. Ways outside have no vote.
  PartVotes votes;   ///< The votes of other ways, and of the shape of a river.
};

/// Returns the area if it may be closed, else nothing: a multipolygon with a cut_area_kind(), of which some member ways
/// are in the map, and whose lines end at the box (cut_at_box()): because other members are missing, or because the
/// ways themselves are cut.
/// @param ways  For each member of the relation its way with locations, or null.
std::optional<CutArea> cut_area_of(const osmium::Relation& relation, std::span<const osmium::Way* const> ways,
                                   const LocationBox& box);

/// Adds the votes of a way (votes_of()) if its nodes inside area.near, without those of the outline, are all in one
/// part of the box.
void add_evidence(const osmium::Way& way, CutArea& area);

/// Appends to `buffer` a copy of the relation with the closed rings as further members, and the rings as ways. Their
/// ids count up from `next_ring`. Returns false and appends nothing if the votes are not clear (close_along_box()).
bool add_closed(const CutArea& area, std::int64_t& next_ring, osmium::memory::Buffer& buffer);

/// Closes all areas that can be closed. In `elements`, closed copies replace the relations, and the rings are added.
/// They live in a buffer that is appended to `buffers`. Does nothing if location_box(box) is empty.
///
/// All ways with tags are evidence; the order of members and the directions of ways do not matter. O(n) in members if
/// no area is cut; else each cut area visits the nodes of all ways with tags.
/// @param elements  Ways with the locations of their nodes.
void close_cut_areas(Elements& elements, const LonLatBox& box, std::vector<osmium::memory::Buffer>& buffers);

}  // namespace citykiln::source
