#include "compiler/verify/measure_ways.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <tuple>

#include "compiler/contract/equal_span.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/segment.h"
#include "compiler/map/ways/passageways.h"
#include "compiler/roads/width_limits/narrowed_section.h"

namespace citykiln::verify {
namespace {

using map::LandCoverClass;
using map::LandCoverGroup;

// Ways are cut into boxes of this length; buildings farther away are not met.
constexpr double kPiece_m = 2, kNear_m = 1;
// Kerbs, thresholds and slopes under a box, and what rounding moves its sides.
constexpr double kAboveWay_m = 0.5, kBesideBox_m = 0.02;
// How far a passageway's axis may be from that of its way, since both are snapped.
constexpr double kOnAxis_m = 0.1;
// Less of a triangle is rounding.
constexpr double kLeastArea_m2 = 1e-3;
constexpr double kBuildingBucket_m = 32;

bool is_for_users(LandCoverClass surface) {
  const LandCoverGroup group = map::values_of(surface).group;
  return (group == LandCoverGroup::kRoad || group == LandCoverGroup::kPath) && surface != LandCoverClass::kRunway;
}

double clearance_m(LandCoverClass surface) {
  const bool is_path = map::values_of(surface).group == LandCoverGroup::kPath;
  return is_path ? map::kLeastPath_m : map::kLeastRoad_m;
}

// All vertices of lines, sorted: a vertex that occurs once is a dead end if a line ends there.
std::vector<Vec2> vertices_of(const scene::Chunk& chunk) {
  std::vector<Vec2> vertices;
  const auto add = [&](const roads::Road& road) {
    vertices.insert(vertices.end(), road.axis.begin(), road.axis.end());
  };
  std::ranges::for_each(chunk.roads, add);
  std::ranges::for_each(chunk.bridges, add);
  std::ranges::for_each(chunk.tunnels, add);
  std::ranges::sort(vertices);
  return vertices;
}

// The passageway of a way in a building that contains both ends of a piece.
const buildings::Passageway* opening_at(const buildings::Building& building, OsmId way, Vec2 a, Vec2 b) {
  const auto is_here = [&](const buildings::Passageway& p) {
    return p.way.osm == way && distance_to_polyline(p.axis, a) <= kOnAxis_m &&
           distance_to_polyline(p.axis, b) <= kOnAxis_m;
  };
  const auto found = std::ranges::find_if(building.passageways, is_here);
  return found == building.passageways.end() ? nullptr : &*found;
}

// Makes the boxes of one way after another.
struct BoxMaker {
  const scene::Chunk& chunk;
  const LandAt& land_m;
  BoxGrid buildings{};
  std::vector<Box2> near{};
  std::vector<Vec2> vertices{};
  std::vector<WayBox> boxes{};

  BoxMaker(const scene::Chunk& c, const LandAt& land) : chunk(c), land_m(land), vertices(vertices_of(c)) {
    for (const buildings::Building& b : c.buildings) near.push_back(box_of(b.footprint.outer).widened(kNear_m));
    buildings = grid_of(near, kBuildingBucket_m);
  }

  bool is_dead_end(Vec2 end) const { return equal_span(vertices, end).size() == 1; }

  double height_m(const roads::Road& road, Vec2 p, double at_m) const {
    return road.profile.empty() ? land_m(p) : knot_at(road.profile, at_m).z_m;
  }

  void add_way(const roads::Road& road) {
    const std::vector<double> along_m = roads::distances_along(road);
    const double half_m = roads::width_m(road) / 2;
    const double begin_m = along_m.front() + (is_dead_end(road.axis.front()) ? half_m : 0);
    const double end_m = along_m.back() - (is_dead_end(road.axis.back()) ? half_m : 0);
    for (std::size_t i = 0; i + 1 < road.axis.size(); ++i) {
      const double from_m = std::max(along_m[i], begin_m), to_m = std::min(along_m[i + 1], end_m);
      if (from_m < to_m) add_segment(road, i, along_m[i], from_m, to_m);
    }
  }

  // The part of a segment between two distances along the whole way.
  void add_segment(const roads::Road& road, std::size_t i, double start_m, double from_m, double to_m) {
    const Vec2 start = road.axis[i], along = unit(road.axis[i + 1] - start);
    const double half_m = std::max(roads::left_m(road), roads::right_m(road));
    const Vec2 ends[] = {start + along * (from_m - start_m), start + along * (to_m - start_m)};
    if (!is_any_about(buildings, box_of(ends).widened(half_m))) return;
    const int pieces = std::max(1, static_cast<int>(std::ceil((to_m - from_m) / kPiece_m)));
    for (int k = 0; k < pieces; ++k) {
      const double a_m = from_m + (to_m - from_m) * k / pieces, b_m = from_m + (to_m - from_m) * (k + 1) / pieces;
      add_piece(road, {start + along * (a_m - start_m), a_m}, {start + along * (b_m - start_m), b_m});
    }
  }

