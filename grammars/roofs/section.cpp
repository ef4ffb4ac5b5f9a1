#include "grammars/roofs/section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace citykiln::roofs {
namespace {

using Bezier = std::array<Vec2, 4>;

// The silhouette of an onion from its neck to its tip; x over the neck's radius, y over the rise. The two pieces share
// a tangent.
constexpr std::array kOnion = {Bezier{{{1, 0}, {1.25, 0.08}, {1.25, 0.30}, {0.95, 0.42}}},
                               Bezier{{{0.95, 0.42}, {0.55, 0.58}, {0.12, 0.66}, {0, 1}}}};
// What an onion is where nothing may swell: an ogee.
constexpr std::array kOgee = {Bezier{{{0, 0}, {0, 0.3}, {0.2, 0.45}, {0.5, 0.55}}},
                              Bezier{{{0.5, 0.55}, {0.8, 0.65}, {0.93, 0.7}, {1, 1}}}};
// Steep below, shallow above: how far in, and how high, the knee is.
constexpr Vec2 kGambrelKnee = {0.4, 0.65}, kMansardKnee = {0.35, 0.75};

Vec2 scaled(Vec2 p, Vec2 size_m) { return {p.x * size_m.x, p.y * size_m.y}; }

Vec2 at(const Bezier& b, double t) {
  const double s = 1 - t;
  return b[0] * (s * s * s) + b[1] * (3 * s * s * t) + b[2] * (3 * s * t * t) + b[3] * (t * t * t);
}

// A chord over 1/n of a cubic is off by at most an eighth of the second derivative over n².
double bend_m(const Bezier& b, Vec2 size_m) {
  const Vec2 start = (b[0] - b[1] * 2 + b[2]) * 6, end = (b[1] - b[2] * 2 + b[3]) * 6;
  return std::max(length(scaled(start, size_m)), length(scaled(end, size_m))) / 8;
}

Section flattened(std::span<const Bezier> pieces, Vec2 size_m, double tolerance_m) {
  Section section{{pieces.front()[0]}, 0};
  for (const Bezier& piece : pieces) {
    const double bend = bend_m(piece, size_m);
    const double n = std::clamp(std::ceil(std::sqrt(bend / tolerance_m)), 1.0, 64.0);
    for (double i = 1; i <= n; ++i) section.corners.push_back(at(piece, i / n));
    section.error_m = std::max(section.error_m, bend / (n * n));
  }
  return section;
}

// An arc from the eaves, straight up or less, to the level top, as directions from its centre; halved until flat
// enough.
Section arc(Vec2 size_m, double tolerance_m) {
  const bool is_circle = size_m.y <= size_m.x;
  const double radius_m =
      is_circle ? (size_m.x * size_m.x + size_m.y * size_m.y) / (2 * size_m.y) : std::max(size_m.x, size_m.y);
  const double depth = is_circle ? radius_m - size_m.y : 0;  // of the centre below the eaves
  std::vector<Vec2> arc = {is_circle ? Vec2{-size_m.x / radius_m, depth / radius_m} : Vec2{-1, 0}, {0, 1}};
  const auto sag_m = [&] { return radius_m * (1 - length(arc[0] + arc[1]) / 2); };
  while (sag_m() > tolerance_m && arc.size() < 65) {
    std::vector<Vec2> finer;
    for (std::size_t i = 0; i + 1 < arc.size(); ++i) {
      finer.push_back(arc[i]);
      finer.push_back(unit(arc[i] + arc[i + 1]));
    }
    finer.push_back(arc.back());
    arc = std::move(finer);
  }
  const double wide_m = is_circle ? radius_m : size_m.x, high_m = is_circle ? radius_m : size_m.y;
  Section section{{}, sag_m()};
  for (const Vec2 d : arc) section.corners.push_back({1 + d.x * wide_m / size_m.x, (d.y * high_m - depth) / size_m.y});
  section.corners.front() = {0, 0};
  section.corners.back() = {1, 1};
  return section;
}

// A knee that the tolerance does not see is left out.
Section knee(Vec2 corner, Vec2 size_m, double tolerance_m) {
  const double off_m = (corner.y - corner.x) * size_m.y;
  if (off_m <= tolerance_m) return {{{0, 0}, {1, 1}}, off_m};
  return {{{0, 0}, corner, {1, 1}}, 0};
}

}  // namespace

Section section_of(Form form, double span_m, double rise_m, double tolerance_m) {
  const Vec2 size_m = {span_m, rise_m};
  switch (form) {
    case Form::kGambrel:
      return knee(kGambrelKnee, size_m, tolerance_m);
    case Form::kMansard:
      return knee(kMansardKnee, size_m, tolerance_m);
    case Form::kRound:
    case Form::kDome:
      return arc(size_m, tolerance_m);
    case Form::kOnion:
      return flattened(kOgee, size_m, tolerance_m);
    default:
      return {{{0, 0}, {1, 1}}, 0};
  }
}

Section section_over_pole(Form form, double span_m, double rise_m, double tolerance_m) {
  if (form == Form::kOnion) return flattened(kOnion, {span_m, rise_m}, tolerance_m);
  Section section = section_of(form, span_m, rise_m, tolerance_m);
  for (Vec2& corner : section.corners) corner.x = 1 - corner.x;
  return section;
}

}  // namespace citykiln::roofs
