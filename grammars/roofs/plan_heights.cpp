#include "grammars/roofs/plan_heights.h"

#include <algorithm>
#include <tuple>

#include "compiler/geometry/snap.h"

namespace citykiln::roofs {
namespace {

// A corner of a cell; corners with equal point and surface share a height.
struct Corner {
  std::uint32_t point, surface, cell;
  int index;
  bool is_uncovered;
  double z_m;
};

std::vector<Corner> corners_of_plan(const PlanCells& plan, std::span<const Facet> facets) {
  std::vector<Corner> corners;
  corners.reserve(3 * plan.cells.size());
  for (std::uint32_t c = 0; c < plan.cells.size(); ++c) {
    const PlanCell& cell = plan.cells[c];
    const Facet* facet = cell.facet == kNoFacet ? nullptr : &facets[cell.facet];
    for (int i = 0; i < 3; ++i)
      corners.push_back({cell.points[i], facet ? facet->surface : 0, c, i, cell.is_uncovered,
                         facet ? facet->plane.at(plan.points[cell.points[i]]) : 0});
  }
  std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) {
    return std::tie(a.point, a.surface, a.cell) < std::tie(b.point, b.surface, b.cell);
  });
  return corners;
}

enum class Location : std::uint8_t { kOutside, kInside, kBorder };

// The location of each point relative to the footprint.
std::vector<Location> locations_of(const PlanCells& plan) {
  std::vector<Location> locations(plan.points.size(), Location::kOutside);
  for (const PlanCell& cell : plan.cells)
    for (const std::uint32_t p : cell.points)
      if (cell.is_over_footprint) locations[p] = Location::kInside;
  for (const PlanCell& cell : plan.cells)
    for (int i = 0; i < 3 && cell.is_over_footprint; ++i) {
      const std::uint32_t beyond = cell.neighbours[i];
      if (beyond != kNoFacet && plan.cells[beyond].is_over_footprint) continue;
      locations[cell.points[(i + 1) % 3]] = locations[cell.points[(i + 2) % 3]] = Location::kBorder;
    }
  return locations;
}

double at_least_zero(double z_m, Location location, double flush_m) {
  if (location == Location::kOutside) return z_m;
  return z_m < (location == Location::kBorder ? flush_m : 0) ? 0 : z_m;
}

double uncovered_m2(const PlanCells& plan) {
  double sum = 0;
  for (const PlanCell& cell : plan.cells) {
    const Vec2 a = plan.points[cell.points[0]], b = plan.points[cell.points[1]], c = plan.points[cell.points[2]];
    if (cell.is_uncovered) sum += cross(b - a, c - a) / 2;
  }
  return sum;
}

// The range of some heights.
struct Range {
  double low_m = 0, high_m = 0;
  bool is_empty = true;

  void grow(double z_m) {
    low_m = is_empty ? z_m : std::min(low_m, z_m);
    high_m = is_empty ? z_m : std::max(high_m, z_m);
    is_empty = false;
  }
};

}  // namespace

PlanHeights plan_heights(const PlanCells& plan, std::span<const Facet> facets, double flush_m) {
  PlanHeights heights{std::vector<std::array<double, 3>>(plan.cells.size()), uncovered_m2(plan), 0};
  const std::vector<Corner> corners = corners_of_plan(plan, facets);
  const std::vector<Location> locations = locations_of(plan);
  const auto is_joined = [](const Corner& a, const Corner& b) { return a.point == b.point && a.surface == b.surface; };
  for (std::size_t i = 0, end = 0; i < corners.size(); i = end) {
    Range covered, bare;
    for (end = i; end < corners.size() && is_joined(corners[end], corners[i]); ++end)
      (corners[end].is_uncovered ? bare : covered).grow(corners[end].z_m);
    heights.largest_gap_m = std::max(heights.largest_gap_m, covered.high_m - covered.low_m);
    const double low_m = (covered.is_empty ? bare : covered).low_m;
    const double z_m = at_least_zero(snapped(low_m), locations[corners[i].point], flush_m);
    for (std::size_t k = i; k < end; ++k) heights.corners_m[corners[k].cell][corners[k].index] = z_m;
  }
  return heights;
}

}  // namespace citykiln::roofs
