// Reads from tags which areas can be closed along the box of a map, and what other ways say about where they are.
#pragma once

#include <cstdint>
#include <optional>
#include <osmium/osm/tag.hpp>

namespace citykiln::source {

/// A kind of areas for which the same ways speak.
enum class CutKind : std::uint8_t { kRiver, kStanding, kBuiltUp, kCover, kPark };

/// Returns the kind of a multipolygon that covers ground: water, woods, land use, parks; nothing for others, such as
/// buildings and boundaries.
std::optional<CutKind> cut_kind(const osmium::TagList& tags);

/// Returns how many votes a way with these tags has for lying inside an area of the kind; below 0 for lying outside it,
/// 0 if it says nothing, as bridges and tunnels do. By area_evidence.inc.
int evidence_of(const osmium::TagList& tags, CutKind kind);

}  // namespace citykiln::source
