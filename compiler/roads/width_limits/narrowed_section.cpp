#include "compiler/roads/width_limits/narrowed_section.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <span>

namespace citykiln::roads {
namespace {

// One side of a road, measured from the carriageway's middle.
struct Side {
  double carriageway_m, raised_m;
  double paved_m = 0;  // the raised width without verges outside the pavement
};

// The full widths of both sides, and the minimum of the carriageway's half.
struct Sides {
  double middle_m;  // offset to the left of the axis
  Side left, right;
  double least_m;
};

bool is_walked_or_cycled(const map::Lane& lane) {
  using map::LaneKind;
  return lane.is_raised || lane.kind == LaneKind::kFoot || lane.kind == LaneKind::kCycle ||
         lane.kind == LaneKind::kSidewalk;
}

Sides sides_of(const Road& road, double along_m) {
  const double drift = drift_m(road, along_m);
  const double left = left_m(road) + drift, right = right_m(road) - drift, half = (left + right) / 2;
  return {(left - right) / 2,
          {half, raised_left_m(road), paved_left_m(road)},
          {half, raised_right_m(road), paved_right_m(road)},
          min_half_width_m(road)};
}

Side give_way(const Side& whole, double least_m, double limit_m) {
  const double kept = std::min(whole.raised_m, kMinPavement_m);
  const double raised = std::clamp(limit_m - whole.carriageway_m, kept, whole.raised_m);
  const double carriageway = std::clamp(limit_m - raised, least_m, whole.carriageway_m);
  return {carriageway, std::clamp(limit_m - carriageway, 0.0, raised)};
}

double half_at(std::span<const WidthLimit> width_limits, double along_m) {
  const auto after = std::ranges::lower_bound(width_limits, along_m, {}, &WidthLimit::at_m);
  const bool has_before = after != width_limits.begin();
  if (after != width_limits.end() && after->is_wall && has_before) {
    const WidthLimit& before = *(after - 1);
    const double share = (along_m - before.at_m) / (after->at_m - before.at_m);
    return before.half_m + (after->half_m - before.half_m) * share;
  }
  double half = std::numeric_limits<double>::infinity();
  if (after != width_limits.end()) half = after->half_m + (after->at_m - along_m) * kTaper;
  if (has_before) half = std::min(half, (after - 1)->half_m + (along_m - (after - 1)->at_m) * kTaper);
  return half;
}

// The limit of one side as a polyline that begins and ends at the full width.
std::vector<Vec2> profile_of(std::span<const WidthLimit> width_limits, double whole_m) {
  std::vector<Vec2> corners;
  const auto run_up = [&](const WidthLimit& p) { return std::max(0.0, whole_m - p.half_m) / kTaper; };
  if (!width_limits.empty()) corners.push_back({width_limits.front().at_m - run_up(width_limits.front()), whole_m});
  for (std::size_t i = 0; i < width_limits.size(); ++i) {
    const WidthLimit& b = width_limits[i];
    if (i > 0 && !b.is_wall) {
      const WidthLimit& a = width_limits[i - 1];
      const double apex = (a.at_m + b.at_m) / 2 + (b.half_m - a.half_m) / (2 * kTaper);
      corners.push_back({apex, a.half_m + (apex - a.at_m) * kTaper});
    }
    corners.push_back({b.at_m, b.half_m});
  }
  if (!width_limits.empty()) corners.push_back({width_limits.back().at_m + run_up(width_limits.back()), whole_m});
  return corners;
}

// Adds the distances where the limit bends or crosses a value at which the next part begins to narrow.
void add_bends(std::span<const WidthLimit> width_limits, const Side& side, double least_m, std::vector<double>& bends) {
  const double kept = std::min(side.raised_m, kMinPavement_m);
  const std::array<double, 5> turns = {side.carriageway_m + side.raised_m, side.carriageway_m + side.paved_m,
                                       side.carriageway_m + kept, least_m + kept, least_m};
  const std::vector<Vec2> corners = profile_of(width_limits, turns[0]);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    bends.push_back(corners[i].x);
    if (i == 0) continue;
    const Vec2 a = corners[i - 1], b = corners[i];
    for (const double turn : turns)
      if ((a.y < turn) != (b.y < turn)) bends.push_back(a.x + (b.x - a.x) * ((turn - a.y) / (b.y - a.y)));
  }
}

// Narrows a lane by up to what is asked and subtracts that from the request.
void take(double& width_m, double& asked_m) {
  const double taken = std::min(width_m, asked_m);
  width_m -= taken, asked_m -= taken;
}

// Narrows the raised lanes of one side, outermost first.
void narrow_raised(std::span<const map::Lane* const> lanes, std::span<double* const> widths, double asked_m) {
  for (std::size_t i = 0; i < lanes.size(); ++i)
    if (lanes[i]->kind == map::LaneKind::kBuffer || lanes[i]->kind == map::LaneKind::kVerge) take(*widths[i], asked_m);
  for (double* width : widths) take(*width, asked_m);
}

// Narrows the carriageway's lanes by what each side lost.
void narrow_carriageway(std::span<const map::Lane* const> lanes, std::span<double* const> widths, double left_m,
                        double right_m) {
  for (std::size_t i = 0; i < lanes.size() && is_soft(lanes[i]->kind); ++i) take(*widths[i], left_m);
  for (std::size_t i = lanes.size(); i > 0 && is_soft(lanes[i - 1]->kind); --i) take(*widths[i - 1], right_m);
  double firm = 0;
  for (std::size_t i = 0; i < lanes.size(); ++i) firm += is_soft(lanes[i]->kind) ? 0 : *widths[i];
  if (firm <= 0) return;
  const double scale = std::max(0.0, 1 - (left_m + right_m) / firm);
  for (std::size_t i = 0; i < lanes.size(); ++i)
    if (!is_soft(lanes[i]->kind)) *widths[i] *= scale;
}

}  // namespace

