// The ground between kerbs and walls, as mapped and as built.
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/segment.h"
#include "tests/charts/assumed_values.h"

namespace citykiln::charts {
namespace {

using map::LandCoverClass;
using map::Track;

/// Areas are looked at in points of a grid. A point is between kerb and wall if it is at most kStrip_m behind the kerb
/// of a street, and a wall at most kToWall_m behind the kerb stands behind it.
constexpr double kGrid_m = 1, kStrip_m = 8, kToWall_m = 12;
constexpr double kFrontBucket_m = 32;
/// Smaller areas are planters and tree pits, which lie in paved ground; larger ones are no fronts.
constexpr double kLeastFront_m2 = 60, kLargestFront_m2 = 4000;
/// Areas with fewer points there are left out.
constexpr int kFewestPoints = 5;

std::optional<bool> is_paved_class(LandCoverClass surface) {
  switch (surface) {
    case LandCoverClass::kSquare:
    case LandCoverClass::kPlatform:
      return true;
    case LandCoverClass::kGrass:
    case LandCoverClass::kGarden:
    case LandCoverClass::kFlowerbed:
    case LandCoverClass::kHedgeArea:
    case LandCoverClass::kScrub:
      return false;
    default:
      return std::nullopt;
  }
}

bool has_kerbs(const Track& track) {
  const bool is_class =
      track.surface == LandCoverClass::kPrimaryRoad || track.surface == LandCoverClass::kSecondaryRoad ||
      track.surface == LandCoverClass::kTertiaryRoad || track.surface == LandCoverClass::kResidentialRoad;
  return is_class && track.passage == map::Passage::kGround && !track.is_indoor;
}

/// Segments of streets and of walls.
struct Fronts {
  struct Segment {
    Vec2 a, b;
    const Track* track = nullptr;
  };
  std::vector<Segment> streets, walls;
  BoxGrid street_grid, wall_grid;
};

BoxGrid grid_of_segments(std::span<const Fronts::Segment> segments, double widened_m) {
  std::vector<Box2> boxes;
  for (const Fronts::Segment& s : segments) boxes.push_back(box_of_segment(s.a, s.b).widened(widened_m));
  return boxes.empty() ? BoxGrid{} : grid_of(boxes, kFrontBucket_m);
}

Fronts fronts_of(const map::Features& features) {
  Fronts fronts;
  for (const Track& track : features.tracks)
    for (std::size_t i = 0; has_kerbs(track) && i + 1 < track.axis.size(); ++i)
      fronts.streets.push_back({track.axis[i], track.axis[i + 1], &track});
  for (const map::Footprint& footprint : features.footprints)
    for (std::size_t i = 0; !footprint.is_part && i < footprint.polygon.outer.size(); ++i)
      fronts.walls.push_back(
          {footprint.polygon.outer[i], footprint.polygon.outer[(i + 1) % footprint.polygon.outer.size()]});
  constexpr double kWidestRoad_m = 24;
  fronts.street_grid = grid_of_segments(fronts.streets, kWidestRoad_m + kStrip_m);
  fronts.wall_grid = grid_of_segments(fronts.walls, 1);
  return fronts;
}

bool has_wall_between(const Fronts& fronts, Vec2 from, Vec2 to) {
  if (fronts.walls.empty()) return false;
  return std::ranges::any_of(boxes_about(fronts.wall_grid, box_of_segment(from, to)), [&](std::uint32_t i) {
    return crossing_shares(from, to, fronts.walls[i].a, fronts.walls[i].b).has_value();
  });
}

/// The width that is paved from the kerb on, without verges; 0 if a verge lies at the kerb.
double paved_m(const Track& track, bool is_left) {
  std::vector<map::Lane> lanes = track.section.lanes;
  if (!is_left) std::ranges::reverse(lanes);
  double width_m = 0;
  for (const map::Lane& lane : lanes) {
    if (!lane.is_raised) break;
    width_m = lane.kind == map::LaneKind::kVerge ? 0 : width_m + lane.width_m;
  }
  return width_m;
}

/// True or false if a point lies between kerb and wall: whether the pavement reaches it. The nearest street counts.
std::optional<bool> is_paved_at(const Fronts& fronts, Vec2 p) {
  if (fronts.streets.empty()) return std::nullopt;
  std::optional<bool> paved;
  double least_m = kStrip_m;
  for (const std::uint32_t i : boxes_about(fronts.street_grid, p)) {
    const Fronts::Segment& s = fronts.streets[i];
    const double share = nearest_share(s.a, s.b, p);
    if (share <= 0 || share >= 1) continue;
    const Vec2 foot = s.a + (s.b - s.a) * share, out = unit(p - foot);
    const bool is_left = cross(s.b - s.a, p - foot) > 0;
    const double kerb_m = is_left ? left_kerb_m(s.track->section) : right_kerb_m(s.track->section);
    const double behind_m = distance(p, foot) - kerb_m;
    if (behind_m <= 0 || behind_m >= least_m || has_wall_between(fronts, foot, p)) continue;
    least_m = behind_m;
    paved = std::nullopt;
    if (has_wall_between(fronts, p, foot + out * (kerb_m + kToWall_m))) paved = behind_m <= paved_m(*s.track, is_left);
  }
  return paved;
}

/// The points of an area between kerbs and walls, and how many of them a pavement reaches.
struct AreaPoints {
  int all = 0, paved = 0;
};

AreaPoints front_points(const Fronts& fronts, const map::AreaFeature& area) {
  AreaPoints points;
  if (area.polygon.outer.empty() || area.area_m2 < kLeastFront_m2 || area.area_m2 > kLargestFront_m2) return points;
  const Box2 box = box_of(area.polygon.outer);
  for (double x = box.min.x + kGrid_m / 2; x < box.max.x; x += kGrid_m)
    for (double y = box.min.y + kGrid_m / 2; y < box.max.y; y += kGrid_m) {
      if (!contains(area.polygon, {x, y})) continue;
      const auto paved = is_paved_at(fronts, {x, y});
      points.all += paved.has_value(), points.paved += paved.value_or(false);
    }
  return points;
}

}  // namespace

std::vector<Sample> tagged_frontages(const Place& place) {
  const Fronts fronts = fronts_of(place.mapped);
  std::vector<Sample> samples;
  for (const map::AreaFeature& area : place.mapped.areas) {
    const auto is_paved = is_paved_class(area.surface);
    if (is_paved && front_points(fronts, area).all >= kFewestPoints)
      samples.push_back(
          {.key = {area.id.osm, 0}, .at = box_of(area.polygon.outer).centre(), .tagged = *is_paved ? 1.0 : 0.0});
  }
  return samples;
}

Values built_frontages(const map::Features& features) {
  const Fronts fronts = fronts_of(features);
  Values built;
  for (const map::AreaFeature& area : features.areas) {
    if (area.surface != LandCoverClass::kUnknown) continue;
    const AreaPoints points = front_points(fronts, area);
    if (points.all > 0) built[{area.id.osm, 0}] = static_cast<double>(points.paved) / points.all;
  }
  return built;
}

void hide_frontages(map::Features& features) {
  for (map::AreaFeature& area : features.areas)
    if (is_paved_class(area.surface)) area.surface = LandCoverClass::kUnknown;
}

}  // namespace citykiln::charts
