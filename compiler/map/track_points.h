// Reads the nodes of roads and rails: crossings, signals, signs, turning circles, level crossings.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/map/features.h"
#include "compiler/map/read_context.h"

namespace citykiln::map {

/// A mark of a node; a node may have several.
struct NodeMark {
  std::int64_t node_id = 0;
  TrackPointKind kind{};
  std::int8_t facing = 0;
  auto operator<=>(const NodeMark&) const = default;
};

/// Returns all marks of the extract, sorted.
///
/// Crossings by crossing=*, crossing_ref=* and crossing:markings=*: without paint (unmarked, informal, no) there is no
/// mark; zebra, ladder and uncontrolled are kZebra; all other values are kCrossing. Not diagnosed. O(tags of nodes + n
/// log n marks).
///
/// Source: wiki.openstreetmap.org, Tag:highway=crossing, Key:crossing, Key:crossing:markings, Key:direction.
std::vector<NodeMark> node_marks(const ReadContext& context);

/// Returns the marks on a way, sorted, without duplicates, at the vertices of their nodes. The last vertex of a closed
/// way repeats the first and has none. O(nodes of the way × log marks).
std::vector<TrackPoint> points_of(const ReadContext& context, const source::Way& way, const LocatedLine& line,
                                  const std::vector<NodeMark>& marks);

}  // namespace citykiln::map
