#include "compiler/invent/town/addresses.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace citykiln::invent {
namespace {

/// Where an edge lies on its street.
struct EdgePlace {
  double from_m = 0;
  bool is_reversed = false;
};

using EdgesAtVertex = std::map<std::uint32_t, std::vector<std::uint32_t>>;

// the edge from which to walk along a street: one at an end, else the first
std::pair<std::uint32_t, std::uint32_t> first_edge(const std::vector<StreetEdge>& edges,
                                                   const std::vector<std::uint32_t>& left, const EdgesAtVertex& at) {
  for (const std::uint32_t e : left)
    for (const std::uint32_t v : {edges[e].vertices.front(), edges[e].vertices.back()})
      if (at.at(v).size() == 1) return {e, v};
  return {left.front(), edges[left.front()].vertices.front()};
}

// walks along the edges of one street and notes where each begins
void place_street(const std::vector<StreetEdge>& edges, std::vector<std::uint32_t> left,
                  std::vector<EdgePlace>& places) {
  double at_m = 0;
  while (!left.empty()) {
    EdgesAtVertex at;
    for (const std::uint32_t e : left)
      for (const std::uint32_t v : {edges[e].vertices.front(), edges[e].vertices.back()}) at[v].push_back(e);
    auto [edge, vertex] = first_edge(edges, left, at);
    for (bool goes_on = true; goes_on;) {
      places[edge] = {at_m, edges[edge].vertices.front() != vertex};
      at_m += length_m(edges[edge].axis);
      vertex = places[edge].is_reversed ? edges[edge].vertices.front() : edges[edge].vertices.back();
      std::erase(left, edge);
      const auto next =
          std::ranges::find_if(at[vertex], [&](std::uint32_t e) { return std::ranges::find(left, e) != left.end(); });
      goes_on = next != at[vertex].end();
      if (goes_on) edge = *next;
    }
  }
}

}  // namespace

std::vector<int> house_numbers(const std::vector<StreetEdge>& edges, const std::vector<TownLot>& lots) {
  std::map<std::uint32_t, std::vector<std::uint32_t>> streets;
  for (std::uint32_t i = 0; i < edges.size(); ++i) streets[edges[i].street].push_back(i);
  std::vector<EdgePlace> places(edges.size());
  for (const auto& [street, of_street] : streets) place_street(edges, of_street, places);
  std::vector<std::tuple<std::uint32_t, bool, double, std::uint32_t>> order;
  for (std::uint32_t i = 0; i < lots.size(); ++i) {
    const TownLot& lot = lots[i];
    const EdgePlace& place = places[lot.edge];
    const double along_m = place.is_reversed ? length_m(edges[lot.edge].axis) - lot.at_m : lot.at_m;
    order.push_back({edges[lot.edge].street, lot.is_on_left != place.is_reversed, place.from_m + along_m, i});
  }
  std::ranges::sort(order);
  std::vector<int> numbers(lots.size());
  for (std::size_t k = 0, count = 0; k < order.size(); ++k, ++count) {
    const auto& [street, is_left, at_m, lot] = order[k];
    if (k > 0 && (std::get<0>(order[k - 1]) != street || std::get<1>(order[k - 1]) != is_left)) count = 0;
    numbers[lot] = static_cast<int>(2 * count) + (is_left ? 1 : 2);
  }
  return numbers;
}

}  // namespace citykiln::invent
