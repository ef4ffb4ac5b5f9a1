// The contents of an OpenStreetMap extract: tagged elements and assembled areas as sorted, flat vectors.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/contract/stable_id.h"

namespace citykiln::source {

/// A location as stored by OSM, in units of 1e-7 degrees on WGS84. In a map across 180° longitudes go on to 200°
/// (across_180.h).
struct Location {
  std::int32_t lon_e7 = 0, lat_e7 = 0;
  auto operator<=>(const Location&) const = default;
  double lon_deg() const { return lon_e7 * 1e-7; }
  double lat_deg() const { return lat_e7 * 1e-7; }
};

/// A box in degrees on WGS84.
struct LonLatBox {
  double west = 0, south = 0, east = 0, north = 0;
  bool operator==(const LonLatBox&) const = default;
};

/// A range of elements in one of the flat vectors of OsmData. Ranges named `tags` are into OsmData::tags.
struct Range {
  std::uint32_t first = 0, count = 0;
};

/// A tag, as two indices into OsmData::strings.
struct Tag {
  std::uint32_t key = 0, value = 0;
};

/// A node of a way.
struct NodeRef {
  std::int64_t id = 0;
  Location at;
};

/// A tagged node.
struct Node {
  std::int64_t id = 0;
  Location at;
  Range tags;
};

/// A way with at least two nodes. Nodes that are missing from the extract are left out and diagnosed.
struct Way {
  std::int64_t id = 0;
  Range nodes;  ///< Into OsmData::way_nodes.
  Range tags;
};

/// One ring of an area. Outer rings run counter-clockwise, inner ones clockwise, in longitude and latitude; the first
/// point is not repeated at the end.
struct AreaRing {
  Range points;            ///< Into OsmData::ring_points.
  std::uint32_t part = 0;  ///< Index of its polygon in a multipolygon; each outer ring is followed by its holes.
  bool is_outer = true;
};

/// An area assembled from a closed way, a multipolygon or a boundary relation. Its rings are simple and do not cross.
struct Area {
  OsmId from;
  Range rings;  ///< Into OsmData::rings.
  Range tags;
};

/// A relation with tags. Its members are in the order of the file and may be missing from the extract.
struct Relation {
  std::int64_t id = 0;
  Range members;  ///< Into OsmData::members.
  Range tags;
};

/// A member of a relation.
struct Member {
  OsmId object;
  std::uint32_t role = 0;  ///< Into OsmData::strings.
};

/// The contents of an extract. Nodes, ways, areas and relations are each sorted by id, in any order of the file.
struct OsmData {
  std::vector<std::string> strings;  ///< Every key, value and role once, sorted.
  std::vector<Tag> tags;             ///< Sorted by key within each element.
  std::vector<Node> nodes;           ///< Tagged nodes; nodes of ways are in way_nodes.
  std::vector<Way> ways;
  std::vector<NodeRef> way_nodes;
  std::vector<Area> areas;  ///< Sorted by `from`. A closed way can be both an area and a way; its tags decide.
  std::vector<AreaRing> rings;
  std::vector<Location> ring_points;
  std::vector<Relation> relations;  ///< All relations with tags, including those in `areas`.
  std::vector<Member> members;
  std::optional<LonLatBox> header_box;  ///< The bounds in the file's header.
  LonLatBox node_box;                   ///< The box of all nodes in the file; zeros if there are none.
  std::string file_name;                ///< The name of the file without its folder.

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
  /// Returns the value of `key`, or "" if the element has no such tag. O(tags of the element).
  std::string_view value_of(Range element_tags, std::string_view key) const;
};

}  // namespace citykiln::source
