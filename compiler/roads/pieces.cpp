#include "compiler/roads/pieces.h"

#include <algorithm>

#include "compiler/geometry/snap.h"
#include "compiler/roads/cross_lines.h"
#include "compiler/roads/markings.h"

namespace citykiln::roads {
namespace {

using map::SurfaceClass;

Vec2 point_on(const CrossLine& line, double offset_m) { return snapped(line.at + line.out * offset_m); }

// Where a line leaves a strip's edge, along the segment from its start.
double reach_m(const Slice& slice, const CrossLine& line, double offset_m) {
  return dot(line.at + line.out * offset_m - slice.start.at, slice.along);
}

Frame frame_of(const Slice& slice, const LaneStrip& strip, double zero_m) {
  Frame frame{slice.start.at, slice.along, strip.left_m, strip.left_m - strip.right_m};
  frame.start_left_m = reach_m(slice, slice.start, strip.left_m);
  frame.start_right_m = reach_m(slice, slice.start, strip.right_m);
  frame.end_left_m = reach_m(slice, slice.end, strip.left_m);
  frame.end_right_m = reach_m(slice, slice.end, strip.right_m);
  frame.start_v_m = slice.start.along_m - zero_m, frame.end_v_m = slice.end.along_m - zero_m;
  return frame;
}

Ring ring_of(const Slice& slice, const LaneStrip& strip) {
  return {point_on(slice.start, strip.right_m), point_on(slice.end, strip.right_m), point_on(slice.end, strip.left_m),
          point_on(slice.start, strip.left_m)};
}

bool is_crossing(Stretch stretch) { return stretch == Stretch::kZebra || stretch == Stretch::kCrossing; }

// What a stretch makes of a strip: crossings lead over everything between the kerbs.
SurfaceClass surface_of(const Road& road, const LaneStrip& strip, Stretch stretch) {
  if (stretch == Stretch::kLevelCrossing) return SurfaceClass::kLevelCrossing;
  return is_crossing(stretch) && strip.surface == road.surface ? SurfaceClass::kCrossing : strip.surface;
}

Pattern pattern_of(const Road& road, const LaneStrip& strip, const StretchRun& run) {
  Pattern pattern{strip.surface, strip.lanes, run.stretch, run.control, road.side};
  pattern.has_kerb_left = strip.has_kerb_left, pattern.has_kerb_right = strip.has_kerb_right;
  return pattern;
}

// A road while its pieces are made.
struct Making {
  const Road& road;
  std::span<const StretchRun> stretches;
  std::vector<LaneStrip> strips;
  RoadPieces made{};
  std::vector<std::uint32_t> patterns{};  // one a strip and stretch

  void find_patterns() {
    for (const LaneStrip& strip : strips)
      for (const StretchRun& run : stretches) {
        patterns.push_back(kNoPattern);
        Pattern pattern = pattern_of(road, strip, run);
        if (strip.lanes.empty() || !is_marked(pattern)) continue;
        patterns.back() = static_cast<std::uint32_t>(made.patterns.size());
        made.patterns.push_back(std::move(pattern));
      }
  }

  void add(std::size_t strip, const Slice& slice, Ring ring) {
    ring = without_repeats(ring);
    if (ring.size() < 3) return;
    if (signed_area_m2(ring) < 0) std::ranges::reverse(ring);
    if (signed_area_m2(ring) == 0) return;
    const auto number = static_cast<std::uint32_t>(strip * stretches.size() + slice.stretch);
    const StretchRun& run = stretches[slice.stretch];
    made.pieces.push_back({surface_of(road, strips[strip], run.stretch), std::move(ring),
                           frame_of(slice, strips[strip], run.zero_m), patterns[number], number});
  }
};

// The wedge outside of a bend, or what lies about it where it turns back: part of the slice that ends there.
void add_joint(const OpenBend& bend, const Slice& slice, std::size_t strip, Making& making) {
  const LaneStrip& s = making.strips[strip];
  const bool bends_left = cross(bend.before, bend.after) > 0;
  // the outer edge and the inner one, as far as they lie on the outside of the bend
  const double outer = bends_left ? std::min(0.0, s.right_m) : std::max(0.0, s.left_m);
  const double inner = bends_left ? std::min(0.0, s.left_m) : std::max(0.0, s.right_m);
  if (outer == inner) return;
  const auto corner = [&](Vec2 direction, double offset) { return snapped(bend.at + left_of(direction) * offset); };
  const Vec2 middle = unit(left_of(bend.before) + left_of(bend.after));
  Ring ring = {corner(bend.before, inner), corner(bend.before, outer), snapped(bend.at + middle * outer),
               corner(bend.after, outer), corner(bend.after, inner)};
  if (inner != 0) ring.push_back(snapped(bend.at + middle * inner));
  making.add(strip, slice, std::move(ring));
}

}  // namespace

Vec2 uv_at(const Frame& frame, Vec2 p) {
  const Vec2 off = p - frame.at;
  const double u = frame.left_m - dot(off, left_of(frame.along)), share = u / frame.width_m;
  const double start = frame.start_left_m + (frame.start_right_m - frame.start_left_m) * share;
  const double end = frame.end_left_m + (frame.end_right_m - frame.end_left_m) * share;
  const double passed = end > start ? std::clamp((dot(off, frame.along) - start) / (end - start), 0.0, 1.0) : 0;
  return {u, frame.start_v_m + passed * (frame.end_v_m - frame.start_v_m)};
}

RoadPieces pieces_of(const Road& road, const Ends& ends, std::span<const StretchRun> stretches, double tile_m,
                     double tolerance_m) {
  Making making{road, stretches, strips_of(road, tolerance_m)};
  if (making.strips.empty() || stretches.empty()) return {};
  making.find_patterns();
  const double left = std::max(0.0, making.strips.front().left_m), right = std::max(0.0, -making.strips.back().right_m);
  const Slices all = slices_of(road, ends, stretches, left, right, tile_m);
  auto bend = all.bends.begin();
  for (std::uint32_t i = 0; i < all.slices.size(); ++i) {
    const Slice& slice = all.slices[i];
    for (std::size_t s = 0; s < making.strips.size(); ++s) making.add(s, slice, ring_of(slice, making.strips[s]));
    for (; bend != all.bends.end() && bend->slice == i; ++bend)
      for (std::size_t s = 0; s < making.strips.size(); ++s) add_joint(*bend, slice, s, making);
  }
  return std::move(making.made);
}

}  // namespace citykiln::roads
