#include "compiler/pitches/panels.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "compiler/geometry/snap.h"
#include "compiler/map/plane/clip_ring.h"
#include "compiler/pitches/pitch_lines.h"
#include "compiler/pitches/pitch_rules.h"

namespace citykiln::pitches {
namespace {

// The ground beside a line that its panel shows at the finest tolerances.
constexpr double kMargin_m = 0.0625;
// Sides of panels are multiples of this, the grid of map::clip_ring().
constexpr double kPanelStep_m = 1.0 / 64;
// Parts of lines with other lines near them are joined if they are closer than this.
constexpr double kNear_m = 0.5;
// The longest panel with more than a stripe, and the longest one with a stripe: all land cover beside a panel in a tile
// is in the tile's chunk.
constexpr double kLongest_m = roads::kLayoutLength_m - 0.5, kLongestStripe_m = 32;

// A range of distances along a line.
struct Stretch {
  double from_m, to_m;
};

// A rectangle in the pitch's frame.
struct Rectangle {
  Vec2 middle, along;
  Vec2 half;  // half its length and half its width, multiples of kPanelStep_m
  bool is_plain = false;

  Vec2 local(Vec2 p) const { return {dot(p - middle, along), cross(along, p - middle)}; }
  Vec2 outside(Vec2 p) const { return middle + along * p.x + left_of(along) * p.y; }
  Box2 box() const { return {half * -1.0, half}; }
};

// The lines of a pitch and how panels show them.
struct PitchPaint {
  std::vector<PitchLine> lines;
  double line_m = 0;    // the width of lines
  double half_m = 0;    // half the width of a panel along a line
  double margin_m = 0;  // half_m beside the line
  materials::TextureImage::Texel colour{};
};

double stepped_up(double v) { return std::ceil(v / kPanelStep_m) * kPanelStep_m; }

// The part of a segment, in a rectangle's frame, within |y| <= limit, as a range of x; empty if there is none.
std::optional<Stretch> within_band(Vec2 a, Vec2 b, double limit_m) {
  const double rise = b.y - a.y;
  double from = 0, to = 1;
  if (rise == 0) {
    if (std::abs(a.y) > limit_m) return std::nullopt;
  } else {
    const double first = (-limit_m - a.y) / rise, second = (limit_m - a.y) / rise;
    from = std::max(from, std::min(first, second)), to = std::min(to, std::max(first, second));
    if (from > to) return std::nullopt;
  }
  const double x0 = a.x + (b.x - a.x) * from, x1 = a.x + (b.x - a.x) * to;
  return Stretch{std::min(x0, x1), std::max(x0, x1)};
}

// Joins ranges that are near each other. Sorted.
std::vector<Stretch> joined(std::vector<Stretch> stretches) {
  std::ranges::sort(stretches, {}, [](const Stretch& s) { return std::pair(s.from_m, s.to_m); });
  std::vector<Stretch> kept;
  for (const Stretch& stretch : stretches) {
    if (!kept.empty() && stretch.from_m < kept.back().to_m + kNear_m)
      kept.back().to_m = std::max(kept.back().to_m, stretch.to_m);
    else
      kept.push_back(stretch);
  }
  return kept;
}

// The ranges of a straight line, from 0 to its length, in which a panel along it shows more than a stripe.
std::vector<Stretch> busy_stretches(const PitchPaint& paint, std::size_t own_line, std::size_t own_chord) {
  const Vec2 a = paint.lines[own_line].path[own_chord], b = paint.lines[own_line].path[own_chord + 1];
  const Rectangle frame{a, unit(b - a), {}};
  const double length_m = distance(a, b), around_m = paint.line_m / 2 + paint.margin_m;
  // both ends, since a panel shows where a line ends or bends
  std::vector<Stretch> busy = {{-paint.half_m, paint.half_m}, {length_m - paint.half_m, length_m + paint.half_m}};
  for (std::size_t i = 0; i < paint.lines.size(); ++i) {
    const Polyline& path = paint.lines[i].path;
    for (std::size_t c = 0; c + 1 < path.size(); ++c) {
      if (i == own_line && c == own_chord) continue;
      const auto near = within_band(frame.local(path[c]), frame.local(path[c + 1]), paint.half_m + paint.line_m / 2);
      if (!near) continue;
      const Stretch wide{std::max(near->from_m - around_m, -paint.half_m),
                         std::min(near->to_m + around_m, length_m + paint.half_m)};
      if (wide.from_m < wide.to_m) busy.push_back(wide);
    }
  }
  return joined(std::move(busy));
}

Rectangle along_line(const PitchPaint& paint, Vec2 a, Vec2 b, Stretch stretch, bool is_plain) {
  const Vec2 along = unit(b - a);
  return {a + along * ((stretch.from_m + stretch.to_m) / 2),
          along,
          {stepped_up((stretch.to_m - stretch.from_m) / 2), stepped_up(paint.half_m)},
          is_plain};
}

void add_parts(const PitchPaint& paint, Vec2 a, Vec2 b, Stretch stretch, bool is_plain,
               std::vector<Rectangle>& rectangles) {
  const double length_m = stretch.to_m - stretch.from_m,
               parts = std::ceil(length_m / (is_plain ? kLongestStripe_m : kLongest_m));
  for (double i = 0; i < parts; ++i)
    rectangles.push_back(along_line(
        paint, a, b, {stretch.from_m + length_m * i / parts, stretch.from_m + length_m * (i + 1) / parts}, is_plain));
}

// A broken line is cut into parts of whole dashes and gaps, which share a layout.
void add_between(const PitchPaint& paint, const PitchLine& line, Vec2 a, Vec2 b, Stretch stretch,
                 std::vector<Rectangle>& rectangles) {
  if (line.dash_m == 0) return add_parts(paint, a, b, stretch, true, rectangles);
  const double period_m = line.dash_m + line.gap_m,
               part_m = std::max(1.0, std::floor(kLongest_m / period_m)) * period_m;
  for (double from_m = stretch.from_m; from_m < stretch.to_m; from_m += part_m)
    add_parts(paint, a, b, {from_m, std::min(from_m + part_m, stretch.to_m)}, false, rectangles);
}

void add_straight(const PitchPaint& paint, std::size_t line, std::vector<Rectangle>& rectangles) {
  const Polyline& path = paint.lines[line].path;
  for (std::size_t c = 0; c + 1 < path.size(); ++c) {
    if (path[c] == path[c + 1]) continue;
    double reached_m = 0;
    for (const Stretch& busy : busy_stretches(paint, line, c)) {
      if (busy.from_m > reached_m)
        add_between(paint, paint.lines[line], path[c], path[c + 1], {reached_m, busy.from_m}, rectangles);
      add_parts(paint, path[c], path[c + 1], busy, false, rectangles);
      reached_m = busy.to_m;
    }
  }
}

// The rectangle around points, with a direction.
Rectangle around(std::span<const Vec2> points, Vec2 along, double margin_m) {
  const Rectangle frame{points.front(), along, {}};
  Box2 box;
  for (const Vec2 p : points) box.grow(frame.local(p));
  return {frame.outside(box.centre()),
          along,
          {stepped_up(box.width() / 2 + margin_m), stepped_up(box.height() / 2 + margin_m)}};
}

void add_arc(const PitchPaint& paint, const PitchLine& line, std::vector<Rectangle>& rectangles) {
  const std::span<const Vec2> path = line.path;
  for (std::size_t from = 0; from + line.section_chords < path.size(); from += line.section_chords) {
    const std::span<const Vec2> section = path.subspan(from, line.section_chords + 1);
    rectangles.push_back(around(section, unit(section.back() - section.front()), paint.half_m));
  }
}

bool holds(const Rectangle& outer, const Rectangle& inner) {
  constexpr double kSlack_m = 1e-6;
  if (outer.is_plain) return false;
  for (const double x : {-inner.half.x, inner.half.x})
    for (const double y : {-inner.half.y, inner.half.y}) {
      const Vec2 p = outer.local(inner.outside({x, y}));
      if (std::abs(p.x) > outer.half.x + kSlack_m || std::abs(p.y) > outer.half.y + kSlack_m) return false;
    }
  return true;
}

// All rectangles, without those that lie within another one which shows the same.
std::vector<Rectangle> rectangles_of(const PitchPaint& paint) {
  std::vector<Rectangle> all, kept;
  for (const PitchLine& line : paint.lines) {
    if (line.is_disc) all.push_back(around(line.path, {1, 0}, paint.margin_m));
    if (!line.is_disc && line.section_chords > 1) add_arc(paint, line, all);
  }
  for (std::size_t i = 0; i < paint.lines.size(); ++i)
    if (paint.lines[i].section_chords == 1) add_straight(paint, i, all);
  for (const Rectangle& each : all)
    if (std::ranges::none_of(kept, [&](const Rectangle& before) { return holds(before, each); })) kept.push_back(each);
  return kept;
}

// The parts of a line that are painted: the whole path or its dashes.
std::vector<Polyline> strokes_of(const PitchLine& line) {
  if (line.dash_m == 0) return {line.path};
  std::vector<Polyline> dashes;
  const Vec2 a = line.path.front(), b = line.path.back(), along = unit(b - a);
  for (double at_m = 0; at_m < distance(a, b); at_m += line.dash_m + line.gap_m)
    dashes.push_back({a + along * at_m, a + along * std::min(at_m + line.dash_m, distance(a, b))});
  return dashes;
}

// The parts of a path whose chords come near a box.
std::vector<Polyline> parts_near(const Polyline& path, const Box2& near) {
  std::vector<Polyline> parts;
  bool goes_on = false;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const bool is_near = path[i] != path[i + 1] && box_of(std::span(path).subspan(i, 2)).touches(near);
    if (is_near && !goes_on) parts.push_back({path[i]});
    if (is_near) parts.back().push_back(path[i + 1]);
    goes_on = is_near;
  }
  return parts;
}

// A ring in a rectangle's frame as a mark of its layout, whose middle is that of the rectangle.
void add_mark(const PitchPaint& paint, const Rectangle& rectangle, const Ring& ring, roads::Marks& marks) {
  roads::Mark mark{map::clip_ring(ring, rectangle.box()), paint.colour};
  for (Vec2& p : mark.ring) p = Vec2{rectangle.half.y, roads::kLayoutLength_m / 2} + Vec2{snapped(-p.y), snapped(p.x)};
  if (mark.ring.size() < 3) return;
  std::rotate(mark.ring.begin(), std::ranges::min_element(mark.ring), mark.ring.end());
  marks.push_back(std::move(mark));
}

roads::Marks marks_within(const PitchPaint& paint, const Rectangle& rectangle) {
  const Box2 near = rectangle.box().widened(2 * paint.line_m);
  roads::Marks marks;
  for (const PitchLine& line : paint.lines)
    for (Polyline path : strokes_of(line)) {
      for (Vec2& p : path) p = rectangle.local(p);
      if (line.is_disc) {
        if (box_of(path).touches(near)) add_mark(paint, rectangle, {path.begin(), path.end() - 1}, marks);
        continue;
      }
      for (const Polyline& part : parts_near(path, near))
        add_mark(paint, rectangle, roads::stroke(part, paint.line_m), marks);
    }
  std::ranges::sort(marks, {}, &roads::Mark::ring);
  return marks;
}

roads::Marks stripe(const PitchPaint& paint, const Rectangle& rectangle) {
  return {{roads::rectangle({rectangle.half.y - paint.line_m / 2, 0},
                            {rectangle.half.y + paint.line_m / 2, roads::kLayoutLength_m}),
           paint.colour}};
}

roads::PieceFrame frame_of_piece(const Rectangle& rectangle, const PitchFrame& frame) {
  const Vec2 along = frame.in_plane(rectangle.along) - frame.middle;
  const double half_m = rectangle.half.x, middle_m = roads::kLayoutLength_m / 2, side_m = rectangle.half.y;
  return {.at = frame.in_plane(rectangle.middle - rectangle.along * half_m),
          .along = along,
          .width_m = 2 * side_m,
          .start = {side_m, -side_m, 0, 0, middle_m - half_m},
          .end = {side_m, -side_m, 2 * half_m, 2 * half_m, middle_m + half_m}};
}

Panel panel_of(const PitchPaint& paint, const Rectangle& rectangle, const PitchFrame& frame,
               map::LandCoverClass surface) {
  Panel panel{{}, frame_of_piece(rectangle, frame), {}};
  const Vec2 half = rectangle.half;
  for (const Vec2 corner : {half * -1.0, Vec2{half.x, -half.y}, half, Vec2{-half.x, half.y}})
    panel.ring.push_back(snapped(frame.in_plane(rectangle.outside(corner))));
  panel.layout.surface = surface;
  panel.layout.panel_m = 2 * half.y;
  panel.layout.panel = rectangle.is_plain ? stripe(paint, rectangle) : marks_within(paint, rectangle);
  return panel;
}

// True if an edge may cross a box.
bool has_edge_near(const Ring& ring, const Box2& box) {
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    if (!box_of_segment(ring[j], ring[i]).touches(box)) continue;
    const Vec2 edge = ring[i] - ring[j];
    int left = 0, right = 0;
    for (const Vec2 corner : {box.min, Vec2{box.max.x, box.min.y}, box.max, Vec2{box.min.x, box.max.y}})
      (cross(edge, corner - ring[j]) > 0 ? left : right) += 1;
    if (left > 0 && right > 0) return true;
  }
  return false;
}

}  // namespace

