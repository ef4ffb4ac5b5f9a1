// Failures of textbook methods and of citykiln's on input that breaks the former: near-parallel, coincident, needles,
// huge coordinates.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/geometry/polygons/offset_polygon.h"
#include "compiler/geometry/polygons/overlay.h"
#include "compiler/geometry/ring_crossing.h"
#include "compiler/geometry/snap.h"
#include "compiler/geometry/triangles/triangulate.h"
#include "tests/charts/chart.h"
#include "tests/charts/hard_cases.h"
#include "tests/charts/stopwatch.h"
#include "tests/charts/textbook.h"

namespace citykiln::charts {
namespace {

Vec2 towards(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// True if the area is that which is wanted, to a thousandth and to the grid's rounding along the border.
bool is_about(double area, double wanted, double border_m) {
  return std::abs(area - wanted) <= 1e-3 * std::abs(wanted) + 4 * kQuantum_m * border_m;
}

bool is_sound_ring(const Ring& ring) {
  const bool is_finite = std::ranges::all_of(ring, [](Vec2 p) { return std::abs(p.x) < 1e6 && std::abs(p.y) < 1e6; });
  if (!is_finite) return false;
  Ring written;
  for (const Vec2 p : ring) written.push_back(snapped(p));
  return is_simple(written) && signed_area_m2(written) > 0;
}

double areas_m2(std::span<const Polygon> polygons) {
  double sum = 0;
  for (const Polygon& polygon : polygons) sum += area_m2(polygon);
  return sum;
}

// Two carriageways of one width that part at an angle from a millionth of a radian on.
Judged judge_junction(HardDraw& draw) {
  const double angle = draw.of_any_size(1e-6, 1), turn = draw.between(0, 6.28), width = draw.between(3, 12);
  const Vec2 node = snapped(Vec2{draw.between(-5000, 5000), draw.between(-5000, 5000)});
  const Vec2 first = snapped(node + towards(turn) * draw.between(20, 40)),
             second = snapped(node + towards(turn + angle) * draw.between(20, 40));
  const auto strip = [&](Vec2 end) {
    const Vec2 beside = left_of(unit(end - node)) * (width / 2);
    return Ring{snapped(node - beside), snapped(end - beside), snapped(end + beside), snapped(node + beside)};
  };
  const auto textbook = mitred_outline(node, first, second, width);
  // the outline must not reach farther than the strips are long
  const auto is_near = [&](Vec2 p) { return distance(p, node) < 45 + width; };
  std::vector<OwnedSegment> segments;
  const Ring a = strip(first), b = strip(second);
  add_ring(segments, a, 0), add_ring(segments, b, 0);
  const std::vector<Polygon> joined = std::move(overlay(segments, 1)[0]);
  const double area = areas_m2(joined), one = signed_area_m2(a), other = signed_area_m2(b);
  return {textbook && std::ranges::all_of(*textbook, is_near) && is_sound_ring(*textbook),
          std::ranges::all_of(joined, [](const Polygon& p) { return is_sound_ring(p.outer); }) &&
              area > std::max(one, other) * 0.999 && area < (one + other) * 1.001};
}

Judged judge_triangles(HardDraw& draw) {
  const Ring ring = hard_ring(draw, {draw.between(-5000, 5000), draw.between(-5000, 5000)});
  const double wanted = signed_area_m2(ring), border = length_m(ring);
  const auto area_of = [](std::span<const Vec2> points, std::span<const Triangle> triangles) {
    double sum = 0;
    for (const Triangle& t : triangles) sum += twice_area(points[t[0]], points[t[1]], points[t[2]]) / 2;
    return sum;
  };
  const PlaneTriangles ours = triangulate({ring, {}});
  return {is_about(area_of(ring, cut_ears(ring)), wanted, border),
          is_about(area_of(ours.points, ours.triangles), wanted, border)};
}

Judged judge_offset(HardDraw& draw) {
  const Ring ring = hard_ring(draw, {});
  const double depth = draw.between(0.2, 6), wanted = signed_area_m2(ring);
  const auto textbook = inset_by_lines(ring, depth);
  const bool is_right = textbook && is_sound_ring(*textbook) && signed_area_m2(*textbook) < wanted &&
                        std::ranges::all_of(*textbook, [&](Vec2 p) { return winding_number(ring, p) == 1; });
  const OffsetPolygon ours = inset({ring, {}}, std::vector<double>(ring.size(), depth));
  double area = areas_m2(ours.moved);
  for (const std::vector<Polygon>& band : ours.bands) area += areas_m2(band);
  const bool is_within =
      std::ranges::all_of(ours.moved, [&](const Polygon& p) { return signed_area_m2(p.outer) >= 0; });
  return {is_right, is_within && is_about(area, wanted, length_m(ring))};
}

// The place of a corner written in single precision: from the Earth's middle, and from the tile's origin.
Judged judge_place(HardDraw& draw) {
  constexpr double kRadius_m = 6'371'000, kMostError_m = 0.001;
  const auto error_m = [](double x) { return std::abs(static_cast<double>(static_cast<float>(x)) - x); };
  const double around = draw.between(0, 6.28), in_tile = snapped(draw.between(0, 1024));
  return {error_m(kRadius_m * std::cos(around)) < kMostError_m, error_m(in_tile) < kMostError_m};
}

constexpr HardMethod kHardMethods[] = {
    {"near-parallel junctions", "sides intersected", "snap-rounded overlay", judge_junction, 100'000},
    {"triangulation with needles", "ears cut off", "exact Delaunay", judge_triangles, 100'000},
    {"offsets of such rings", "moved lines intersected", "lines, else overlay", judge_offset, 100'000},
    {"hipped roofs, events at once", "skeleton in doubles", "generate_roof()", judge_symmetric_roof, 10'000},
    {"land with spikes refined", "halved by middles", "worst point first", judge_refinement, 10'000},
    {"one lamp of up to 64", "even choice", "LightTree", judge_lights, 100'000},
    {"one lamp, some within 0.2 m", "even choice", "LightTree", judge_near_lights, 100'000},
    {"turtles of up to 2^20 turns", "matrices in floats", "walk()", judge_turtle, 100'000},
    {"growth without end, poles", "loop without limits", "derive(), limits", judge_growth, 100'000},
    {"lots with 1 or 2 frontages", "halved across", "frontage kept", judge_lots, 100'000},
    {"corners in floats to 1 mm", "from the Earth's middle", "from the tile's origin", judge_place, 100'000}};

}  // namespace

Result<std::vector<Chart>> chart_stability(const ChartRequest&) {
  Chart chart{"stability", "Failures on hard input", {"method"}, {"share (%)"}, {{"textbook", {}}, {"citykiln", {}}}};
  chart.notes = {"| method | cases | textbook | fails | ours | fails | µs a case, both |",
                 "|---|--:|---|--:|---|--:|--:|"};
  for (std::size_t m = 0; m < std::size(kHardMethods); ++m) {
    const HardMethod& method = kHardMethods[m];
    int textbook = 0, ours = 0;
    const Stopwatch watch;
    for (int i = 0; i < method.cases; ++i) {
      HardDraw draw(static_cast<std::uint64_t>(i));
      const Judged judged = method.judge(draw);
      textbook += !judged.textbook, ours += !judged.ours;
    }
    const double us = watch.microseconds() / method.cases;
    const auto percent = [&](int count) { return 100.0 * count / method.cases; };
    chart.series[0].points.emplace_back(m, percent(textbook)), chart.series[1].points.emplace_back(m, percent(ours));
    chart.notes.push_back(fmt::format("| {} | {} | {} | {} ({:.3g} %) | {} | {} ({:.3g} %) | {:.0f} |", method.name,
                                      method.cases, method.textbook, textbook, percent(textbook), method.ours, ours,
                                      percent(ours), us));
  }
  return std::vector{chart};
}

}  // namespace citykiln::charts
