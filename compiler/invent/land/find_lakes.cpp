#include "compiler/invent/land/find_lakes.h"

#include <algorithm>
#include <cmath>

#include "compiler/invent/land/contour.h"
#include "compiler/invent/land/fill_pits.h"

namespace citykiln::invent {
namespace {

// shallower or smaller hollows are not worth a shore
constexpr double kLeastDepth_m = 2, kLeastLake_m2 = 4000;
// the shore keeps off the lattice's points by this share of depth
constexpr double kLeastShore_m = 0.05;

/// The points of the hollow about a point that is not yet in another; all are marked.
Lake hollow_about(std::uint32_t first, const Lattice& ground, const Lattice& filled, std::vector<bool>& is_marked) {
  Lake lake{.points = {first}, .beds_m = {}, .level_m = filled.heights_m[first], .shore = {}};
  is_marked[first] = true;
  for (std::size_t at = 0; at < lake.points.size(); ++at)
    ground.for_each_neighbour(lake.points[at], [&](std::size_t j, double) {
      if (is_marked[j] || filled.heights_m[j] - ground.heights_m[j] <= kLeastShore_m) return;
      is_marked[j] = true;
      lake.points.push_back(static_cast<std::uint32_t>(j));
    });
  std::ranges::sort(lake.points);
  for (const std::uint32_t i : lake.points) {
    lake.beds_m.push_back(ground.heights_m[i]);
    lake.level_m = std::min(lake.level_m, filled.heights_m[i]);
  }
  return lake;
}

bool is_worth_it(const Lake& lake, const Lattice& lattice, double square_side_m) {
  const double deepest_m = lake.level_m - *std::ranges::min_element(lake.beds_m);
  const bool is_large = lake.points.size() * lattice.step_m * lattice.step_m >= kLeastLake_m2;
  return is_large && deepest_m >= kLeastDepth_m && std::ranges::all_of(lake.points, [&](std::uint32_t i) {
           const Vec2 p = lattice.place(i);
           return std::max(std::abs(p.x), std::abs(p.y)) < square_side_m / 2;
         });
}

/// The shore: the polygon of the lake's largest part.
Polygon shore_of(const Lake& lake, const Lattice& lattice) {
  const double half_m = lattice.cells * lattice.step_m / 2;
  ValueGrid grid{{-half_m, -half_m}, lattice.step_m, lattice.count(), lattice.count(), {}};
  for (const double height_m : lattice.heights_m)
    grid.values.push_back(std::min(lake.level_m - height_m, -kLeastShore_m));
  for (std::size_t k = 0; k < lake.points.size(); ++k)
    grid.values[lake.points[k]] = std::max(lake.level_m - lake.beds_m[k], kLeastShore_m);
  std::vector<Polygon> parts = area_above_zero(grid, 0);
  const auto largest = std::ranges::max_element(parts, {}, [](const Polygon& part) { return area_m2(part); });
  return largest == parts.end() ? Polygon{} : std::move(*largest);
}

}  // namespace

std::vector<Lake> find_lakes(const Lattice& lattice, int count, double square_side_m) {
  std::vector<Lake> lakes;
  if (count == 0) return lakes;
  Lattice filled = lattice;
  fill_pits(filled);
  std::vector<bool> is_marked(lattice.size(), false);
  for (std::uint32_t i = 0; i < lattice.size(); ++i) {
    if (is_marked[i] || filled.heights_m[i] - lattice.heights_m[i] < kLeastDepth_m) continue;
    Lake lake = hollow_about(i, lattice, filled, is_marked);
    if (is_worth_it(lake, lattice, square_side_m)) lakes.push_back(std::move(lake));
  }
  std::ranges::stable_sort(lakes, std::greater<>(), [](const Lake& lake) { return lake.points.size(); });
  if (lakes.size() > static_cast<std::size_t>(count)) lakes.resize(count);
  for (Lake& lake : lakes) lake.shore = shore_of(lake, lattice);
  return lakes;
}

}  // namespace citykiln::invent
