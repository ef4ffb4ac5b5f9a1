#include "compiler/roads/pieces/pieces.h"

#include <algorithm>
#include <cassert>

#include "compiler/geometry/snap.h"
#include "compiler/roads/markings/markings.h"
#include "compiler/roads/pieces/cross_lines.h"
#include "compiler/roads/width_limits/narrowed_section.h"

namespace citykiln::roads {
namespace {

using map::LandCoverClass;

Vec2 point_on(const CrossLine& line, double offset_m) { return snapped(line.at + line.out * offset_m); }

// The offsets of a strip's edges from the axis, to the left positive.
struct StripEdges {
  double left_m, right_m;
};

// The end of a piece at a line across the segment.
PieceEnd end_of(const Slice& slice, const CrossLine& line, StripEdges edges, double zero_m) {
  const auto along = [&](double offset_m) { return dot(line.at + line.out * offset_m - slice.start.at, slice.along); };
  return {.left_m = edges.left_m,
          .right_m = edges.right_m,
          .left_along_m = along(edges.left_m),
          .right_along_m = along(edges.right_m),
          .v_m = line.along_m - zero_m};
}

Ring ring_of(const Slice& slice, StripEdges start, StripEdges end) {
  return {point_on(slice.start, start.right_m), point_on(slice.end, end.right_m), point_on(slice.end, end.left_m),
          point_on(slice.start, start.left_m)};
}

bool is_crossing(StretchKind stretch) { return stretch == StretchKind::kZebra || stretch == StretchKind::kCrossing; }

// The class of a strip within a stretch: crossings cover all lanes between the kerbs, and verges in front of them
// become pavement.
LandCoverClass strip_surface_of(const Road& road, const LaneStrip& strip, StretchKind stretch) {
  if (stretch == StretchKind::kLevelCrossing) return LandCoverClass::kLevelCrossing;
  if (is_crossing(stretch) && strip.surface == LandCoverClass::kVerge) return LandCoverClass::kPavement;
  return is_crossing(stretch) && strip.surface == road.surface ? LandCoverClass::kCrossing : strip.surface;
}

MarkingLayout marking_layout_of(const Road& road, const LaneStrip& strip, const RoadStretch& run) {
  return {.surface = strip.surface,
          .lanes = strip.lanes,
          .stretch = run.stretch,
          .control = run.control,
          .side = road.side,
          .has_kerb_left = strip.has_kerb_left,
          .has_kerb_right = strip.has_kerb_right};
}

// The edges of all strips at a distance along the road, within its width limits.
std::vector<StripEdges> edges_at(const Road& road, const std::vector<LaneStrip>& strips, double along_m) {
  std::vector<StripEdges> edges;
  if (road.width_limits.is_empty()) {
    for (const LaneStrip& strip : strips) edges.push_back({strip.left_m, strip.right_m});
    return edges;
  }
  const LaneEdges lanes = lane_edges_at(road, along_m);
  for (const LaneStrip& strip : strips) edges.push_back({lanes.moved(strip.left_m), lanes.moved(strip.right_m)});
  return edges;
}

// State while the pieces of a road are made.
struct PieceBuilder {
  const Road& road;
  std::span<const RoadStretch> stretches;
  std::vector<LaneStrip> strips;
  RoadPieces made{};
  std::vector<std::uint32_t> layouts{};  // one for each strip and stretch

  void find_patterns() {
    for (const LaneStrip& strip : strips)
      for (const RoadStretch& run : stretches) {
        layouts.push_back(kNoMarkingLayout);
        MarkingLayout layout = marking_layout_of(road, strip, run);
        // crossings are painted between the kerbs only
        const bool is_beside = strip.lanes.empty() || (is_crossing(run.stretch) && strip.lanes.front().is_raised);
        if (is_beside || !is_marked(layout)) continue;
        layouts.back() = static_cast<std::uint32_t>(made.layouts.size());
        made.layouts.push_back(std::move(layout));
      }
  }

