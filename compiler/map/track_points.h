// What the nodes of roads and rails say: crossings, signals, signs, turning circles, level crossings.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/map/features.h"
#include "compiler/map/read_context.h"

namespace citykiln::map {

/// A node that says something; one that says several things is several marks.
struct NodeMark {
  std::int64_t node_id = 0;
  TrackPointKind kind{};
  std::int8_t facing = 0;
  auto operator<=>(const NodeMark&) const = default;
};

/// All marks of the extract, sorted. What crossing=*, crossing_ref=* and crossing:markings=* say of a crossing: nothing
/// painted (unmarked, informal, no) is no mark; zebra, ladder and uncontrolled are a zebra; everything else, known or
/// not, is kCrossing. Not diagnosed. O(tags of nodes + n log n marks).
///
/// Source: wiki.openstreetmap.org, Tag:highway=crossing, Key:crossing, Key:crossing:markings, Key:direction.
std::vector<NodeMark> node_marks(const ReadContext& context);

/// The marks on a way, sorted, each once: at the vertex its node came to lie at, also where several nodes share one.
/// The last vertex of a closed way says nothing that the first does not. O(nodes of the way × log marks).
std::vector<TrackPoint> points_of(const ReadContext& context, const source::Way& way, const LocatedLine& line,
                                  const std::vector<NodeMark>& marks);

}  // namespace citykiln::map
