#include "compiler/roads/pieces/drive_kerbs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "compiler/geometry/box.h"
#include "compiler/geometry/line_part.h"
#include "compiler/geometry/segment.h"
#include "compiler/roads/pieces/lane_strips.h"
#include "compiler/roads/width_limits/narrowed_section.h"

namespace citykiln::roads {
namespace {

// The step of places along the way, so that two cuts across a road coincide or lie apart.
constexpr double kDriveStep_m = 0.25;
constexpr double kFromPavement_m = 2;
// The cosine of the largest angle between a drive and the line square to the road, some 45 degrees.
constexpr double kSquareToRoad = 0.7;

// The place on an axis that is nearest to a point.
struct OnAxis {
  double along_m = 0, away_m = std::numeric_limits<double>::infinity();
  Vec2 ahead{}, at{};
};

OnAxis nearest_on_axis(const Road& road, const std::vector<double>& along, Vec2 p) {
  OnAxis nearest;
  for (std::size_t i = 0; i + 1 < road.axis.size(); ++i) {
    const Vec2 a = road.axis[i], b = road.axis[i + 1], at = nearest_point(a, b, p);
    if (distance(at, p) >= nearest.away_m) continue;
    nearest = {along[i] + distance(a, at), distance(at, p), unit(b - a), at};
  }
  return nearest;
}

bool has_pavement(const RoadEdges& edges, bool is_left) {
  return (is_left ? edges.left_m - edges.kerb_left_m : edges.right_m - edges.kerb_right_m) > kKerb_m;
}

std::optional<DriveKerb> drive_kerb_at(const Road& road, const std::vector<double>& along, const DriveMouth& mouth) {
  const OnAxis near = nearest_on_axis(road, along, mouth.at);
  const bool is_left = cross(near.ahead, mouth.at - near.at) > 0;
  const Vec2 inward = left_of(near.ahead) * (is_left ? -1.0 : 1.0);
  const RoadEdges edges = road_edges_at(road, near.along_m);
  const double outer_m = is_left ? edges.left_m : edges.right_m;
  if (std::abs(near.away_m - outer_m) > kFromPavement_m || !has_pavement(edges, is_left)) return std::nullopt;
  if (dot(mouth.outward, inward) < kSquareToRoad) return std::nullopt;
  const double from_m = std::floor((near.along_m - kDriveKerb_m / 2) / kDriveStep_m + 0.5) * kDriveStep_m;
  return DriveKerb{from_m, from_m + kDriveKerb_m, is_left};
}

bool keeps_its_kerb(const RoadStretch& stretch) {
  return stretch.stretch == StretchKind::kZebra || stretch.stretch == StretchKind::kCrossing || stretch.traits != 0;
}

// True if a drive's kerb with its ramps lies on the road, and touches neither a junction nor a crossing.
bool is_apart(const DriveKerb& drive, std::span<const RoadStretch> stretches,
              std::span<const JunctionInterval> intervals) {
  const double from_m = drive.from_m - kKerbRamp_m, to_m = drive.to_m + kKerbRamp_m;
  if (stretches.empty() || from_m <= stretches.front().from_m || to_m >= stretches.back().to_m) return false;
  const auto is_in_junction = [&](const JunctionInterval& each) {
    return from_m < each.at_m + each.after_m && to_m > each.at_m - each.before_m;
  };
  const auto is_at_crossing = [&](const RoadStretch& stretch) {
    return keeps_its_kerb(stretch) && stretch.from_m - kKerbRamp_m < to_m && from_m < stretch.to_m + kKerbRamp_m;
  };
  return std::ranges::none_of(intervals, is_in_junction) && std::ranges::none_of(stretches, is_at_crossing);
}

KerbRamp ramp_of(const Road& road, const std::vector<double>& along, const DriveKerb& drive) {
  const Vec2 a = point_at(road.axis, along, drive.from_m), b = point_at(road.axis, along, drive.to_m);
  const RoadEdges edges = road_edges_at(road, (drive.from_m + drive.to_m) / 2);
  const double kerb_m = drive.is_left ? edges.kerb_left_m : edges.kerb_right_m,
               outer_m = drive.is_left ? edges.left_m : edges.right_m;
  const Vec2 ahead = unit(b - a), outward = left_of(ahead) * (drive.is_left ? 1.0 : -1.0);
  return {.at = (a + b) * 0.5 + outward * kerb_m,
          .along = ahead,
          .outward = outward,
          .half_m = kDriveKerb_m / 2,
          .reach_m = outer_m - kerb_m,
          .lip_m = kKerbLip_m};
}

}  // namespace

std::vector<DriveKerb> drive_kerbs_of(const Road& road, std::span<const RoadStretch> stretches,
                                      std::span<const JunctionInterval> intervals, std::span<const DriveMouth> mouths) {
  std::vector<DriveKerb> kerbs;
  if (!map::is_street(road.surface) || (raised_left_m(road) == 0 && raised_right_m(road) == 0)) return kerbs;
  const Box2 box = citykiln::box_of(road.axis).widened(max_offset_m(road) + kFromPavement_m);
  std::vector<double> along;
  for (const DriveMouth& mouth : mouths) {
    if (!box.contains(mouth.at)) continue;
    if (along.empty()) along = distances_along(road);
    const std::optional<DriveKerb> kerb = drive_kerb_at(road, along, mouth);
    if (kerb && is_apart(*kerb, stretches, intervals)) kerbs.push_back(*kerb);
  }
  std::ranges::sort(kerbs, {}, [](const DriveKerb& k) { return std::tuple(k.from_m, k.is_left); });
  return kerbs;
}

std::vector<RoadStretch> cut_at_drives(std::span<const RoadStretch> stretches, std::span<const DriveKerb> drives) {
  std::vector<double> ends_m;
  for (const DriveKerb& drive : drives)
    for (const double end_m : {drive.from_m - kKerbRamp_m, drive.from_m, drive.to_m, drive.to_m + kKerbRamp_m})
      ends_m.push_back(end_m);
  return cut_stretches(stretches, std::move(ends_m), [](const RoadStretch&) { return true; });
}

void add_drive_ramps(const Road& road, std::span<const DriveKerb> drives, std::vector<KerbRamp>& ramps) {
  if (drives.empty()) return;
  const std::vector<double> along = distances_along(road);
  for (const DriveKerb& drive : drives) ramps.push_back(ramp_of(road, along, drive));
}

std::vector<KerbRamp> drive_ramps_of(std::span<const Road> roads, std::span<const Junction> junctions, double tile_m,
                                     bool assumes, std::span<const DriveMouth> mouths) {
  std::vector<KerbRamp> ramps;
  if (mouths.empty()) return ramps;
  const std::vector<std::vector<JunctionInterval>> intervals = junction_intervals_of(roads, junctions);
  for (std::size_t i = 0; i < roads.size(); ++i) {
    if (!map::is_street(roads[i].surface)) continue;
    const std::vector<RoadStretch> stretches =
        with_dropped_kerbs(roads[i], stretches_of(roads[i], intervals[i], tile_m), intervals[i], assumes);
    add_drive_ramps(roads[i], drive_kerbs_of(roads[i], stretches, intervals[i], mouths), ramps);
  }
  return ramps;
}

}  // namespace citykiln::roads
