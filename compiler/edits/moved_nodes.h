// Finds the new places of nodes that edits move.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "compiler/edits/edit.h"
#include "compiler/edits/find_matches.h"
#include "compiler/source/osm_data.h"

namespace citykiln::edits {

/// The place of a node before and after.
struct NodeMove {
  source::Location from, to;
};

/// The moved nodes, by id.
using NodeMoves = std::map<std::int64_t, NodeMove>;

/// Returns the nodes that lines move: matched nodes, all nodes of matched ways, and of matched relations the nodes of
/// member ways and the member nodes that have tags. Members that are relations are skipped. A line moves a node once,
/// even if several elements that the line matches share it. Offsets of several lines add up; a line that places a node
/// replaces the earlier ones.
NodeMoves moved_nodes(const source::OsmData& map, const Edits& edits, std::span<const Match> matches);

/// Moves the nodes of a map and of its ways, and returns the ids of the ways that have such nodes, sorted. O(nodes).
std::vector<std::int64_t> move_nodes(source::OsmData& map, const NodeMoves& moves);

}  // namespace citykiln::edits
