// Closes areas of which an extract has only a part along the box in the header of the map.
//
// The decision is made once, over the whole map: read_osm() makes it when it reads a map, and cut_extract() for the
// files of regions. It is stored as ways and members (closing_ring.h), so that both give the same areas.
#pragma once

#include <cstdint>
#include <osmium/memory/buffer.hpp>
#include <span>
#include <vector>

#include "compiler/source/area_evidence.h"
#include "compiler/source/close_along_box.h"
#include "compiler/source/order_elements.h"

namespace citykiln::source {

/// A multipolygon of which ways are missing, and whose lines there lead from side to side of the box.
struct CutArea {
  const osmium::Relation* relation = nullptr;
  CutKind kind = CutKind::kCover;
  CutLines lines;
  PartsOfBox parts;
  LocationBox near;  ///< Ways outside have no vote.
  PartVotes votes;   ///< The votes of other ways.
};

/// Returns the area if it can be closed: a multipolygon of a kind that covers ground (cut_kind()), with members that
/// are there and members that are not, and lines that end at the box (cut_at_box()).
/// @param ways  For each member of the relation its way with locations, or null.
std::optional<CutArea> cut_area_of(const osmium::Relation& relation, std::span<const osmium::Way* const> ways,
                                   const LocationBox& box);

/// Counts the votes of a way whose nodes near the area, without those of its outline, are all in one part of the box.
void add_evidence(const osmium::Way& way, CutArea& area);

/// Appends a copy of the relation with the rings as further members, and the rings, whose ids count from `next_ring`.
/// False, and nothing is appended, if the votes do not say clearly where the area is.
bool add_closed(const CutArea& area, std::int64_t& next_ring, osmium::memory::Buffer& buffer);

/// Closes all areas that can be closed. Elements refer to the copies afterwards, which are in a buffer that is added.
/// The evidence is that of all ways with tags; the order of members and the directions of ways do not matter. O(n) in
/// nodes if no area is cut; else each cut area takes the time of the nodes near it.
/// @param elements  Ways with the locations of their nodes.
void close_cut_areas(Elements& elements, const LonLatBox& box, std::vector<osmium::memory::Buffer>& buffers);

}  // namespace citykiln::source
