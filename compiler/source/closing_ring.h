// The ways that close an area along the box of its map (close_cut_areas.h). They carry the decision from the whole map
// to the files of its regions.
#pragma once

#include <cstdint>
#include <osmium/osm/relation.hpp>
#include <osmium/osm/way.hpp>

namespace citykiln::source {

/// Ids from here on are those of closing rings; OSM is far from them.
inline constexpr std::int64_t kFirstClosingRing = std::int64_t{1} << 62;

/// The generator in the header of the files of regions, whose areas are not closed again.
inline constexpr const char* kGeneratorOfRegions = "citykiln";

/// True for a ring of a closed area. Such a way is no element of the map.
inline bool is_closing_ring(const osmium::Way& way) { return way.id() >= kFirstClosingRing; }

/// True for a member that is a ring of a closed area. The area then consists of these members alone.
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
