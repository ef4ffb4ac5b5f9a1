// Decides from tags which incomplete areas can be closed along the box of a map (close_cut_areas.h), and which ways are
// evidence of where such an area lies.
#pragma once

#include <cstdint>
#include <optional>
#include <osmium/osm/tag.hpp>

namespace citykiln::source {

/// The kinds of areas that can be closed: rivers, standing water, built-up land, other land cover, parks. Each kind has
/// a column of votes in area_evidence.inc.
enum class CutAreaKind : std::uint8_t { kRiver, kStanding, kBuiltUp, kCover, kPark };

/// Returns the kind of a multipolygon of water, land cover, land use or park; nothing for other elements, such as
/// buildings and boundaries.
std::optional<CutAreaKind> cut_area_kind(const osmium::TagList& tags);

/// Returns the votes of a way with these tags for lying inside an area of the kind: below 0 if it lies outside such
/// areas, 0 if it is no evidence, as bridges and tunnels are. The votes are those of area_evidence.inc.
int votes_of(const osmium::TagList& tags, CutAreaKind kind);

}  // namespace citykiln::source