  struct PieceEnd {
    Vec2 at;
    double along_m;
  };

  void add_piece(const roads::Road& road, const PieceEnd& a, const PieceEnd& b) {
    const Vec2 ends[] = {a.at, b.at};
    const double half_m = std::max(roads::left_m(road), roads::right_m(road));
    const Box2 around = box_of(ends).widened(half_m);
    std::optional<WayBox> box;
    for (const std::uint32_t n : boxes_about(buildings, around)) {
      if (!near[n].touches(around)) continue;
      if (!box) box = box_of_piece(road, a, b);
      add_box(*box, chunk.buildings[n], b.at);
    }
  }

  WayBox box_of_piece(const roads::Road& road, const PieceEnd& a, const PieceEnd& b) const {
    WayBox box{road.id.osm, {}, a.at, unit(b.at - a.at)};
    box.length_m = distance(a.at, b.at);
    const roads::RoadEdges from = roads::road_edges_at(road, a.along_m), to = roads::road_edges_at(road, b.along_m);
    box.left_m = std::min(from.kerb_left_m, to.kerb_left_m) - kBesideBox_m;
    box.right_m = std::min(from.kerb_right_m, to.kerb_right_m) - kBesideBox_m;
    const double low_m = height_m(road, a.at, a.along_m), end_m = height_m(road, b.at, b.along_m);
    box.low_m = low_m + kAboveWay_m, box.rise = box.length_m > 0 ? (end_m - low_m) / box.length_m : 0;
    box.height_m = clearance_m(road.surface) - kAboveWay_m;
    return box;
  }

  // Adds the box, cut at the ends of openings.
  void add_box(const WayBox& box, const buildings::Building& building, Vec2 end) {
    std::vector<double> cuts_m{0, box.length_m};
    for (const buildings::Passageway& p : building.passageways)
      for (const Vec2 mouth : {p.axis.front(), p.axis.back()})
        if (p.way.osm == box.way && distance_to_segment(box.from, end, mouth) <= kOnAxis_m)
          cuts_m.push_back(std::clamp(dot(mouth - box.from, box.along), 0.0, box.length_m));
    std::ranges::sort(cuts_m);
    for (std::size_t i = 0; i + 1 < cuts_m.size(); ++i)
      if (cuts_m[i + 1] - cuts_m[i] > kBesideBox_m) add_part(box, building, cuts_m[i], cuts_m[i + 1]);
  }

