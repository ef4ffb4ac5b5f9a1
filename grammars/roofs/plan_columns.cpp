#include "grammars/roofs/plan_columns.h"

#include <algorithm>

#include "compiler/contract/disjoint_sets.h"

namespace citykiln::roofs {
namespace {

std::uint32_t corner_at(const PlanCells& plan, std::uint32_t cell, std::uint32_t point) {
  const auto& points = plan.cells[cell].points;
  return 3 * cell + static_cast<std::uint32_t>(std::find(points.begin(), points.end(), point) - points.begin());
}

void join_across(const PlanCells& plan, std::uint32_t cell, int edge, DisjointSets& corners) {
  const std::uint32_t beyond = plan.cells[cell].neighbours[edge];
  if (beyond == kNoFacet || beyond < cell) return;
  for (const int end : {(edge + 1) % 3, (edge + 2) % 3})
    corners.join(3 * cell + end, corner_at(plan, beyond, plan.cells[cell].points[end]));
}

}  // namespace

PlanColumns plan_columns(const PlanCells& plan) {
  DisjointSets corners(3 * plan.cells.size());
  for (std::uint32_t c = 0; c < plan.cells.size(); ++c)
    for (int edge = 0; edge < 3; ++edge) join_across(plan, c, edge, corners);
  PlanColumns columns;
  columns.of_corners.resize(plan.cells.size());
  std::vector<std::uint32_t> number(corners.size());
  for (std::uint32_t corner = 0; corner < corners.size(); ++corner) {
    const std::uint32_t root = corners.find(corner);
    // a root is the lowest of its corners, so it is numbered first
    if (root == corner) {
      number[corner] = static_cast<std::uint32_t>(columns.positions.size());
      columns.positions.push_back(plan.points[plan.cells[corner / 3].points[corner % 3]]);
    }
    columns.of_corners[corner / 3][corner % 3] = number[root];
  }
  return columns;
}

}  // namespace citykiln::roofs
