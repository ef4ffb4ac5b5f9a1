#include "grammars/roofs/section.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <span>

namespace citykiln::roofs {
namespace {

using Bezier = std::array<Vec2, 4>;

// The silhouette of an onion from the eaves to the tip; x relative to the radius at the eaves, y to the rise. Both
// pieces share a tangent.
constexpr std::array kOnion = {Bezier{{{1, 0}, {1.25, 0.08}, {1.25, 0.30}, {0.95, 0.42}}},
                               Bezier{{{0.95, 0.42}, {0.55, 0.58}, {0.12, 0.66}, {0, 1}}}};
// An onion over a skeleton, where it cannot swell: an ogee.
constexpr std::array kOgee = {Bezier{{{0, 0}, {0.1, 0.3}, {0.2, 0.45}, {0.5, 0.55}}},
                              Bezier{{{0.5, 0.55}, {0.8, 0.65}, {0.93, 0.7}, {1, 1}}}};
// The default knees: steep below, shallow above.
constexpr Vec2 kGambrelKnee = {0.4, 0.65}, kMansardKnee = {0.35, 0.75};

// How the error of a chord is measured: at a right angle to it, or vertically.
enum class Measure : std::uint8_t { kPerpendicular, kVertical };

constexpr std::size_t kMostSectionCorners = 256;

Vec2 scaled(Vec2 p, Vec2 size_m) { return {p.x * size_m.x, p.y * size_m.y}; }

Vec2 at(const Bezier& b, double t) {
  const double s = 1 - t;
  return b[0] * (s * s * s) + b[1] * (3 * s * s * t) + b[2] * (3 * s * t * t) + b[3] * (t * t * t);
}

// The second derivative of a cubic is largest at an end, its slope along a side of its control polygon.
Vec2 largest_bend_m(const Bezier& b, Vec2 size_m) {
  const Vec2 start = (b[0] - b[1] * 2 + b[2]) * 6, end = (b[1] - b[2] * 2 + b[3]) * 6;
  return scaled({std::max(std::abs(start.x), std::abs(end.x)), std::max(std::abs(start.y), std::abs(end.y))}, size_m);
}

double largest_slope(const Bezier& b, Vec2 size_m) {
  double largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 side = scaled(b[i + 1] - b[i], size_m);
    largest = std::max(largest, side.y / side.x);
  }
  return largest;
}

// Bounds the distance of a cubic from its chord: an eighth of the largest second derivative. For a chord over 1/n of
// the parameter it is smaller by n².
double chord_error_m(const Bezier& b, Vec2 size_m, Measure measure) {
  const Vec2 bend = largest_bend_m(b, size_m);
  return (measure == Measure::kPerpendicular ? length(bend) : bend.y + largest_slope(b, size_m) * bend.x) / 8;
}

Section flattened(std::span<const Bezier> pieces, Vec2 size_m, Measure measure, double tolerance_m) {
  Section section{{pieces.front()[0]}, 0};
  for (const Bezier& piece : pieces) {
    const double error_m = chord_error_m(piece, size_m, measure);
    const double n = std::clamp(std::ceil(std::sqrt(error_m / tolerance_m)), 1.0, kMostSectionCorners / 2.0);
    for (double i = 1; i <= n; ++i) section.corners.push_back(at(piece, i / n));
    section.error_m = std::max(section.error_m, error_m / (n * n));
  }
  return section;
}

// A quarter of an ellipse, or a part of a circle, as directions from its centre.
struct Arc {
  Vec2 radii_m;
  double depth_m = 0;  // of the centre below the eaves
  Vec2 start;

  explicit Arc(Vec2 size_m) : radii_m(size_m), start{-1, 0} {
    if (size_m.y >= size_m.x) return;
    const double radius_m = (size_m.x * size_m.x + size_m.y * size_m.y) / (2 * size_m.y);
    radii_m = {radius_m, radius_m};
    depth_m = radius_m - size_m.y;
    start = {-size_m.x / radius_m, depth_m / radius_m};
  }

