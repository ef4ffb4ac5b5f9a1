#include "compiler/invent/town/streets/street_edges.h"

#include <algorithm>

#include "compiler/contract/disjoint_sets.h"

namespace citykiln::invent {
namespace {

// true if a chain goes on through a vertex: two segments of one street, both on a bridge or both not
bool goes_through(const StreetGraph& graph, std::uint32_t vertex) {
  const auto& at = graph.vertices()[vertex].segments;
  if (at.size() != 2) return false;
  const StreetSegment &s = graph.segments()[at[0]], &t = graph.segments()[at[1]];
  return s.street == t.street && s.is_bridge == t.is_bridge;
}

// the vertices from a vertex on, along a segment, up to where a chain ends
std::vector<std::uint32_t> chain_from(const StreetGraph& graph, std::uint32_t vertex, std::uint32_t segment,
                                      std::vector<char>& used) {
  std::vector<std::uint32_t> chain = {vertex};
  while (!used[segment]) {
    used[segment] = 1;
    chain.push_back(graph.other_end(segment, chain.back()));
    if (!goes_through(graph, chain.back())) break;
    const auto& at = graph.vertices()[chain.back()].segments;
    segment = at[0] == segment ? at[1] : at[0];
  }
  return chain;
}

// goes back along a segment's chain to where it begins; the segment there, and its vertex
std::pair<std::uint32_t, std::uint32_t> begin_of_chain(const StreetGraph& graph, std::uint32_t segment) {
  const std::uint32_t first = segment;
  std::uint32_t vertex = graph.segments()[segment].a;
  while (goes_through(graph, vertex)) {
    const auto& at = graph.vertices()[vertex].segments;
    const std::uint32_t next = at[0] == segment ? at[1] : at[0];
    if (next == first) break;
    segment = next;
    vertex = graph.other_end(segment, vertex);
  }
  return {segment, vertex};
}

/// Half segments: 2 s runs from a to b, 2 s + 1 back. The land to the left is theirs.
class BlockWalk {
 public:
  explicit BlockWalk(const StreetGraph& graph) : graph_(graph), block_of_(graph.segments().size() * 2, kNoBlock) {}

  StreetBlocks run() {
    StreetBlocks blocks;
    for (std::uint32_t half = 0; half < block_of_.size(); ++half)
      if (!graph_.segments()[half / 2].is_removed && block_of_[half] == kNoBlock) walk(half, blocks);
    return blocks;
  }

  std::uint32_t block_of(std::uint32_t from, std::uint32_t to) const {
    for (const std::uint32_t s : graph_.vertices()[from].segments)
      if (graph_.other_end(s, from) == to) return block_of_[half_from(s, from)];
    return kNoBlock;
  }

 private:
  std::uint32_t half_from(std::uint32_t segment, std::uint32_t vertex) const {
    return 2 * segment + (graph_.segments()[segment].a == vertex ? 0 : 1);
  }
  std::uint32_t end_of(std::uint32_t half) const {
    const StreetSegment& s = graph_.segments()[half / 2];
    return half % 2 ? s.a : s.b;
  }

  // the half segment that goes on with the same land to its left: the first clockwise from the way back
  std::uint32_t next_half(std::uint32_t half) const {
    const std::uint32_t at = end_of(half);
    const Vec2 back = graph_.direction_from(at, half / 2);
    std::uint32_t best = half ^ 1u;
    double least = 9;
    for (const std::uint32_t s : graph_.vertices()[at].segments) {
      if (s == half / 2) continue;
      const double turn = clockwise_turn(back, graph_.direction_from(at, s));
      if (turn < least) {
        least = turn;
        best = half_from(s, at);
      }
    }
    return best;
  }

  // a number that grows with the clockwise angle from a to b, 0 … 4
  static double clockwise_turn(Vec2 a, Vec2 b) {
    const double x = dot(a, b), y = -cross(a, b);
    return y >= 0 ? 1 - x : 3 + x;
  }

  void walk(std::uint32_t first, StreetBlocks& blocks) {
    const auto block = static_cast<std::uint32_t>(blocks.rings.size());
    Ring ring;
    std::uint32_t half = first;
    do {
      block_of_[half] = block;
      ring.push_back(graph_.position(end_of(half)));
      half = next_half(half);
    } while (half != first);
    const std::size_t walked = ring.size();
    ring = without_repeats(ring);
    blocks.has_dead_end.push_back(ring.size() < walked);
    if (signed_area_m2(ring) <= 0) ring.clear();
    blocks.rings.push_back(std::move(ring));
  }

  const StreetGraph& graph_;
  std::vector<std::uint32_t> block_of_;
};

}  // namespace

std::vector<StreetEdge> street_edges(const StreetGraph& graph) {
  std::vector<StreetEdge> edges;
  std::vector<char> used(graph.segments().size());
  for (std::uint32_t s = 0; s < used.size(); ++s) {
    if (used[s] || graph.segments()[s].is_removed) continue;
    const auto [first, vertex] = begin_of_chain(graph, s);
    StreetEdge edge{
        chain_from(graph, vertex, first, used), {}, graph.segments()[s].street, graph.segments()[s].is_bridge};
    for (const std::uint32_t v : edge.vertices) edge.axis.push_back(graph.position(v));
    edges.push_back(std::move(edge));
  }
  return edges;
}

StreetBlocks street_blocks(const StreetGraph& graph, std::vector<StreetEdge>& edges) {
  BlockWalk walk(graph);
  StreetBlocks blocks = walk.run();
  for (StreetEdge& edge : edges) {
    edge.left_block = walk.block_of(edge.vertices[0], edge.vertices[1]);
    edge.right_block = walk.block_of(edge.vertices[1], edge.vertices[0]);
  }
  return blocks;
}

void keep_largest_part(StreetGraph& graph) {
  const auto count = static_cast<std::uint32_t>(graph.vertices().size());
  DisjointSets parts(count);
  for (const StreetSegment& s : graph.segments())
    if (!s.is_removed) parts.join(s.a, s.b);
  std::vector<std::uint32_t> sizes(count);
  for (const StreetSegment& s : graph.segments())
    if (!s.is_removed) ++sizes[parts.find(s.a)];
  const auto largest = static_cast<std::uint32_t>(std::ranges::max_element(sizes) - sizes.begin());
  for (std::uint32_t s = 0; s < graph.segments().size(); ++s)
    if (!graph.segments()[s].is_removed && parts.find(graph.segments()[s].a) != largest) graph.remove_segment(s);
}

}  // namespace citykiln::invent
