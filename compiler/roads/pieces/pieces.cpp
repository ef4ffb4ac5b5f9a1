#include "compiler/roads/pieces/pieces.h"

#include <algorithm>
#include <cassert>

#include "compiler/geometry/snap.h"
#include "compiler/roads/markings/marking_rules.h"
#include "compiler/roads/markings/markings.h"
#include "compiler/roads/pieces/cross_lines.h"
#include "compiler/roads/pieces/tactile_paving.h"
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

// True where people walk from the pavement to the kerb: at crossings and, in towns, at corners. American verges lead up
// to the corner.
bool is_walked_over(const Road& road, const RoadStretch& run) {
  if (is_crossing(run.stretch) || run.traits != 0) return true;
  const bool is_at_corner = run.stretch == StretchKind::kStart || run.stretch == StretchKind::kEnd;
  return is_at_corner && practice_of(road.country) != MarkingPractice::kAmerican;
}

// The class of a strip within a stretch: crossings cover all lanes between the kerbs, and verges where people walk over
// them become pavement.
LandCoverClass strip_surface_of(const Road& road, const LaneStrip& strip, const RoadStretch& run) {
  if (run.stretch == StretchKind::kLevelCrossing) return LandCoverClass::kLevelCrossing;
  if (is_walked_over(road, run) && strip.surface == LandCoverClass::kVerge) return LandCoverClass::kPavement;
  return is_crossing(run.stretch) && strip.surface == road.surface ? LandCoverClass::kCrossing : strip.surface;
}

MarkingLayout marking_layout_of(const Road& road, const LaneStrip& strip, const RoadStretch& run) {
  return {.surface = strip.surface,
          .lanes = strip.lanes,
          .stretch = run.stretch,
          .control = run.control,
          .side = road.side,
          .practice = practice_of(road.country),
          .has_kerb_left = strip.has_kerb_left,
          .has_kerb_right = strip.has_kerb_right};
}

// Leads the edges of lanes to those of the next road.
void lead(LaneEdges& lanes, const LaneChange& change, double along_m) {
  const double share = change.share_at(along_m);
  if (share <= 0) return;
  for (std::size_t i = 0; i < lanes.moved_m.size(); ++i)
    lanes.moved_m[i] += (change.offsets_m[i] - lanes.moved_m[i]) * share;
}

// The edges of all lanes at a distance along the road, within its width limits and lane changes.
LaneEdges led_lanes_at(const Road& road, std::span<const LaneChange> changes, double along_m) {
  LaneEdges lanes = lane_edges_at(road, along_m);
  for (const LaneChange& change : changes) lead(lanes, change, along_m);
  return lanes;
}

// The edges of all strips at a distance along the road, within its width limits and lane changes.
std::vector<StripEdges> edges_at(const Road& road, const std::vector<LaneStrip>& strips,
                                 std::span<const LaneChange> changes, double along_m) {
  std::vector<StripEdges> edges;
  const bool is_led = std::ranges::any_of(changes, [&](const LaneChange& c) { return c.share_at(along_m) > 0; });
  if (road.width_limits.is_empty() && road.section.axis_drift == 0 && !is_led) {
    for (const LaneStrip& strip : strips) edges.push_back({strip.left_m, strip.right_m});
    return edges;
  }
  const LaneEdges lanes = led_lanes_at(road, changes, along_m);
  for (const LaneStrip& strip : strips) edges.push_back({lanes.moved(strip.left_m), lanes.moved(strip.right_m)});
  return edges;
}

// State while the pieces of a road are made.
struct PieceBuilder {
  const Road& road;
  std::span<const RoadStretch> stretches;
  std::span<const LaneChange> changes;
  std::vector<LaneStrip> strips;
  RoadPieces made{};
  std::vector<std::uint32_t> layouts{};  // one for each strip and stretch
  std::vector<std::uint32_t> slabs{};    // the layouts of slabs beside the kerb, one for each strip and stretch

  bool is_kerb(std::size_t strip) const {
    return strip < strips.size() && strips[strip].surface == LandCoverClass::kKerb;
  }

  // The depth of slabs in a strip; 0 without slabs.
  double slab_depth_m(std::size_t strip, const RoadStretch& run) const {
    constexpr double kLeastBehind_m = 0.25;
    if ((run.traits & map::kTactileSlabs) == 0 || (run.traits & map::kRaisedKerb) != 0) return 0;
    const LaneStrip& whole = strips[strip];
    const bool is_beside_kerb = is_kerb(strip - 1) || is_kerb(strip + 1);
    if (!is_beside_kerb || whole.lanes.empty() || !whole.lanes.front().is_raised) return 0;
    if (whole.surface != LandCoverClass::kPavement && whole.surface != LandCoverClass::kVerge) return 0;
    const double room_m = whole.left_m - whole.right_m - kLeastBehind_m;
    return room_m < kTactileDepth_m / 2 ? 0 : std::min(kTactileDepth_m, room_m);
  }