  void add(std::size_t strip, const Slice& slice, StripEdges start, StripEdges end, Ring ring) {
    ring = without_repeats(ring);
    if (ring.size() < 3) return;
    if (signed_area_m2(ring) < 0) std::ranges::reverse(ring);
    if (signed_area_m2(ring) == 0) return;
    const auto number = static_cast<std::uint32_t>(strip * stretches.size() + slice.stretch);
    const RoadStretch& run = stretches[slice.stretch];
    const LaneStrip& whole = strips[strip];
    const PieceFrame frame{.at = slice.start.at,
                           .along = slice.along,
                           .width_m = whole.left_m - whole.right_m,
                           .start = end_of(slice, slice.start, start, run.zero_m),
                           .end = end_of(slice, slice.end, end, run.zero_m)};
    made.pieces.push_back({.surface = strip_surface_of(road, whole, run.stretch),
                           .ring = std::move(ring),
                           .frame = frame,
                           .layout = layouts[number],
                           .run = number});
  }
};

// The wedge on the outside of an open bend, or the area around the point where a road turns back. It is part of the
// slice beside it.
Ring joint_of(const OpenBend& bend, StripEdges edges) {
  const bool bends_left = cross(bend.before, bend.after) > 0;
  // the outer and the inner edge, as far as they lie outside the bend
  const double outer = bends_left ? std::min(0.0, edges.right_m) : std::max(0.0, edges.left_m);
  const double inner = bends_left ? std::min(0.0, edges.left_m) : std::max(0.0, edges.right_m);
  const auto corner = [&](Vec2 direction, double offset) { return snapped(bend.at + left_of(direction) * offset); };
  const Vec2 middle = unit(left_of(bend.before) + left_of(bend.after));
  Ring ring = {corner(bend.before, inner), corner(bend.before, outer), snapped(bend.at + middle * outer),
               corner(bend.after, outer), corner(bend.after, inner)};
  if (inner != 0) ring.push_back(snapped(bend.at + middle * inner));
  return ring;
}

// Adds all strips of a slice and the joints of the bends beside it.
void add_slice(const Slice& slice, std::span<const OpenBend> bends, PieceBuilder& builder) {
  const auto start = edges_at(builder.road, builder.strips, slice.start.along_m);
  const auto end = edges_at(builder.road, builder.strips, slice.end.along_m);
  for (std::size_t s = 0; s < builder.strips.size(); ++s)
    builder.add(s, slice, start[s], end[s], ring_of(slice, start[s], end[s]));
  for (const OpenBend& bend : bends)
    for (std::size_t s = 0; s < builder.strips.size(); ++s)
      builder.add(s, slice, start[s], end[s], joint_of(bend, bend.at == slice.start.at ? start[s] : end[s]));
}

// The share of the piece's length, 0 to 1, at which `off` lies, for given edges of the strip.
double passed_at(const PieceFrame& frame, StripEdges edges, Vec2 off) {
  const double width = edges.left_m - edges.right_m, offset = dot(off, left_of(frame.along));
  const double share = width > 0 ? (edges.left_m - offset) / width : 0;
  const auto across = [&](const PieceEnd& e) { return e.left_along_m + (e.right_along_m - e.left_along_m) * share; };
  const double start = across(frame.start), end = across(frame.end);
  return end > start ? std::clamp((dot(off, frame.along) - start) / (end - start), 0.0, 1.0) : 0;
}

StripEdges edges_between(const PieceFrame& frame, double passed) {
  return {frame.start.left_m + (frame.end.left_m - frame.start.left_m) * passed,
          frame.start.right_m + (frame.end.right_m - frame.start.right_m) * passed};
}

}  // namespace

Vec2 uv_at(const PieceFrame& frame, Vec2 p) {
  const Vec2 off = p - frame.at;
  // edges depend on the share along the piece, which at a leaning end depends on the offset: three fixed-point steps
  double passed = 0;
  for (int round = 0; round < 3; ++round) passed = passed_at(frame, edges_between(frame, passed), off);
  const StripEdges edges = edges_between(frame, passed);
  const double width = edges.left_m - edges.right_m;
  const double u = edges.left_m - dot(off, left_of(frame.along));
  return {width > 0 ? u * (frame.width_m / width) : 0, frame.start.v_m + passed * (frame.end.v_m - frame.start.v_m)};
}

RoadPieces pieces_of(const Road& road, const StripEnds& ends, std::span<const RoadStretch> stretches, double tile_m,
                     double tolerance_m) {
  assert(road.axis.size() >= 2 && tile_m > 0 && tolerance_m >= 0);
  PieceBuilder builder{road, stretches, strips_of(road, tolerance_m)};
  if (builder.strips.empty() || stretches.empty()) return {};
  builder.find_patterns();
  const double left = std::max(0.0, builder.strips.front().left_m),
               right = std::max(0.0, -builder.strips.back().right_m);
  const Slices all = slices_of(road, ends, stretches, left, right, tile_m);
  auto bend = all.bends.begin();
  for (std::uint32_t i = 0; i < all.slices.size(); ++i) {
    const auto first = bend;
    while (bend != all.bends.end() && bend->slice == i) ++bend;
    add_slice(all.slices[i], {first, bend}, builder);
  }
  return std::move(builder.made);
}

}  // namespace citykiln::roads
