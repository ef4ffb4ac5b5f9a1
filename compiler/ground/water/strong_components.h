// Parts of a directed graph that run in circles.
#pragma once

#include <cstdint>
#include <vector>

namespace citykiln::ground {

/// For each node the number of its strongly connected component: those that reach each other share one, and every edge
/// leads to its own component or to one of a lower number. Numbers are 0 … count - 1.
/// Source: Tarjan, "Depth-first search and linear graph algorithms", 1972, without recursion. O(nodes + edges).
struct Components {
  std::vector<std::uint32_t> of;
  std::uint32_t count = 0;
};
Components strong_components(const std::vector<std::vector<std::uint32_t>>& successors);

}  // namespace citykiln::ground