  void find_slabs() {
    for (std::size_t s = 0; s < strips.size(); ++s)
      for (const RoadStretch& run : stretches) {
        slabs.push_back(kNoMarkingLayout);
        const double depth_m = slab_depth_m(s, run);
        if (depth_m == 0) continue;
        slabs.back() = static_cast<std::uint32_t>(made.layouts.size());
        made.layouts.push_back(tactile_layout(road.country, run.stretch, depth_m));
      }
  }

  void find_patterns() {
    for (const LaneStrip& strip : strips)
      for (const RoadStretch& run : stretches) {
        layouts.push_back(kNoMarkingLayout);
        MarkingLayout layout = marking_layout_of(road, strip, run);
        // crossings are painted between the kerbs only
        const bool is_beside = strip.lanes.empty() || (is_crossing(run.stretch) && strip.lanes.front().is_raised);
        if (is_beside || !needs_column(layout)) continue;
        layouts.back() = static_cast<std::uint32_t>(made.layouts.size());
        made.layouts.push_back(std::move(layout));
      }
  }

  // True for marked strips between the kerbs.
  bool has_lines(std::size_t strip, const Slice& slice) const {
    const std::vector<map::Lane>& lanes = strips[strip].lanes;
    return !lanes.empty() && !lanes.front().is_raised &&
           layouts[strip * stretches.size() + slice.stretch] != kNoMarkingLayout;
  }

  void add(std::size_t strip, const Slice& slice, StripEdges start, StripEdges end, Ring ring) {
    add(strip, {strips[strip].left_m, strips[strip].right_m}, slice, start, end, std::move(ring));
  }

  // @param band  The edges of the strip, or of a part of it, at full width.
  void add(std::size_t strip, StripEdges band, const Slice& slice, StripEdges start, StripEdges end, Ring ring) {
    ring = without_repeats(ring);
    if (ring.size() < 3) return;
    if (signed_area_m2(ring) < 0) std::ranges::reverse(ring);
    if (signed_area_m2(ring) == 0) return;
    const auto number = static_cast<std::uint32_t>(strip * stretches.size() + slice.stretch);
    const RoadStretch& run = stretches[slice.stretch];
    const LaneStrip& whole = strips[strip];
    const PieceFrame frame{.at = slice.start.at,
                           .along = slice.along,
                           .width_m = band.left_m - band.right_m,
                           .left_u_m = whole.left_m - band.left_m,
                           .start = end_of(slice, slice.start, start, run.zero_m),
                           .end = end_of(slice, slice.end, end, run.zero_m)};
    made.pieces.push_back({.surface = strip_surface_of(road, whole, run),
                           .ring = std::move(ring),
                           .frame = frame,
                           .layout = layouts[number],
                           .run = number});
  }

