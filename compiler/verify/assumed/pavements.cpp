#include <algorithm>
#include <cmath>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/segment.h"
#include "compiler/roads/junctions/junction.h"
#include "compiler/roads/width_limits/narrowed_section.h"
#include "compiler/scene/land_cover.h"
#include "compiler/verify/assumed/measure_assumed.h"

namespace citykiln::verify {
namespace {

using map::LandCoverClass;
using map::LandCoverGroup;
using roads::Road;

constexpr double kPavementStep_m = 4, kAssumedBucket_m = 32;
// Narrower pavements are kerb stones.
constexpr double kLeastMeasured_m = 0.25;
// Rounding of outlines.
constexpr double kInside_m = 0.05;

LandCoverGroup group_of_class(LandCoverClass surface) { return map::values_of(surface).group; }

// A segment of a way that nothing assumed may cover.
struct MappedSegment {
  std::uint32_t road, segment;
};

// The mapped objects of a chunk that nothing assumed may cover.
struct Mapped {
  const scene::Chunk& chunk;
  std::vector<ground::LandCoverPolygon> areas;  // Water, buildings and squares.
  ground::LandCoverIndex index;                 // The index of `areas`.
  std::vector<MappedSegment> segments{};
  BoxGrid grid{};  // The boxes of `segments`.
};

std::vector<ground::LandCoverPolygon> areas_to_avoid(const scene::Chunk& chunk) {
  std::vector<ground::LandCoverPolygon> areas;
  for (const ground::LandCoverPolygon& surface : chunk.surfaces)
    if (const auto group = group_of_class(surface.surface); group == LandCoverGroup::kWater ||
                                                            group == LandCoverGroup::kBuilding ||
                                                            surface.surface == LandCoverClass::kSquare)
      areas.push_back(surface);
  for (const buildings::Building& building : chunk.buildings)
    if (building.stands_on_ground) areas.push_back(scene::footprint_surface(building));
  return areas;
}

void add_segments(Mapped& mapped) {
  std::vector<Box2> boxes;
  const std::vector<Road>& all = mapped.chunk.roads;
  for (std::uint32_t r = 0; r < all.size(); ++r)
    for (std::uint32_t i = 0; i + 1 < all[r].axis.size(); ++i) {
      mapped.segments.push_back({r, i});
      const double widest_m = std::max(roads::widest_left_m(all[r]), roads::widest_right_m(all[r]));
      boxes.push_back(box_of_segment(all[r].axis[i], all[r].axis[i + 1]).widened(widest_m));
    }
  if (!boxes.empty()) mapped.grid = grid_of(boxes, kAssumedBucket_m);
}

// The middle of an assumed pavement at a place along its road.
struct PavementPlace {
  const Road& road;
  Vec2 on_axis, at;
};

bool has_vertex(const Road& road, Vec2 p) { return std::ranges::find(road.axis, p) != road.axis.end(); }

// True if two roads meet at a node, or one begins or ends near it on a third road that has it: roads are cut near
// junctions.
bool meet_at(const Mapped& mapped, const Road& other, Vec2 node) {
  if (has_vertex(other, node)) return true;
  for (const Vec2 end : {other.axis.front(), other.axis.back()}) {
    if (distance(end, node) >= roads::kJunctionRadius_m) continue;
    for (const std::uint32_t i : boxes_about(mapped.grid, node)) {
      const Road& between = mapped.chunk.roads[mapped.segments[i].road];
      if (has_vertex(between, node) && has_vertex(between, end)) return true;
    }
  }
  return false;
}

bool meet_near(const Mapped& mapped, const Road& one, const Road& other, Vec2 p) {
  return std::ranges::any_of(one.axis, [&](Vec2 node) {
    return distance(node, p) < roads::kJunctionRadius_m && meet_at(mapped, other, node);
  });
}

// Paths at a greater angle to a road join its pavement: the sine of about 37 degrees.
constexpr double kJoins = 0.6;

// True if a place lies between the kerbs of another road, on a railway, or on a path that runs along the road.
// Pavements may cover footways, which are mapped for them, and lie below cycle paths.
bool is_on_way(const PavementPlace& place, const Road& other, std::uint32_t segment) {
  const Vec2 a = other.axis[segment], b = other.axis[segment + 1];
  const double half_m = cross(b - a, place.at - a) > 0 ? roads::left_m(other) : roads::right_m(other);
  if (a == b || distance_to_segment(a, b, place.at) >= half_m - kInside_m) return false;
  if (other.surface == LandCoverClass::kFootPath || other.surface == LandCoverClass::kPavedFootPath ||
      other.surface == LandCoverClass::kCyclePath)
    return false;
  const bool is_path = group_of_class(other.surface) == LandCoverGroup::kPath;
  return !is_path || std::abs(dot(unit(b - a), unit(place.at - place.on_axis))) < kJoins;
}

// The mapped element on which a place of a pavement lies; none if it is free.
OsmId mapped_at(const Mapped& mapped, const PavementPlace& place) {
  const std::uint32_t area = ground::land_cover_at(mapped.index, place.at);
  if (area != ground::kNoLandCover && area != ground::land_cover_at(mapped.index, place.on_axis))
    return mapped.areas[area].id.osm;
  if (mapped.segments.empty()) return {};
  for (const std::uint32_t i : boxes_about(mapped.grid, place.at)) {
    const Road& other = mapped.chunk.roads[mapped.segments[i].road];
    if (other.id.osm == place.road.id.osm || !is_on_way(place, other, mapped.segments[i].segment)) continue;
    if (!meet_near(mapped, place.road, other, place.at)) return other.id.osm;
  }
  return {};
}

void test_place(const Mapped& mapped, const PavementPlace& place, AssumedTests& found) {
  ++found.tested;
  const OsmId on = mapped_at(mapped, place);
  if (on.type == OsmType::kNone) return;
  if (found.conflicts++ == 0) found.at = place.at, found.element = place.road.id.osm, found.obstacle = on;
}

void test_pavements(const Mapped& mapped, const Road& road, const Box2& box, AssumedTests& found) {
  const std::vector<double> along_m = roads::distances_along(road);
  for (std::size_t i = 0; i + 1 < road.axis.size(); ++i) {
    const Vec2 a = road.axis[i], b = road.axis[i + 1], left = left_of(unit(b - a));
    const int steps = std::max(1, static_cast<int>(std::ceil(distance(a, b) / kPavementStep_m)));
    for (int k = 0; k < steps; ++k) {
      const double share = (k + 0.5) / steps;
      const Vec2 on_axis = a + (b - a) * share;
      const auto edges = roads::road_edges_at(road, along_m[i] + (along_m[i + 1] - along_m[i]) * share);
      const double offsets_m[] = {(edges.kerb_left_m + edges.left_m) / 2, -(edges.kerb_right_m + edges.right_m) / 2};
      const double widths_m[] = {edges.left_m - edges.kerb_left_m, edges.right_m - edges.kerb_right_m};
      for (const int side : {0, 1}) {
        if ((road.assumed_sides & (side == 0 ? map::kLeftSide : map::kRightSide)) == 0) continue;
        const PavementPlace place{road, on_axis, on_axis + left * offsets_m[side]};
        if (widths_m[side] >= kLeastMeasured_m && box.contains_half_open(place.at)) test_place(mapped, place, found);
      }
    }
  }
}

bool has_assumed_sides(const Road& road) {
  return has(road.assumed, Assumption::kPavements) || has(road.assumed, Assumption::kVerges);
}

}  // namespace

AssumedTests measure_assumed_pavements(const scene::Chunk& chunk, const Box2& box) {
  AssumedTests found;
  const auto has_any = [](const Road& road) { return has_assumed_sides(road); };
  if (std::ranges::none_of(chunk.roads, has_any)) return found;
  Mapped mapped{chunk, areas_to_avoid(chunk), {}};
  mapped.index = ground::index_land_cover(mapped.areas, box.widened(scene::kHalo_m));
  add_segments(mapped);
  for (const Road& road : chunk.roads)
    if (has_any(road)) test_pavements(mapped, road, box, found);
  return found;
}

}  // namespace citykiln::verify
