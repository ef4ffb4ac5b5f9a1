#include "grammars/shapes/border_ring.h"

#include <algorithm>
#include <compare>

namespace citykiln::grammars {
namespace {

struct Edge {
  std::uint32_t from = 0, to = 0;
  auto operator<=>(const Edge&) const = default;
};

std::vector<Edge> sorted(std::vector<Edge> edges) {
  std::sort(edges.begin(), edges.end());
  return edges;
}

// The edges without an opposite edge, in order of the triangles. Empty if an edge occurs twice.
std::vector<Edge> border_of(std::span<const Triangle> triangles) {
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (const auto& [a, b, c] : triangles) edges.insert(edges.end(), {{a, b}, {b, c}, {c, a}});
  const std::vector<Edge> all = sorted(edges);
  if (std::adjacent_find(all.begin(), all.end()) != all.end()) return {};
  std::erase_if(edges, [&](Edge e) { return std::binary_search(all.begin(), all.end(), Edge{e.to, e.from}); });
  return edges;
}

}  // namespace

std::optional<std::vector<std::uint32_t>> border_ring(std::span<const Triangle> triangles) {
  const std::vector<Edge> border = border_of(triangles), by_start = sorted(border);
  if (border.empty()) return std::nullopt;
  std::vector<std::uint32_t> ring;
  ring.reserve(border.size());
  Edge edge = border.front();
  do {
    ring.push_back(edge.from);
    edge = *std::lower_bound(by_start.begin(), by_start.end(), Edge{edge.to, 0});
  } while (edge.from != border.front().from && ring.size() < border.size());
  // a shorter ring means that there are several; a ring through a vertex twice repeats the first edge from there
  const bool is_whole = edge.from == border.front().from && ring.size() == border.size();
  return is_whole ? std::optional(std::move(ring)) : std::nullopt;
}

}  // namespace citykiln::grammars
