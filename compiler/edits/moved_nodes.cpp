#include "compiler/edits/moved_nodes.h"

#include <algorithm>
#include <optional>
#include <unordered_map>

#include "compiler/edits/offsets.h"

namespace citykiln::edits {
namespace {

using source::OsmData;
using Places = std::map<std::int64_t, source::Location>;

void add_nodes_of_way(const OsmData& map, const source::Way& way, Places& places) {
  for (const source::NodeRef& node : map.nodes_of(way)) places.emplace(node.id, node.at);
}

void add_nodes_of_relation(const OsmData& map, const source::Relation& relation, Places& places) {
  for (std::uint32_t i = 0; i < relation.members.count; ++i) {
    const OsmId member = map.members[relation.members.first + i].object;
    if (member.type == OsmType::kNode) {
      const auto node = std::ranges::lower_bound(map.nodes, member.id, {}, &source::Node::id);
      if (node != map.nodes.end() && node->id == member.id) places.emplace(node->id, node->at);
    } else if (member.type == OsmType::kWay) {
      const auto way = std::ranges::lower_bound(map.ways, member.id, {}, &source::Way::id);
      if (way != map.ways.end() && way->id == member.id) add_nodes_of_way(map, *way, places);
    }
  }
}

// The place of a node without tags, in the first way that has it. O(nodes).
std::optional<source::Location> place_in_ways(const OsmData& map, std::int64_t node) {
  const auto found = std::ranges::find(map.way_nodes, node, &source::NodeRef::id);
  return found == map.way_nodes.end() ? std::nullopt : std::optional(found->at);
}

void add_nodes_of_match(const OsmData& map, const Match& match, Places& places) {
  if (match.id.type == OsmType::kWay) {
    add_nodes_of_way(map, map.ways[match.index], places);
  } else if (match.id.type == OsmType::kRelation) {
    add_nodes_of_relation(map, map.relations[match.index], places);
  } else if (match.index != kNoTags) {
    places.emplace(match.id.id, map.nodes[match.index].at);
  } else if (const auto at = place_in_ways(map, match.id.id)) {
    places.emplace(match.id.id, *at);
  }
}

void move_by(const Changes& changes, const Places& places, NodeMoves& moves) {
  for (const auto& [node, at] : places) {
    NodeMove& move = moves.emplace(node, NodeMove{at, at}).first->second;
    if (changes.moved_m) move.to = moved(move.to, *changes.moved_m);
    if (changes.placed) move.to = *changes.placed;
  }
}

}  // namespace

NodeMoves moved_nodes(const OsmData& map, const Edits& edits, std::span<const Match> matches) {
  std::map<std::uint32_t, Places> by_line;
  for (const Match& match : matches)
    for (const std::uint32_t line : match.lines)
      if (edits.lines[line].changes.changes_places()) add_nodes_of_match(map, match, by_line[line]);
  NodeMoves moves;
  for (const auto& [line, places] : by_line) move_by(edits.lines[line].changes, places, moves);
  return moves;
}

std::vector<std::int64_t> move_nodes(OsmData& map, const NodeMoves& moves) {
  std::vector<std::int64_t> ways;
  if (moves.empty()) return ways;
  // looked up for each node of the map
  std::unordered_map<std::int64_t, source::Location> to;
  for (const auto& [node, move] : moves) to.emplace(node, move.to);
  for (source::Node& node : map.nodes)
    if (const auto found = to.find(node.id); found != to.end()) node.at = found->second;
  for (const source::Way& way : map.ways) {
    bool has_moved = false;
    for (std::uint32_t i = way.nodes.first; i < way.nodes.first + way.nodes.count; ++i)
      if (const auto found = to.find(map.way_nodes[i].id); found != to.end())
        map.way_nodes[i].at = found->second, has_moved = true;
    if (has_moved) ways.push_back(way.id);
  }
  return ways;
}

}  // namespace citykiln::edits
