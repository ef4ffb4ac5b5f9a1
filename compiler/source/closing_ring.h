// Closing rings: the ways that close_cut_areas.h adds to close an area along the box of its map. The files of the map's
// regions contain them, so that a region does not decide again.
#pragma once

#include <cstdint>
#include <osmium/osm/relation.hpp>
#include <osmium/osm/way.hpp>

namespace citykiln::source {

/// Closing rings have ids from here on. The ids of OSM are far smaller.
inline constexpr std::int64_t kFirstClosingRing = std::int64_t{1} << 62;

/// The generator in the header of the files of regions. Areas in such files are not closed again.
inline constexpr const char* kGeneratorOfRegions = "citykiln";

/// True for a closing ring, which is no element of OSM.
inline bool is_closing_ring(const osmium::Way& way) { return way.id() >= kFirstClosingRing; }

/// True for a member that is a closing ring. An area with such members consists of them alone.
inline bool is_closing_ring(const osmium::RelationMember& member) {
  return member.type() == osmium::item_type::way && member.ref() >= kFirstClosingRing;
}

/// True if the area was closed along the box of its map.
inline bool has_closing_rings(const osmium::Relation& relation) {
  for (const osmium::RelationMember& member : relation.members())
    if (is_closing_ring(member)) return true;
  return false;
}

}  // namespace citykiln::source
