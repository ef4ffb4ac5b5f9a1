// Identity is descent: an object is named by what it comes from, never by a counter, a pointer or an order.
#pragma once

#include <compare>
#include <cstdint>
#include <string>

namespace citykiln {

enum class OsmType : std::uint8_t { kNone, kNode, kWay, kRelation };

/// An element of the OSM file, the root of every descent. `id` may be negative (editors' unsaved elements).
struct OsmId {
  OsmType type = OsmType::kNone;
  std::int64_t id = 0;
  auto operator<=>(const OsmId&) const = default;
};

/// "n123", "w123", "r123"; "-" for none.
std::string to_string(OsmId id);

/// One object made of an OSM element: the element and which of its pieces (polygon of a multipolygon, segment of a
/// way). Ordinals are given before any clipping, so a clipped piece is named by its uncut parent.
struct ObjectId {
  OsmId osm;
  std::uint32_t part = 0;
  auto operator<=>(const ObjectId&) const = default;
};

/// 64 well-mixed bits that name an object. Equal descent, equal id; different descent, equal id with chance 2^-64.
enum class StableId : std::uint64_t {};

/// The id of a root.
StableId stable_id(ObjectId object);

/// The id of what descends from `parent` in the role `role` (a short constant, e.g. "tree"), the `ordinal`-th of its
/// kind.
StableId stable_id(StableId parent, const char* role, std::uint64_t ordinal);

}  // namespace citykiln
