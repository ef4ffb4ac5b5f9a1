// What an OpenStreetMap extract holds, read once: elements with their tags, and areas already assembled. Plain data,
// sorted, no geometry yet.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/contract/stable_id.h"

namespace citykiln::source {

/// A place as OSM stores it: units of 1e-7 degrees on WGS84.
struct Location {
  std::int32_t lon_e7 = 0, lat_e7 = 0;
  auto operator<=>(const Location&) const = default;
  double lon_deg() const { return lon_e7 * 1e-7; }
  double lat_deg() const { return lat_e7 * 1e-7; }
};

/// Degrees on WGS84.
struct LonLatBox {
  double west = 0, south = 0, east = 0, north = 0;
  bool operator==(const LonLatBox&) const = default;
};

/// A run of a flat vector of OsmData.
struct Range {
  std::uint32_t first = 0, count = 0;
};

/// Indices into OsmData::strings.
struct Tag {
  std::uint32_t key = 0, value = 0;
};

struct NodeRef {
  std::int64_t id = 0;
  Location at;
};

/// A node that carries tags.
struct Node {
  std::int64_t id = 0;
  Location at;
  Range tags;
};

/// A way with at least two nodes that have a place. Missing nodes are left out and diagnosed.
struct Way {
  std::int64_t id = 0;
  Range nodes;  ///< Into OsmData::way_nodes.
  Range tags;
};

/// One ring of an area. Outer rings run counter-clockwise, inner ones clockwise, in longitude and latitude; the last
/// point is not repeated.
struct AreaRing {
  Range points;            ///< Into OsmData::ring_points.
  std::uint32_t part = 0;  ///< Which polygon of the multipolygon, from 0; its outer ring comes first, its holes follow.
  bool is_outer = true;
};

/// A closed way or a multipolygon or boundary relation, assembled by libosmium: rings are simple and do not cross each
/// other.
struct Area {
  OsmId from;
  Range rings;  ///< Into OsmData::rings.
  Range tags;
};

/// A relation that is not an area, with its members in order. Members may be absent from the extract.
struct Relation {
  std::int64_t id = 0;
  Range members;  ///< Into OsmData::members.
  Range tags;
};

struct Member {
  OsmId object;
  std::uint32_t role = 0;  ///< Into OsmData::strings.
};

/// An extract. Nodes, ways, areas and relations are each sorted by id, whatever the order of the file.
struct OsmData {
  std::vector<std::string> strings;  ///< Every key, value and role once, sorted.
  std::vector<Tag> tags;             ///< Per element sorted by key.
  std::vector<Node> nodes;           ///< Tagged nodes only; the others live in way_nodes.
  std::vector<Way> ways;
  std::vector<NodeRef> way_nodes;
  std::vector<Area>
      areas;  ///< Sorted by `from`. A closed way may be here and in `ways`: tags decide which one is meant.
  std::vector<AreaRing> rings;
  std::vector<Location> ring_points;
  std::vector<Relation> relations;  ///< All with tags, also those that are in `areas`.
  std::vector<Member> members;
  std::optional<LonLatBox> header_box;  ///< As the file's header says.
  LonLatBox node_box;                   ///< Of all nodes in the file; zeros if there are none.
  std::string file_name;                ///< Without folders.

  std::span<const Tag> tags_of(Range r) const { return std::span(tags).subspan(r.first, r.count); }
  std::span<const NodeRef> nodes_of(const Way& w) const {
    return std::span(way_nodes).subspan(w.nodes.first, w.nodes.count);
  }
  std::span<const AreaRing> rings_of(const Area& a) const {
    return std::span(rings).subspan(a.rings.first, a.rings.count);
  }
  std::span<const Location> points_of(const AreaRing& r) const {
    return std::span(ring_points).subspan(r.points.first, r.points.count);
  }
  /// The value of `key`, or "" where the element does not carry it. O(tags of the element).
  std::string_view value_of(Range element_tags, std::string_view key) const;
};

}  // namespace citykiln::source
