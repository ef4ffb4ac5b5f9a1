// Ids by descent: an object is named by its origin in the map, never by a counter, a pointer or an order.
#pragma once

#include <compare>
#include <cstdint>
#include <string>

namespace citykiln {

enum class OsmType : std::uint8_t { kNone, kNode, kWay, kRelation };

/// An element of the OSM file. `id` may be negative (unsaved elements of editors).
struct OsmId {
  OsmType type = OsmType::kNone;
  std::int64_t id = 0;
  auto operator<=>(const OsmId&) const = default;
};

/// "n123", "w123", "r123"; "-" for none.
std::string to_string(OsmId id);

/// An object made of an OSM element: the element, and the index of the piece (polygon of a multipolygon, segment of a
/// way). Pieces are numbered before clipping, so a clipped piece has the id of its whole.
struct ObjectId {
  OsmId osm;
  std::uint32_t part = 0;
  auto operator<=>(const ObjectId&) const = default;
};

/// 64 well-mixed bits that name an object. Equal for equal descent; else equal with probability 2^-64.
enum class StableId : std::uint64_t {};

/// The id of an object of the map.
StableId stable_id(ObjectId object);

/// The id of the `ordinal`-th descendant of `parent` in a role (a short constant such as "tree").
StableId stable_id(StableId parent, const char* role, std::uint64_t ordinal);

}  // namespace citykiln
