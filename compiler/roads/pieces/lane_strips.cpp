#include "compiler/roads/pieces/lane_strips.h"

#include <algorithm>
#include <cassert>

namespace citykiln::roads {
namespace {

using map::LandCoverClass;
using map::LaneKind;

// Raised buffers become pavement: no tag says whether they are planted, and crossings lead over them.
LandCoverClass lane_surface_of(const Road& road, const map::Lane& lane) {
  if (lane.kind == LaneKind::kParking) return LandCoverClass::kParkingLane;
  if (!lane.is_raised) return road.surface;
  if (lane.kind == LaneKind::kCycle) return LandCoverClass::kCycleTrack;
  return lane.kind == LaneKind::kVerge ? LandCoverClass::kVerge : LandCoverClass::kPavement;
}

// Groups neighbouring lanes of one land cover class, left to right.
std::vector<LaneStrip> runs_of(const Road& road) {
  std::vector<LaneStrip> strips;
  double edge_m = left_m(road) + raised_left_m(road);
  for (const map::Lane& lane : road.section.lanes) {
    const LandCoverClass surface = lane_surface_of(road, lane);
    const bool goes_on =
        !strips.empty() && strips.back().surface == surface && strips.back().lanes.back().is_raised == lane.is_raised;
    if (!goes_on) strips.push_back({.surface = surface, .lanes = {}, .left_m = edge_m, .right_m = edge_m});
    strips.back().lanes.push_back(lane);
    edge_m -= lane.width_m;
    strips.back().right_m = edge_m;
  }
  return strips;
}

bool is_raised(const LaneStrip& strip) { return strip.lanes.front().is_raised; }

LaneStrip kerb(double left_m) {
  return {.surface = LandCoverClass::kKerb, .lanes = {}, .left_m = left_m, .right_m = left_m - kKerb_m};
}

// Adds a kerb on the raised side of each step between raised and level lanes.
std::vector<LaneStrip> with_kerbs(std::vector<LaneStrip> runs) {
  std::vector<LaneStrip> strips;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    LaneStrip& run = runs[i];
    const bool raised = is_raised(run);
    const bool kerb_left = raised && i > 0 && !is_raised(runs[i - 1]);
    const bool kerb_right = raised && i + 1 < runs.size() && !is_raised(runs[i + 1]);
    run.has_kerb_left = !raised && i > 0 && is_raised(runs[i - 1]);
    run.has_kerb_right = !raised && i + 1 < runs.size() && is_raised(runs[i + 1]);
    if (kerb_left) strips.push_back(kerb(run.left_m));
    strips.push_back(run);
    if (kerb_left) strips.back().left_m -= kKerb_m;
    if (!kerb_right) continue;
    strips.back().right_m += kKerb_m;
    strips.push_back(kerb(run.right_m + kKerb_m));
  }
  return strips;
}

double strip_width_m(const LaneStrip& strip) { return strip.left_m - strip.right_m; }

// The index of the widest strip with the road's own class, which absorbs its narrow neighbours last.
std::size_t middle_of(const Road& road, const std::vector<LaneStrip>& strips) {
  std::size_t middle = 0;
  for (std::size_t i = 0; i < strips.size(); ++i) {
    const auto rank = [&](std::size_t k) {
      return std::pair(strips[k].surface == road.surface, strip_width_m(strips[k]));
    };
    if (rank(i) > rank(middle)) middle = i;
  }
  return middle;
}

// Merges strips narrower than the tolerance into their neighbour towards the middle.
std::vector<LaneStrip> yielded(const Road& road, std::vector<LaneStrip> strips, double tolerance_m) {
  for (std::size_t middle = middle_of(road, strips), i = 0; i < strips.size();) {
    if (i == middle || strip_width_m(strips[i]) >= tolerance_m) {
      ++i;
      continue;
    }
    if (i < middle)
      strips[i + 1].left_m = strips[i].left_m, --middle;
    else
      strips[i - 1].right_m = strips[i].right_m;
    strips.erase(strips.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return strips;
}

}  // namespace

std::vector<LaneStrip> lane_strips_of(const Road& road, double tolerance_m) {
  assert(tolerance_m >= 0);
  std::vector<LaneStrip> strips = yielded(road, with_kerbs(runs_of(road)), tolerance_m);
  std::erase_if(strips, [](const LaneStrip& s) { return strip_width_m(s) <= 0; });
  return strips;
}

}  // namespace citykiln::roads
