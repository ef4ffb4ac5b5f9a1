#include "compiler/invent/land/make_terrain.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "compiler/contract/random_sequence.h"
#include "compiler/contract/system/for_each_slot.h"
#include "compiler/geometry/polygon.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/trig.h"
#include "compiler/invent/land/contour.h"
#include "compiler/invent/land/drainage.h"
#include "compiler/invent/land/fill_pits.h"
#include "compiler/invent/land/lattice.h"
#include "compiler/invent/land/noise.h"

namespace citykiln::invent {
namespace {

// Rivers: the points of a lattice that drain enough land, as lines.

// A river, and the height of its water at each point of its axis, falling downstream.
struct TracedRiver {
  River river;
  std::vector<double> levels_m;
};

// each round moves points by a quarter of their bend: lattice steps become curves
constexpr int kSmoothings = 6;

class Tracer {
 public:
  Tracer(const Lattice& lattice, const Drainage& drainage, const TerrainSettings& settings,
         const std::vector<bool>& is_standing)
      : lattice_(lattice), drainage_(drainage), settings_(settings), is_standing_(is_standing) {
    inflows_.assign(lattice.size(), 0);
    for (std::uint32_t i = 0; i < lattice.size(); ++i)
      if (is_river(i) && drainage.receiver[i] != i && !is_standing[i]) ++inflows_[drainage.receiver[i]];
  }

  std::vector<TracedRiver> trace() const {
    std::vector<TracedRiver> rivers;
    for (std::uint32_t i = 0; i < lattice_.size(); ++i)
      if (is_start(i)) rivers.push_back(river_from(i));
    return rivers;
  }

 private:
  bool is_river(std::uint32_t i) const { return drainage_.area_m2[i] >= settings_.river_from_km2 * 1e6; }
  /// True for sources, confluences, and outlets of lakes.
  bool is_start(std::uint32_t i) const {
    const std::uint32_t to = drainage_.receiver[i];
    if (!is_river(i) || to == i) return false;
    if (is_standing_[i]) return !is_standing_[to];
    return inflows_[i] != 1;
  }

  double width_m(std::uint32_t i) const { return settings_.river_width_m * std::sqrt(drainage_.area_m2[i] / 1e6); }

  TracedRiver river_from(std::uint32_t first) const {
    TracedRiver traced;
    const auto add = [&](std::uint32_t i) {
      traced.river.axis.push_back(lattice_.place(i));
      traced.river.width_m.push_back(width_m(i));
      traced.levels_m.push_back(lattice_.heights_m[i]);
    };
    add(first);
    for (std::uint32_t at = first;;) {
      at = drainage_.receiver[at];
      add(at);
      if (drainage_.receiver[at] == at || is_standing_[at] || inflows_[at] != 1) break;
    }
    // the receiver drains the land of the confluence, and is as wide as the next river
    if (traced.river.width_m.size() > 1) traced.river.width_m.back() = *(traced.river.width_m.end() - 2);
    smooth(traced.river.axis);
    return traced;
  }

  static void smooth(Polyline& axis) {
    for (int round = 0; round < kSmoothings; ++round) {
      const Polyline before = axis;
      for (std::size_t i = 1; i + 1 < axis.size(); ++i)
        axis[i] = before[i] * 0.5 + (before[i - 1] + before[i + 1]) * 0.25;
    }
  }

