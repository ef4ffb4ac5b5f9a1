// Ids that are derived from the element of the map from which an object is made. They do not depend on counters,
// pointers or the order of work.
#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <string_view>

namespace citykiln {

/// The type of an OSM element, or kLot: a lot that citykiln fills where the map has no building (lots/fill_lots.h).
enum class OsmType : std::uint8_t { kNone, kNode, kWay, kRelation, kLot };
inline constexpr int kOsmTypeCount = 5;

/// Returns "none", "node", "way", "relation" or "lot".
std::string_view name_of(OsmType type);

/// An element of the OSM file, or a filled lot. `id` is negative for elements that an editor has not uploaded.
struct OsmId {
  OsmType type = OsmType::kNone;
  std::int64_t id = 0;
  auto operator<=>(const OsmId&) const = default;
};

/// Returns "n123", "w123", "r123" or "l123" for a node, way, relation or lot; "-" for none.
std::string to_string(OsmId id);

/// An object made from an OSM element: the element, and the index of the piece (polygon of a multipolygon, segment of a
/// way). Pieces are numbered before clipping, so a clipped piece keeps its id.
struct ObjectId {
  OsmId osm;
  std::uint32_t part = 0;
  auto operator<=>(const ObjectId&) const = default;
};

/// A hash of 64 bits that names an object. Objects of equal origin have equal ids; others are equal with probability
/// 2^-64.
enum class StableId : std::uint64_t {};

/// Returns the id of an object made from the map.
StableId stable_id(ObjectId object);

/// Returns the id of the `ordinal`-th object that is made from `parent` in a role (a short constant such as "tree").
StableId stable_id(StableId parent, const char* role, std::uint64_t ordinal);

}  // namespace citykiln
