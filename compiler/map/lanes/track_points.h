// Reads marked nodes of roads and rails: crossings, signals, signs, turning circles, level crossings.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/map/features.h"
#include "compiler/map/tags/read_context.h"

namespace citykiln::map {

/// A mark of a node, such as a crossing; a node may have several.
struct NodeMark {
  std::int64_t node_id = 0;
  TrackPointKind kind{};
  std::int8_t facing = 0;   ///< 1 for traffic along the way, -1 against it, 0 for both or unknown.
  std::uint8_t traits = 0;  ///< Bits of CrossingTrait: what tags say of a crossing.
  auto operator<=>(const NodeMark&) const = default;
};

/// Returns all marks of the extract, sorted.
///
/// A crossing is read from crossing=*, crossing_ref=* and crossing:markings=*. Values for crossings without paint
/// (unmarked, informal) are kPlainCrossing, "no" gives no mark; zebra, ladder and uncontrolled are kZebra; all others
/// are kCrossing. Its traits are those of its own tags kerb=*, tactile_paving=* and crossing:island=*, else those of
/// kerbs mapped as the next nodes of a path across it: if these differ, the lowest kerb, and slabs if any has them. A
/// node that a railway and a highway share on the ground is a level crossing, tagged or not. Nothing is diagnosed.
/// O(tags of nodes + n log n marks).
///
/// Source: wiki.openstreetmap.org, Tag:highway=crossing, Key:crossing, Key:crossing:markings, Key:direction.
std::vector<NodeMark> node_marks(const ReadContext& context);

/// Returns the marks on a way, sorted, without duplicates, with the vertices of their nodes. The last vertex of a
/// closed way has none, as it repeats the first. O(nodes of the way × log marks).
std::vector<TrackPoint> points_of(const ReadContext& context, const source::Way& way, const LocatedLine& line,
                                  const std::vector<NodeMark>& marks);

}  // namespace citykiln::map