  const Lattice& lattice_;
  const Drainage& drainage_;
  const TerrainSettings& settings_;
  const std::vector<bool>& is_standing_;
  std::vector<std::uint8_t> inflows_;
};

// Lowers the points within a distance of a segment to the level of the nearest place on it.
void lower_to_segment(Lattice& lattice, const TracedRiver& traced, std::size_t k, const std::vector<bool>& is_fixed) {
  const Vec2 a = traced.river.axis[k], b = traced.river.axis[k + 1];
  const double half_m = lattice.cells * lattice.step_m / 2;
  const double within_m = traced.river.width_m[k] / 2 + lattice.step_m * 1.05;
  const auto cell = [&](double v) {
    return std::clamp(static_cast<int>((v + half_m) / lattice.step_m), 0, lattice.cells);
  };
  for (int row = cell(std::min(a.y, b.y) - within_m); row <= cell(std::max(a.y, b.y) + within_m); ++row)
    for (int column = cell(std::min(a.x, b.x) - within_m); column <= cell(std::max(a.x, b.x) + within_m); ++column) {
      const std::size_t i = lattice.index(column, row);
      const Vec2 p{column * lattice.step_m - half_m, row * lattice.step_m - half_m};
      const double share = nearest_share(a, b, p);
      if (distance(a + (b - a) * share, p) > within_m || (!is_fixed.empty() && is_fixed[i])) continue;
      const double level_m = traced.levels_m[k] + (traced.levels_m[k + 1] - traced.levels_m[k]) * share;
      lattice.heights_m[i] = std::min(lattice.heights_m[i], level_m);
    }
}

// Returns one river from each source and each confluence to the next confluence, standing water, or the border. Rivers
// meet in equal points. Axes are smoothed between their ends, by less than a step of the lattice.
// @param is_standing  Points in lakes and in the sea, which rivers enter by one point.
// O(n).
std::vector<TracedRiver> trace_rivers(const Lattice& lattice, const Drainage& drainage, const TerrainSettings& settings,
                                      const std::vector<bool>& is_standing) {
  return Tracer(lattice, drainage, settings, is_standing).trace();
}

// Lowers the points near rivers to the water's level, so that smoothed axes lie in a valley. Fixed points stay.
void lower_to_rivers(Lattice& lattice, const std::vector<TracedRiver>& rivers, const std::vector<bool>& is_fixed) {
  for (const TracedRiver& traced : rivers)
    for (std::size_t k = 0; k + 1 < traced.river.axis.size(); ++k) lower_to_segment(lattice, traced, k, is_fixed);
}

// Hollows of a lattice that hold lakes.

// A hollow, filled up to its outlet.
struct Lake {
  std::vector<std::uint32_t> points;  ///< Points under water, ascending.
  std::vector<double> beds_m;         ///< The height of the ground at each of them.
  double level_m = 0;
  Polygon shore;
};

// shallower or smaller hollows are not worth a shore
constexpr double kLeastDepth_m = 2, kLeastLake_m2 = 4000;

// the shore keeps off the lattice's points by this share of depth
constexpr double kLeastShore_m = 0.05;

// The points of the hollow about a point that is not yet in another; all are marked.
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

// The shore: the polygon of the lake's largest part.
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

// Returns the largest hollows, at most `count`, that are at least 2 m deep and 4,000 m² large and lie within a square
// of this side about the middle. O(n log n).
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

// Sides of the square, in sides of the map: land around is seen from the map, and rivers need land to come from.
constexpr double kUsualSides = 3, kMostAround_m = 4096;
constexpr double kUsualStep_m = 8;
constexpr int kLeastPower = 6, kMostUsualPower = 10;
// lakes keep off the border of the map by this share of its side, so that their shores are mapped whole
constexpr double kLakesWithin = 0.9;
constexpr double kLeastSea_m2 = 2000;

double side_of(const TerrainSettings& settings, double map_side_m) {
  if (settings.size_m > 0) return std::max(settings.size_m, map_side_m);
  return std::min(map_side_m * kUsualSides, map_side_m + kMostAround_m);
}

int power_of(const TerrainSettings& settings, double side_m) {
  if (settings.fractal.power > 0) return settings.fractal.power;
  int power = kLeastPower;
  while (power < kMostUsualPower && side_m / (1 << power) > kUsualStep_m) ++power;
  return power;
}

Lattice raw_land(const TerrainSettings& settings, double map_side_m, std::uint64_t seed) {
  const double side_m = side_of(settings, map_side_m);
  DiamondSquare fractal = settings.fractal;
  fractal.power = power_of(settings, side_m);
  Lattice lattice{1 << fractal.power, side_m / (1 << fractal.power), diamond_square(fractal, seed)};
  const auto row_length = static_cast<std::size_t>(lattice.count());
  if (settings.ridges_m > 0)
    for_each_index(row_length, 0, [&](std::size_t row) {
      for (std::size_t i = row * row_length; i < (row + 1) * row_length; ++i)
        lattice.heights_m[i] +=
            settings.ridges_m * ridged_noise(lattice.place(i) * (1 / settings.ridge_length_m), 5, seed);
    });
  return lattice;
}

/// Sinks the land towards one side, so that the coast crosses the map.
void sink_coast(Lattice& lattice, const TerrainSettings& settings, double map_side_m, std::uint64_t seed) {
  const Vec2 seaward = direction_of(RandomSequence(seed, {}, "coast").unit(0));
  // the coast lies about a quarter of the map's side from the middle
  const double middle_m = lattice.heights_m[lattice.size() / 2];
  for (std::size_t i = 0; i < lattice.size(); ++i) {
    const double away = dot(lattice.place(i), seaward) / map_side_m;
    const double offset_m = std::clamp(0.25 - away, -1.0, 1.0) * settings.coast_fall_m;
    lattice.heights_m[i] += offset_m - middle_m;
  }
}

/// Points of lakes, and those within two steps of them.
std::vector<bool> points_about(const std::vector<Lake>& lakes, const Lattice& lattice) {
  if (lakes.empty()) return {};
  std::vector<bool> is_near(lattice.size(), false);
  for (const Lake& lake : lakes)
    for (const std::uint32_t i : lake.points)
      for (int row = lattice.row(i) - 2; row <= lattice.row(i) + 2; ++row)
        for (int column = lattice.column(i) - 2; column <= lattice.column(i) + 2; ++column)
          if (column >= 0 && row >= 0 && column <= lattice.cells && row <= lattice.cells)
            is_near[lattice.index(column, row)] = true;
  return is_near;
}

std::vector<bool> standing_water(const std::vector<Lake>& lakes, const Lattice& lattice, double sea_level_m) {
  std::vector<bool> is_standing(lattice.size(), false);
  for (std::size_t i = 0; i < lattice.size(); ++i) is_standing[i] = lattice.heights_m[i] < sea_level_m;
  for (const Lake& lake : lakes)
    for (const std::uint32_t i : lake.points) is_standing[i] = true;
  return is_standing;
}

std::vector<Polygon> sea_of(const Lattice& lattice, double sea_level_m) {
  const double half_m = lattice.cells * lattice.step_m / 2;
  ValueGrid grid{{-half_m, -half_m}, lattice.step_m, lattice.count(), lattice.count(), {}};
  for (const double height_m : lattice.heights_m) grid.values.push_back(sea_level_m - height_m);
  return area_above_zero(grid, kLeastSea_m2);
}

void put_lakes(std::vector<Lake> lakes, Lattice& lattice, Terrain& terrain) {
  for (Lake& lake : lakes) {
    for (std::size_t k = 0; k < lake.points.size(); ++k) lattice.heights_m[lake.points[k]] = lake.beds_m[k];
    if (lake.shore.outer.empty()) continue;
    terrain.lakes.push_back(std::move(lake.shore));
    terrain.lake_levels_m.push_back(lake.level_m);
  }
}

}  // namespace

Terrain make_terrain(const TerrainSettings& settings, double map_side_m, std::uint64_t seed) {
  Lattice lattice = raw_land(settings, map_side_m, seed);
  if (settings.has_coast) sink_coast(lattice, settings, map_side_m, seed);
  // lakes are hollows of the fractal: erosion would drain them, so that they and their shores stay as they are
  std::vector<Lake> lakes = find_lakes(lattice, settings.lakes, map_side_m * kLakesWithin);
  const std::vector<bool> is_fixed = points_about(lakes, lattice);
  fill_pits(lattice);
  erode(lattice, settings.erosion, is_fixed);

  Terrain terrain;
  terrain.side_m = lattice.cells * lattice.step_m;
  terrain.cells = lattice.cells;
  terrain.sea_level_m = settings.has_coast ? 0 : -1e6;
  const std::vector<bool> is_standing = standing_water(lakes, lattice, terrain.sea_level_m);
  std::vector<TracedRiver> rivers = trace_rivers(lattice, drain(lattice), settings, is_standing);
  lower_to_rivers(lattice, rivers, is_fixed);
  fill_pits(lattice);
  for (TracedRiver& traced : rivers) terrain.rivers.push_back(std::move(traced.river));
  if (settings.has_coast) terrain.sea = sea_of(lattice, terrain.sea_level_m);
  put_lakes(std::move(lakes), lattice, terrain);
  terrain.heights_m.assign(lattice.heights_m.begin(), lattice.heights_m.end());
  index_water(terrain);
  return terrain;
}

}  // namespace citykiln::invent