  // Makes the last piece one of slabs, if one was added.
  void show_slabs(std::size_t strip, const Slice& slice, std::size_t pieces_before) {
    if (made.pieces.size() == pieces_before) return;
    const std::size_t number = strip * stretches.size() + slice.stretch;
    Piece& piece = made.pieces.back();
    piece.surface = LandCoverClass::kPavement;
    piece.layout = slabs[number];
    piece.frame.left_u_m = 0;
    piece.run = static_cast<std::uint32_t>(slabs.size() + number);
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

// ---- lane changes ---------------------------------------------------------------------------------------------------

// Lines beside a lane that widens keep their width: its margins do not widen.
constexpr double kMargin_m = 0.5;

double margin_m(double width_m) { return std::min(kMargin_m, width_m / 4); }

// The edges of the parts of a strip whose lanes widen or narrow differently, at full width, left to right.
std::vector<double> band_edges_of(const LaneStrip& strip, const LaneEdges& lanes, const LaneChange& change) {
  std::vector<double> edges_m = {strip.left_m};
  const auto add = [&](double edge_m) {
    if (edge_m < edges_m.back() && edge_m > strip.right_m) edges_m.push_back(edge_m);
  };
  for (std::size_t i = 0; i + 1 < lanes.whole_m.size(); ++i) {
    const double left = lanes.whole_m[i], right = lanes.whole_m[i + 1];
    const double change_m = change.offsets_m[i] - change.offsets_m[i + 1] - (left - right);
    if (std::abs(change_m) < 2 * kQuantum_m) continue;
    for (const double edge_m : {left, left - margin_m(left - right), right + margin_m(left - right), right})
      add(edge_m);
  }
  edges_m.push_back(strip.right_m);
  return edges_m;
}

// Where a point at an offset of the full road lies: a margin keeps its width, as far as its lane has room for it.
double moved_within_margins(const LaneEdges& lanes, double offset_m) {
  const auto after = std::ranges::lower_bound(lanes.whole_m, offset_m, std::greater());
  if (after == lanes.whole_m.begin() || after == lanes.whole_m.end() || *after == offset_m)
    return lanes.moved(offset_m);
  const auto i = static_cast<std::size_t>(after - lanes.whole_m.begin());
  const double left_m = lanes.whole_m[i - 1] - offset_m, right_m = offset_m - lanes.whole_m[i];
  const double half_m = (lanes.moved_m[i - 1] - lanes.moved_m[i]) / 2;
  return left_m < right_m ? lanes.moved_m[i - 1] - std::min(left_m, half_m)
                          : lanes.moved_m[i] + std::min(right_m, half_m);
}

// Adds a strip between the kerbs in parts, so that each line of its lanes leads to its own place.
void add_bands(std::size_t strip, const Slice& slice, const LaneChange& change, PieceBuilder& builder) {
  const LaneEdges start = led_lanes_at(builder.road, builder.changes, slice.start.along_m),
                  end = led_lanes_at(builder.road, builder.changes, slice.end.along_m);
  const std::vector<double> edges_m = band_edges_of(builder.strips[strip], start, change);
  for (std::size_t i = 0; i + 1 < edges_m.size(); ++i) {
    const auto at = [&](const LaneEdges& lanes) {
      return StripEdges{moved_within_margins(lanes, edges_m[i]), moved_within_margins(lanes, edges_m[i + 1])};
    };
    builder.add(strip, {edges_m[i], edges_m[i + 1]}, slice, at(start), at(end), ring_of(slice, at(start), at(end)));
  }
}

const LaneChange* change_within(const Slice& slice, std::span<const LaneChange> changes) {
  const double middle_m = (slice.start.along_m + slice.end.along_m) / 2;
  const auto found = std::ranges::find_if(changes, [&](const LaneChange& c) { return c.share_at(middle_m) > 0; });
  return found == changes.end() ? nullptr : &*found;
}

// Adds a strip with slabs along its kerb: the slabs, then the rest.
void add_with_slabs(std::size_t strip, const Slice& slice, StripEdges start, StripEdges end, PieceBuilder& builder) {
  const LaneStrip& whole = builder.strips[strip];
  const double depth_m = builder.slab_depth_m(strip, builder.stretches[slice.stretch]);
  const bool is_kerb_left = builder.is_kerb(strip - 1);
  const auto line_m = [&](StripEdges edges) {
    const double room_m = std::min(depth_m, (edges.left_m - edges.right_m) / 2);
    return is_kerb_left ? edges.left_m - room_m : edges.right_m + room_m;
  };
  const auto part = [&](StripEdges edges, bool is_slab) {
    return is_slab == is_kerb_left ? StripEdges{edges.left_m, line_m(edges)} : StripEdges{line_m(edges), edges.right_m};
  };
  for (const bool is_slab : {true, false}) {
    const StripEdges band = part({whole.left_m, whole.right_m}, is_slab), a = part(start, is_slab),
                     b = part(end, is_slab);
    const std::size_t before = builder.made.pieces.size();
    builder.add(strip, band, slice, a, b, ring_of(slice, a, b));
    if (is_slab) builder.show_slabs(strip, slice, before);
  }
}

// Adds all strips of a slice and the joints of the bends beside it.
void add_slice(const Slice& slice, std::span<const OpenBend> bends, PieceBuilder& builder) {
  const auto start = edges_at(builder.road, builder.strips, builder.changes, slice.start.along_m);
  const auto end = edges_at(builder.road, builder.strips, builder.changes, slice.end.along_m);
  const LaneChange* change = change_within(slice, builder.changes);
  for (std::size_t s = 0; s < builder.strips.size(); ++s)
    if (change != nullptr && builder.has_lines(s, slice))
      add_bands(s, slice, *change, builder);
    else if (builder.slabs[s * builder.stretches.size() + slice.stretch] != kNoMarkingLayout)
      add_with_slabs(s, slice, start[s], end[s], builder);
    else
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
  return {frame.left_u_m + (width > 0 ? u * (frame.width_m / width) : 0),
          frame.start.v_m + passed * (frame.end.v_m - frame.start.v_m)};
}

RoadPieces pieces_of(const Road& road, const StripEnds& ends, std::span<const RoadStretch> stretches,
                     std::span<const LaneChange> changes, double tile_m, double tolerance_m) {
  assert(road.axis.size() >= 2 && tile_m > 0 && tolerance_m >= 0);
  PieceBuilder builder{road, stretches, changes, lane_strips_of(road, tolerance_m)};
  if (builder.strips.empty() || stretches.empty()) return {};
  builder.find_patterns();
  builder.find_slabs();
  // bounds that do not depend on the part of the way
  const double left = std::max(0.0, builder.strips.front().left_m + widest_left_m(road) - left_m(road)),
               right = std::max(0.0, widest_right_m(road) - right_m(road) - builder.strips.back().right_m);
  const Slices all = slices_of(road, ends, stretches, left, right, changes, tile_m);
  auto bend = all.bends.begin();
  for (std::uint32_t i = 0; i < all.slices.size(); ++i) {
    const auto first = bend;
    while (bend != all.bends.end() && bend->slice == i) ++bend;
    add_slice(all.slices[i], {first, bend}, builder);
  }
  return std::move(builder.made);
}

}  // namespace citykiln::roads