std::vector<Panel> panels_of(const Pitch& pitch, map::LandCoverClass surface, double tolerance_m) {
  assert(pitch.from != pitch.to && tolerance_m >= 0);
  const LineStyle style = rules_of(pitch.kind).line;
  PitchPaint paint{.lines = lines_of(pitch), .line_m = style.width_m, .colour = style.colour};
  paint.margin_m = std::max(kMargin_m, 1.5 * tolerance_m - style.width_m / 2);
  paint.half_m = style.width_m / 2 + paint.margin_m;
  std::vector<Panel> panels;
  for (const Rectangle& rectangle : rectangles_of(paint))
    panels.push_back(panel_of(paint, rectangle, frame_of(pitch), surface));
  return panels;
}

std::vector<Ring> rings_within(const Panel& panel, const std::vector<Ring>& rings) {
  const roads::PieceFrame& frame = panel.frame;
  const Box2 box{{0, -frame.width_m / 2}, {frame.end.left_along_m, frame.width_m / 2}};
  const Box2 near = box_of(panel.ring);
  std::vector<Ring> local;
  for (const Ring& ring : rings) {
    local.push_back(trimmed_to(ring, near));
    for (Vec2& p : local.back()) p = {dot(p - frame.at, frame.along), cross(frame.along, p - frame.at)};
  }
  if (std::ranges::none_of(local, [&](const Ring& ring) { return has_edge_near(ring, box.widened(0.01)); })) {
    int winding = 0;
    for (const Ring& ring : local) winding += winding_number(ring, box.centre());
    return winding > 0 ? std::vector<Ring>{panel.ring} : std::vector<Ring>{};
  }
  std::vector<Ring> within;
  for (const Ring& ring : local) {
    Ring clipped = map::clip_ring(ring, box);
    for (Vec2& p : clipped) p = snapped(frame.at + frame.along * p.x + left_of(frame.along) * p.y);
    clipped = without_repeats(clipped);
    if (clipped.size() >= 3) within.push_back(std::move(clipped));
  }
  return within;
}

}  // namespace citykiln::pitches