  // The part of the box between two distances, in an opening or not.
  void add_part(WayBox box, const buildings::Building& building, double from_m, double to_m) {
    box.building = building.id.osm;
    box.from = box.from + box.along * from_m, box.low_m += box.rise * from_m, box.length_m = to_m - from_m;
    if (const buildings::Passageway* opening =
            opening_at(building, box.way, box.from, box.from + box.along * box.length_m)) {
      const double highest_m = std::max(box.low_m, box.low_m + box.rise * box.length_m);
      box.is_in_opening = true;
      // an opening that ends inside has a wall at its end
      box.from = box.from + box.along * kBesideBox_m, box.low_m += box.rise * kBesideBox_m;
      box.length_m -= 2 * kBesideBox_m;
      box.height_m = std::min(box.height_m, opening->top_m - kBesideBox_m - highest_m);
    }
    if (box.length_m > 0 && box.height_m > 0 && box.left_m + box.right_m > 0) boxes.push_back(box);
  }
};

// A place in a box: along its axis, to the left, and above its lower end.
Vec3 in_box(const WayBox& box, Vec3 p) {
  const Vec2 offset = in_plan(p) - box.from;
  const double at_m = dot(offset, box.along);
  return {at_m, cross(box.along, offset), p.z - box.low_m - box.rise * at_m};
}

// Keeps the part of a polygon where inside(p) >= 0; `inside` is linear.
template <typename Inside>
std::vector<Vec3> clipped(const std::vector<Vec3>& polygon, Inside inside) {
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double of_a = inside(a), of_b = inside(b);
    if (of_a >= 0) kept.push_back(a);
    if ((of_a < 0) != (of_b < 0)) kept.push_back(a + (b - a) * (of_a / (of_a - of_b)));
  }
  return kept;
}

double area_of_polygon_m2(const std::vector<Vec3>& polygon) {
  Vec3 sum{};
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum = sum + cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  return length(sum) / 2;
}

// The area of a triangle inside a box.
double area_inside_m2(const WayBox& box, const std::array<Vec3, 3>& triangle) {
  std::vector<Vec3> polygon;
  for (const Vec3 corner : triangle) polygon.push_back(in_box(box, corner));
  polygon = clipped(polygon, [](Vec3 p) { return p.x; });
  polygon = clipped(polygon, [&](Vec3 p) { return box.length_m - p.x; });
  polygon = clipped(polygon, [&](Vec3 p) { return box.left_m - p.y; });
  polygon = clipped(polygon, [&](Vec3 p) { return box.right_m + p.y; });
  polygon = clipped(polygon, [](Vec3 p) { return p.z; });
  polygon = clipped(polygon, [&](Vec3 p) { return box.height_m - p.z; });
  return area_of_polygon_m2(polygon);
}

// The boxes beside one building, with their extents in plan and height.
struct NearBoxes {
  std::span<const WayBox> boxes;
  std::vector<Box2> plans;
  Box2 plan;
  double low_m = std::numeric_limits<double>::infinity(), high_m = -low_m;
};

Box2 plan_of(const WayBox& box) {
  const Vec2 left = left_of(box.along), end = box.from + box.along * box.length_m;
  const Vec2 corners[] = {box.from + left * box.left_m, box.from - left * box.right_m, end + left * box.left_m,
                          end - left * box.right_m};
  return box_of(corners);
}

NearBoxes near_boxes_of(std::span<const WayBox> boxes) {
  NearBoxes near{boxes, {}, {}};
  for (const WayBox& box : boxes) {
    const Box2 plan = near.plans.emplace_back(plan_of(box));
    near.plan.grow(plan.min), near.plan.grow(plan.max);
    const double end_m = box.low_m + box.rise * box.length_m;
    near.low_m = std::min({near.low_m, box.low_m, end_m});
    near.high_m = std::max(near.high_m, std::max(box.low_m, end_m) + box.height_m);
  }
  return near;
}

// The boxes beside each feature of a tile.
std::vector<NearBoxes> near_boxes_of(std::span<const WayBox> boxes, const std::vector<OsmId>& features) {
  std::vector<NearBoxes> near;
  for (const OsmId feature : features) {
    const auto range = equal_span(boxes, feature, &WayBox::building);
    near.push_back(near_boxes_of({range.begin(), range.end()}));
  }
  return near;
}

using Met = std::map<std::tuple<OsmId, OsmId, bool>, WayIntoWall>;

void meet(const NearBoxes& near, const std::array<Vec3, 3>& triangle, Met& met) {
  const auto [low, high] = std::ranges::minmax(triangle, {}, &Vec3::z);
  if (high.z < near.low_m || low.z > near.high_m) return;
  const Box2 plan = box_of(std::array{in_plan(triangle[0]), in_plan(triangle[1]), in_plan(triangle[2])});
  if (!plan.touches(near.plan)) return;
  for (std::size_t i = 0; i < near.boxes.size(); ++i) {
    if (!plan.touches(near.plans[i])) continue;
    const WayBox& box = near.boxes[i];
    const double area_m2 = area_inside_m2(box, triangle);
    if (area_m2 < kLeastArea_m2) continue;
    const auto key = std::tuple(box.building, box.way, box.is_in_opening);
    met.try_emplace(key, WayIntoWall{box.way, box.building, 0, box.from, box.is_in_opening}).first->second.area_m2 +=
        area_m2;
  }
}

}  // namespace

std::vector<WayBox> way_boxes_of(const scene::Chunk& chunk, const LandAt& land_m) {
  if (chunk.buildings.empty()) return {};
  BoxMaker maker(chunk, land_m);
  for (const roads::Road& road : chunk.roads)
    if (is_for_users(road.surface)) maker.add_way(road);
  std::ranges::stable_sort(maker.boxes, {}, &WayBox::building);
  return std::move(maker.boxes);
}

std::vector<WayIntoWall> measure_ways(std::span<const WayBox> boxes, const bake::BakedTile& tile) {
  const std::vector<NearBoxes> near = near_boxes_of(boxes, tile.features);
  Met met;
  for (const bake::Primitive& primitive : tile.primitives) {
    if (primitive.layer != bake::Layer::kBuildings) continue;
    for (const auto& triangle : primitive.triangles) {
      const NearBoxes& beside = near[primitive.features[triangle[0]]];
      if (beside.boxes.empty()) continue;
      std::array<Vec3, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) corners[i] = bake::widened(primitive.positions[triangle[i]]) + tile.origin;
      meet(beside, corners, met);
    }
  }
  std::vector<WayIntoWall> ways;
  for (const auto& [key, way] : met) ways.push_back(way);
  return ways;
}

std::vector<WayIntoWall> combined(std::vector<WayIntoWall> all) {
  std::ranges::stable_sort(all, std::ranges::greater{}, &WayIntoWall::area_m2);
  std::map<std::tuple<OsmId, OsmId, bool>, bool> known;
  std::erase_if(all, [&](const WayIntoWall& w) {
    return !known.try_emplace({w.building, w.way, w.is_in_opening}).second;
  });
  return all;
}

}  // namespace citykiln::verify