double min_half_width_m(const Road& road) {
  const double least_m = std::ranges::all_of(road.section.lanes, is_walked_or_cycled) ? kMinPath_m : kMinCarriageway_m;
  return std::min(least_m, width_m(road)) / 2;
}

MaxOffsets max_offsets_at(const Road& road, double along_m) {
  const double middle = (left_m(road) - right_m(road)) / 2 + drift_m(road, along_m);
  return {half_at(road.width_limits.left, along_m) + middle, half_at(road.width_limits.right, along_m) - middle};
}

RoadEdges road_edges_at(const Road& road, double along_m) {
  const Sides sides = sides_of(road, along_m);
  const Side left = give_way(sides.left, sides.least_m, half_at(road.width_limits.left, along_m));
  const Side right = give_way(sides.right, sides.least_m, half_at(road.width_limits.right, along_m));
  const double kerb_left = left.carriageway_m + sides.middle_m, kerb_right = right.carriageway_m - sides.middle_m;
  return {.left_m = kerb_left + left.raised_m,
          .kerb_left_m = kerb_left,
          .kerb_right_m = kerb_right,
          .right_m = kerb_right + right.raised_m};
}

std::vector<double> bends_of_edges(const Road& road) {
  const Sides sides = sides_of(road, 0);
  std::vector<double> bends;
  add_bends(road.width_limits.left, sides.left, sides.least_m, bends);
  add_bends(road.width_limits.right, sides.right, sides.least_m, bends);
  std::sort(bends.begin(), bends.end());
  bends.erase(std::unique(bends.begin(), bends.end()), bends.end());
  return bends;
}

NarrowedSection narrowed_section_at(const Road& road, double along_m) {
  const RoadEdges edges = road_edges_at(road, along_m);
  NarrowedSection section{edges.left_m, {}};
  for (const map::Lane& lane : road.section.lanes) section.widths_m.push_back(lane.width_m);
  // outermost first on the raised sides, left to right between the kerbs
  std::array<std::vector<const map::Lane*>, 3> lanes;
  std::array<std::vector<double*>, 3> widths;
  bool is_past_left_kerb = false;
  for (std::size_t i = 0; i < road.section.lanes.size(); ++i) {
    const map::Lane& lane = road.section.lanes[i];
    is_past_left_kerb |= !lane.is_raised;
    const std::size_t group = !lane.is_raised ? 1 : is_past_left_kerb ? 2 : 0;
    lanes[group].push_back(&lane), widths[group].push_back(&section.widths_m[i]);
  }
  std::ranges::reverse(lanes[2]), std::ranges::reverse(widths[2]);
  narrow_raised(lanes[0], widths[0], raised_left_m(road) - (edges.left_m - edges.kerb_left_m));
  narrow_raised(lanes[2], widths[2], raised_right_m(road) - (edges.right_m - edges.kerb_right_m));
  const double drift = drift_m(road, along_m);
  narrow_carriageway(lanes[1], widths[1], left_m(road) + drift - edges.kerb_left_m,
                     right_m(road) - drift - edges.kerb_right_m);
  return section;
}

LaneEdges lane_edges_at(const Road& road, double along_m) {
  const NarrowedSection section = narrowed_section_at(road, along_m);
  LaneEdges edges{{left_m(road) + raised_left_m(road)}, {section.left_m}};
  for (std::size_t i = 0; i < road.section.lanes.size(); ++i) {
    edges.whole_m.push_back(edges.whole_m.back() - road.section.lanes[i].width_m);
    edges.moved_m.push_back(edges.moved_m.back() - section.widths_m[i]);
  }
  return edges;
}

double LaneEdges::moved(double offset_m) const {
  assert(!whole_m.empty() && whole_m.size() == moved_m.size());
  const auto after = std::ranges::lower_bound(whole_m, offset_m, std::greater());
  if (after == whole_m.begin()) return moved_m.front();
  if (after == whole_m.end()) return moved_m.back();
  const auto i = static_cast<std::size_t>(after - whole_m.begin());
  const double share = (whole_m[i - 1] - offset_m) / (whole_m[i - 1] - whole_m[i]);
  return moved_m[i - 1] + (moved_m[i] - moved_m[i - 1]) * share;
}

}  // namespace citykiln::roads
