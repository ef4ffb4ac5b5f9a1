#include "compiler/ground/cover/close_gaps.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/segment.h"
#include "compiler/map/plane/plane.h"

namespace citykiln::ground {
namespace {

using map::LandCoverClass;

// A piece of an axis, and the distances from it to the outer edges.
struct EdgedSegment {
  Vec2 a, b;
  double left_m = 0, right_m = 0;
};

struct EdgedSegments {
  std::vector<EdgedSegment> all;
  BoxGrid grid;
};

bool has_paved_edge(const roads::Road& road) {
  const map::LandCoverGroup group = map::values_of(road.surface).group;
  return group == map::LandCoverGroup::kRoad || road.surface == LandCoverClass::kPavedFootPath ||
         road.surface == LandCoverClass::kCyclePath;
}

EdgedSegments edged_segments(std::span<const roads::Road> roads) {
  constexpr double kBucket_m = 32;
  EdgedSegments found;
  std::vector<Box2> boxes;
  for (const roads::Road& road : roads) {
    if (!has_paved_edge(road)) continue;
    const double left_m = roads::left_m(road) + roads::paved_left_m(road),
                 right_m = roads::right_m(road) + roads::paved_right_m(road);
    for (std::size_t i = 0; i + 1 < road.axis.size(); ++i) {
      found.all.push_back({road.axis[i], road.axis[i + 1], left_m, right_m});
      boxes.push_back(box_of_segment(road.axis[i], road.axis[i + 1]).widened(std::max(left_m, right_m) + kWidestGap_m));
    }
  }
  found.grid = grid_of(boxes, kBucket_m);
  return found;
}

Vec2 on_map_grid(Vec2 p) {
  const auto step = [](double v) { return std::round(v / map::kMapStep_m) * map::kMapStep_m; };
  return {step(p.x), step(p.y)};
}

// The nearest place under the edge of a street or path beside a corner.
std::optional<Vec2> place_under_edge(const EdgedSegments& segments, Vec2 corner) {
  std::optional<Vec2> place;
  double nearest_m = kWidestGap_m;
  for (const std::uint32_t i : boxes_about(segments.grid, corner)) {
    const EdgedSegment& segment = segments.all[i];
    const double share = nearest_share(segment.a, segment.b, corner);
    if (share <= 0 || share >= 1) continue;
    const Vec2 foot = segment.a + (segment.b - segment.a) * share;
    const double away_m = distance(foot, corner);
    const bool is_left = cross(segment.b - segment.a, corner - segment.a) > 0;
    const double edge_m = is_left ? segment.left_m : segment.right_m, gap_m = away_m - edge_m;
    if (gap_m < 0) return std::nullopt;
    if (gap_m >= nearest_m || away_m == 0) continue;
    nearest_m = gap_m;
    place = on_map_grid(foot + (corner - foot) * (std::max(0.0, edge_m - kUnderEdge_m) / away_m));
  }
  return place;
}

bool is_paved_area(const LandCoverPolygon& surface) {
  return surface.surface == LandCoverClass::kParking || surface.surface == LandCoverClass::kSquare ||
         surface.surface == LandCoverClass::kPlatform;
}

Ring closed_ring(const EdgedSegments& segments, const Ring& ring) {
  constexpr double kMostChange = 0.2;
  Ring moved = ring;
  for (Vec2& corner : moved)
    if (const std::optional<Vec2> place = place_under_edge(segments, corner)) corner = *place;
  if (moved == ring) return ring;
  moved = without_repeats(moved);
  if (moved.size() < 3) return ring;
  const double before_m2 = signed_area_m2(ring), after_m2 = signed_area_m2(moved);
  return std::abs(after_m2 - before_m2) <= kMostChange * std::abs(before_m2) ? moved : ring;
}

}  // namespace

std::vector<LandCoverPolygon> with_closed_gaps(std::vector<LandCoverPolygon> surfaces,
                                               std::span<const roads::Road> roads) {
  if (std::ranges::none_of(surfaces, is_paved_area)) return surfaces;
  const EdgedSegments segments = edged_segments(roads);
  for (LandCoverPolygon& surface : surfaces)
    if (is_paved_area(surface))
      for (Ring& ring : surface.rings) ring = closed_ring(segments, ring);
  return surfaces;
}

}  // namespace citykiln::ground