  // The arc is farthest from the chord where its tangent is parallel to it, in both measures.
  double chord_error_m(Vec2 a, Vec2 b, Measure measure) const {
    const Vec2 middle = unit(a + b), bulge = scaled(middle - (a + b) * 0.5, radii_m);
    if (measure == Measure::kPerpendicular) return length(bulge);
    const double slope = (b.y - a.y) * radii_m.y / ((b.x - a.x) * radii_m.x);
    return bulge.y - slope * bulge.x;
  }
};

Section flattened(const Arc& arc, Vec2 size_m, Measure measure, double tolerance_m) {
  std::vector<Vec2> done = {arc.start}, ahead = {{0, 1}};
  double error_m = 0;
  while (!ahead.empty()) {
    const double own_m = arc.chord_error_m(done.back(), ahead.back(), measure);
    if (own_m > tolerance_m && done.size() + ahead.size() < kMostSectionCorners) {
      ahead.push_back(unit(done.back() + ahead.back()));
      continue;
    }
    error_m = std::max(error_m, own_m);
    done.push_back(ahead.back());
    ahead.pop_back();
  }
  Section section{{}, error_m};
  for (const Vec2 d : done)
    section.corners.push_back({1 + d.x * arc.radii_m.x / size_m.x, (d.y * arc.radii_m.y - arc.depth_m) / size_m.y});
  section.corners.front() = {0, 0};
  section.corners.back() = {1, 1};
  return section;
}

// A knee within the tolerance is left out.
Section knee(Vec2 corner, Vec2 size_m, double tolerance_m) {
  const double off_m = std::abs(corner.y - corner.x) * size_m.y;
  if (off_m <= tolerance_m) return {{{0, 0}, {1, 1}}, off_m};
  return {{{0, 0}, corner, {1, 1}}, 0};
}

Section section_of(RoofForm form, Vec2 size_m, Measure measure, double tolerance_m) {
  assert(size_m.x > 0 && size_m.y > 0 && tolerance_m > 0);
  switch (form) {
    case RoofForm::kGambrel:
      return knee(kGambrelKnee, size_m, tolerance_m);
    case RoofForm::kMansard:
      return knee(kMansardKnee, size_m, tolerance_m);
    case RoofForm::kRound:
    case RoofForm::kDome:
      return flattened(Arc(size_m), size_m, measure, tolerance_m);
    case RoofForm::kOnion:
      return flattened(kOgee, size_m, measure, tolerance_m);
    default:
      return {{{0, 0}, {1, 1}}, 0};
  }
}

}  // namespace

Section section_along(RoofForm form, double span_m, double rise_m, double tolerance_m) {
  return section_of(form, {span_m, rise_m}, Measure::kPerpendicular, tolerance_m);
}

Section section_over_skeleton(RoofForm form, double span_m, double rise_m, double tolerance_m,
                              std::optional<Vec2> corner) {
  if (form == RoofForm::kMansard && corner) return knee(*corner, {span_m, rise_m}, tolerance_m);
  return section_of(form, {span_m, rise_m}, Measure::kVertical, tolerance_m);
}

Section section_over_apex(RoofForm form, double span_m, double reach_m, double rise_m, double tolerance_m) {
  if (form == RoofForm::kOnion) return flattened(kOnion, {reach_m, rise_m}, Measure::kPerpendicular, tolerance_m);
  // the curve is computed over the span; stretched to the reach, its error grows at most by the same factor
  const double stretch = std::max(1.0, reach_m / span_m);
  Section section = section_of(form, {span_m, rise_m}, Measure::kPerpendicular, tolerance_m / stretch);
  section.error_m *= stretch;
  for (Vec2& corner : section.corners) corner.x = 1 - corner.x;
  return section;
}

}  // namespace citykiln::roofs
