#include "compiler/map/buildings/coincident_footprints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <tuple>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/segment.h"

namespace citykiln::map {
namespace {

// About a town block.
constexpr double kFootprintBucket_m = 64;
// Footprints that share more than this part of the lower one's height are in the same place.
constexpr double kSameHeightsShare = 0.5;
double distance_to_border_m(const Polygon& polygon, Vec2 p) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Ring* ring : rings_of(polygon)) nearest_m = std::min(nearest_m, distance_to_ring(*ring, p));
  return nearest_m;
}

// The largest distance of a corner of one polygon from the border of the other.
double apart_m(const Polygon& a, const Polygon& b) {
  double farthest_m = 0;
  for (const Ring* ring : rings_of(a))
    for (const Vec2 p : *ring) farthest_m = std::max(farthest_m, distance_to_border_m(b, p));
  return farthest_m;
}

bool have_same_box(const Box2& a, const Box2& b) {
  const auto is_near = [](double u, double v) { return std::abs(u - v) <= kSameOutline_m; };
  return is_near(a.min.x, b.min.x) && is_near(a.min.y, b.min.y) && is_near(a.max.x, b.max.x) &&
         is_near(a.max.y, b.max.y);
}

double rise_m(const Footprint& f) { return f.height_m - f.min_height_m; }

bool have_same_heights(const Footprint& a, const Footprint& b) {
  const double shared_m = std::min(a.height_m, b.height_m) - std::max(a.min_height_m, b.min_height_m);
  return shared_m > kSameHeightsShare * std::min(rise_m(a), rise_m(b));
}

bool is_duplicate(const Footprint& a, const Footprint& b) {
  return a.is_part == b.is_part && have_same_heights(a, b) &&
         std::max(apart_m(a.polygon, b.polygon), apart_m(b.polygon, a.polygon)) <= kSameOutline_m;
}

// The indices of footprints; of duplicates the first one in this order is kept.
std::vector<std::uint32_t> by_rank(std::span<const Footprint> footprints) {
  std::vector<std::uint32_t> order(footprints.size());
  std::iota(order.begin(), order.end(), 0);
  const auto rank = [&](std::uint32_t i) {
    const Footprint& f = footprints[i];
    return std::tuple(!(f.levels > 0 || f.has_roof_in_height), -rise_m(f), f.id);
  };
  std::ranges::sort(order, {}, rank);
  return order;
}

std::vector<Footprint> without(std::vector<Footprint> footprints, const std::vector<bool>& is_left_out,
                               Account& account, Report& report) {
  std::vector<Footprint> kept;
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    if (!is_left_out[i]) {
      kept.push_back(std::move(footprints[i]));
      continue;
    }
    account.out -= report.counts(footprints[i].id.osm);
    report.drop(account, Code::kDuplicateBuilding, footprints[i].id.osm, rise_m(footprints[i]));
  }
  return kept;
}

}  // namespace

std::vector<Footprint> without_duplicates(std::vector<Footprint> footprints, Account& account, Report& report) {
  std::vector<Box2> boxes;
  for (const Footprint& f : footprints) boxes.push_back(box_of(f.polygon.outer));
  const BoxGrid grid = grid_of(boxes, kFootprintBucket_m);
  std::vector<bool> is_kept(footprints.size(), false), is_left_out(footprints.size(), false);
  for (const std::uint32_t i : by_rank(footprints)) {
    const std::vector<std::uint32_t> near = boxes_about(grid, boxes[i]);
    is_left_out[i] = std::ranges::any_of(near, [&](std::uint32_t other) {
      return is_kept[other] && have_same_box(boxes[i], boxes[other]) && is_duplicate(footprints[i], footprints[other]);
    });
    is_kept[i] = !is_left_out[i];
  }
  return without(std::move(footprints), is_left_out, account, report);
}

}  // namespace citykiln::map
