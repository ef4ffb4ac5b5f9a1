// Robustness and cost of three methods of computing junction outlines: the share of invalid outlines over the grid step
// of their coordinates.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/geometry/polygons/overlay.h"
#include "compiler/geometry/ring_crossing.h"
#include "compiler/geometry/snap.h"
#include "compiler/roads/junctions/junction_ring.h"
#include "tests/charts/chart.h"
#include "tests/charts/exact_union.h"
#include "tests/charts/read_roads.h"
#include "tests/charts/stopwatch.h"

namespace citykiln::charts {
namespace {

/// A junction as input of all methods.
struct Case {
  std::optional<Ring> walked;  ///< The outline by plain floating point.
  std::vector<Ring> pieces;    ///< Rings whose union is the outline.
};

Result<std::vector<Case>> cases_of(const std::string& path, int threads) {
  const Result<std::vector<roads::Road>> read = read_roads(path, threads);
  if (!read) return read.error();
  const std::vector<roads::Road>& roads = *read;
  Report ignored;
  const std::vector<roads::Junction> junctions = roads::plan_junctions(roads, ignored);
  const auto arms = roads::arms_of(junctions, roads);
  std::vector<Case> cases;
  for (std::size_t j = 0; j < junctions.size(); ++j) {
    const roads::JunctionArms around = roads::junction_arms(junctions[j], roads, arms[j]);
    cases.push_back({roads::trace_outline_unchecked(junctions[j], roads, arms[j], around),
                     roads::stroke_pieces(junctions[j], roads, arms[j], around)});
  }
  return cases;
}

Ring scaled(const Ring& ring, double by) {
  Ring out;
  for (const Vec2 p : ring) out.push_back(snapped(p * by));
  return out;
}

/// True if the polygons, scaled from a grid of `step_m` to one of 2^-10 m where the test is exact, are simple.
bool is_valid(const std::vector<Polygon>& polygons, double step_m) {
  if (polygons.empty()) return false;
  return std::ranges::all_of(polygons, [&](const Polygon& polygon) {
    const auto is_sound = [&](const Ring& ring) {
      return is_simple(without_repeats(scaled(ring, kQuantum_m / step_m)));
    };
    return is_sound(polygon.outer) && std::ranges::all_of(polygon.holes, is_sound);
  });
}

std::vector<Polygon> by_walking(const Case& one, double) {
  return one.walked ? std::vector<Polygon>{{*one.walked, {}}} : std::vector<Polygon>{};
}

std::vector<Polygon> by_exact_union(const Case& one, double step_m) { return exact_union(one.pieces, step_m); }

/// citykiln's method. Coarser grids are emulated by scaling the plane, since the arrangement's grid is fixed.
std::vector<Polygon> by_snap_rounding(const Case& one, double step_m) {
  std::vector<OwnedSegment> segments;
  for (const Ring& ring : one.pieces)
    if (const Ring coarse = without_repeats(scaled(ring, kQuantum_m / step_m)); coarse.size() >= 3)
      add_ring(segments, coarse, 0);
  std::vector<Polygon> polygons = std::move(overlay(segments, 1)[0]);
  for (Polygon& polygon : polygons) {
    for (Vec2& p : polygon.outer) p = p * (step_m / kQuantum_m);
    for (Ring& hole : polygon.holes)
      for (Vec2& p : hole) p = p * (step_m / kQuantum_m);
  }
  return polygons;
}

struct OutlineMethod {
  const char* name;
  std::vector<Polygon> (*outline)(const Case&, double step_m);
};
constexpr OutlineMethod kOutlineMethods[] = {{"edges intersected in floating point, unchecked", by_walking},
                                             {"exact constructions (CGAL), then rounded", by_exact_union},
                                             {"snap rounding (citykiln's fallback)", by_snap_rounding}};

constexpr double kSteps_m[] = {0x1p-10, 0x1p-8, 0x1p-6, 0x1p-4, 0x1p-3, 0x1p-2, 0x1p-1, 1};

}  // namespace

Result<std::vector<Chart>> chart_junctions(const ChartRequest& request) {
  if (request.maps.empty()) return Error{"chart junctions", "needs maps (--map FILE)"};
  std::vector<Case> cases;
  for (const std::string& path : request.maps) {
    Result<std::vector<Case>> more = cases_of(path, request.threads);
    if (!more) return more.error();
    std::ranges::move(*more, std::back_inserter(cases));
  }
  if (cases.empty()) return Error{request.maps.front(), "has no junctions"};
  const Axis grid{"grid that outlines are written on (m)", true};
  Chart invalid{"junctions_invalid",
                fmt::format("Outlines that are not simple: {} junctions", cases.size()),
                grid,
                {"share (%)"},
                {}};
  Chart time{"junctions_time", "Time for an outline", grid, {"microseconds", true}, {}};
  for (const OutlineMethod& method : kOutlineMethods) {
    invalid.series.push_back({method.name, {}});
    time.series.push_back({method.name, {}});
    for (const double step_m : kSteps_m) {
      const Stopwatch watch;
      std::vector<std::vector<Polygon>> outlines;
      for (const Case& one : cases) outlines.push_back(method.outline(one, step_m));
      const double us = watch.microseconds();
      const auto wrong = std::ranges::count_if(outlines, [&](const auto& o) { return !is_valid(o, step_m); });
      invalid.series.back().points.emplace_back(step_m,
                                                100.0 * static_cast<double>(wrong) / static_cast<double>(cases.size()));
      time.series.back().points.emplace_back(step_m, us / static_cast<double>(cases.size()));
    }
  }
  // the plain method's outlines were made before the clock was started
  time.series.erase(time.series.begin());
  return std::vector{invalid, time};
}

}  // namespace citykiln::charts
