#include "compiler/assume/curves/curved_line.h"

#include <algorithm>
#include <cstddef>

#include "compiler/geometry/box.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/curved_chord.h"
#include "compiler/geometry/segment.h"

namespace citykiln::assume {
namespace {

/// Shorter chords stay straight.
constexpr double kShortestChord_m = 1;

// The curve of a chord with both of its ends.
Polyline curve_of(Vec2 a, Vec2 b, const Slopes& slopes, const ChordLimits& limits) {
  const CurveLimits keep{.most_m = limits.most_m, .reach_m = limits.reach_m, .error_m = limits.error_m};
  const double length_m = distance(a, b);
  // both directions fit the same chord
  const CurvedChord chord = b < a ? reversed(fitted_chord(length_m, slopes.arrive, slopes.leave, keep))
                                  : fitted_chord(length_m, slopes.leave, slopes.arrive, keep);
  Polyline curve = {a};
  const Polyline between = points_between(chord, a, b);
  curve.insert(curve.end(), between.begin(), between.end());
  curve.push_back(b);
  return curve;
}

// The number of crossings of segments that are not neighbours.
std::size_t crossings_of(const Polyline& axis) {
  std::vector<Box2> boxes;
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) boxes.push_back(box_of_segment(axis[i], axis[i + 1]));
  const BoxGrid grid = grid_of(boxes, 32);
  std::size_t crossings = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (const std::uint32_t j : boxes_about(grid, boxes[i])) {
      const bool is_apart = j > i + 1 && boxes[i].touches(boxes[j]);
      // closed lines touch themselves at their ends
      if (is_apart && axis[i] != axis[j + 1] && crossing_shares(axis[i], axis[i + 1], axis[j], axis[j + 1]))
        ++crossings;
    }
  return crossings;
}

CurvedLine as_mapped(const CurvableLine& line) {
  CurvedLine same{.axis = {line.axis.begin(), line.axis.end()}, .mapped = {}};
  for (std::uint32_t p = 0; p < line.axis.size(); ++p) same.mapped.push_back(p);
  return same;
}

}  // namespace

std::vector<CurvedLine> curved_lines(std::span<const CurvableLine> lines, const HasRoom& has_room) {
  const std::vector<std::vector<Slopes>> slopes = slopes_of(lines);
  std::vector<CurvedLine> curved;
  for (std::size_t l = 0; l < lines.size(); ++l) {
    const CurvableLine& line = lines[l];
    CurvedLine whole{.axis = {line.axis[0]}, .mapped = {0}};
    for (std::size_t c = 0; c + 1 < line.axis.size(); ++c) {
      const Vec2 a = line.axis[c], b = line.axis[c + 1];
      const bool may_bend = slopes[l][c] != Slopes{} && line.chords[c].most_m > 0 && distance(a, b) >= kShortestChord_m;
      Polyline curve = may_bend ? curve_of(a, b, slopes[l][c], line.chords[c]) : Polyline{a, b};
      if (curve.size() > 2 && !has_room(l, c, curve)) curve = {a, b};
      whole.axis.insert(whole.axis.end(), curve.begin() + 1, curve.end());
      whole.mapped.push_back(static_cast<std::uint32_t>(whole.axis.size() - 1));
    }
    const bool is_sound = !whole.is_curved() || crossings_of(whole.axis) == 0 ||
                          crossings_of(whole.axis) <= crossings_of({line.axis.begin(), line.axis.end()});
    curved.push_back(is_sound ? std::move(whole) : as_mapped(line));
  }
  return curved;
}

}  // namespace citykiln::assume
