#include "compiler/lots/mapped_things.h"

#include <algorithm>
#include <array>
#include <utility>

#include "compiler/geometry/segment.h"
#include "compiler/roads/junctions/corner_pavements.h"

namespace citykiln::lots {

Capsules index_capsules(std::vector<Capsule> all) {
  constexpr double kBucket_m = 32;
  Capsules capsules{std::move(all), {}};
  std::vector<Box2> boxes;
  for (const Capsule& c : capsules.all) boxes.push_back(box_of_segment(c.a, c.b).widened(c.radius_m));
  if (!boxes.empty()) capsules.grid = grid_of(boxes, kBucket_m);
  return capsules;
}

double clearance_m(const Capsules& capsules, Vec2 p, double search_m) {
  double least_m = search_m;
  any_about(capsules.grid, Box2{p, p}.widened(search_m), [&](std::uint32_t i) {
    const Capsule& c = capsules.all[i];
    least_m = std::min(least_m, distance_to_segment(c.a, c.b, p) - c.radius_m);
    return false;
  });
  return least_m;
}

bool axis_enters(const Capsules& capsules, const Polygon& polygon) {
  if (capsules.all.empty() || polygon.outer.empty()) return false;
  for (const std::uint32_t i : boxes_about(capsules.grid, box_of(polygon.outer))) {
    const Capsule& c = capsules.all[i];
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
      if (contains(polygon, c.a + (c.b - c.a) * share)) return true;
  }
  return false;
}

namespace {

using map::LandCoverGroup;
using roads::Road;

constexpr double kBucket_m = 32;

void add_line(std::span<const Vec2> line, double half_m, std::vector<Capsule>& capsules) {
  for (std::size_t i = 0; i + 1 < line.size(); ++i) capsules.push_back({line[i], line[i + 1], half_m});
}

void add_outline(const Ring& ring, double half_m, std::vector<Capsule>& capsules) {
  add_line(ring, half_m, capsules);
  if (ring.size() > 1) capsules.push_back({ring.back(), ring.front(), half_m});
}

// The distances from the axis to the road's outer edges, raised lanes included, at a vertex.
struct OuterEdges {
  double left_m, right_m;
};

std::vector<OuterEdges> outer_edges(const Road& road) {
  std::vector<OuterEdges> edges;
  for (const double along_m : roads::distances_along(road)) {
    const double drift_m = roads::drift_m(road, along_m);
    edges.push_back({roads::left_m(road) + roads::raised_left_m(road) + drift_m,
                     roads::right_m(road) + roads::raised_right_m(road) - drift_m});
  }
  return edges;
}

// The road with its raised lanes; its middle lies beside the axis if its sides differ.
void add_road(const Road& road, std::vector<Capsule>& capsules) {
  const std::vector<OuterEdges> edges = outer_edges(road);
  for (std::size_t i = 0; i + 1 < road.axis.size(); ++i) {
    const double left_m = std::max(edges[i].left_m, edges[i + 1].left_m),
                 right_m = std::max(edges[i].right_m, edges[i + 1].right_m);
    const Vec2 a = road.axis[i], b = road.axis[i + 1], aside = left_of(unit(b - a)) * ((left_m - right_m) / 2);
    capsules.push_back({a + aside, b + aside, (left_m + right_m) / 2});
  }
}

using ArmsOfJunctions = std::vector<std::vector<roads::Arm>>;

// Adds the corners that a road's outer edges have at its bends, beyond the strips about its axis.
void add_bends(const Road& road, std::vector<Polygon>& corners) {
  constexpr double kStraight = 0.999, kHairpin = -0.8;
  const std::vector<OuterEdges> edges = outer_edges(road);
  for (std::size_t i = 1; i + 1 < road.axis.size(); ++i) {
    const Vec2 at = road.axis[i], in = unit(at - road.axis[i - 1]), out = unit(road.axis[i + 1] - at);
    if (dot(in, out) > kStraight || dot(in, out) < kHairpin) continue;
    const double aside_m = cross(in, out) > 0 ? -edges[i].right_m : edges[i].left_m;
    const Vec2 from = left_of(in) * aside_m, to = left_of(out) * aside_m;
    const Vec2 tip = (from + to) * (1 / (1 + dot(in, out)));
    corners.push_back({.outer = {at, at + from, at + tip, at + to}, .holes = {}});
    if (signed_area_m2(corners.back().outer) < 0) std::ranges::reverse(corners.back().outer);
  }
}

OwnPolygons corners_of(std::span<const Road> roads, std::span<const roads::Junction> junctions,
                       const ArmsOfJunctions& arms) {
  OwnPolygons corners;
  for (const Road& road : roads) add_bends(road, corners.all);
  std::vector<Box2> boxes;
  for (std::size_t j = 0; j < junctions.size(); ++j) {
    for (Ring& ring : roads::stroke(junctions[j], roads, arms[j]))
      corners.all.push_back({.outer = std::move(ring), .holes = {}});
    for (Ring& ring : roads::stroke_corner_pavements(junctions[j], roads, arms[j]))
      corners.all.push_back({.outer = std::move(ring), .holes = {}});
  }
  for (const Polygon& surface : corners.all) boxes.push_back(box_of(surface.outer));
  if (!boxes.empty()) corners.grid = grid_of(boxes, kBucket_m);
  return corners;
}

Capsules zones_of(std::span<const Road> roads, std::span<const roads::Junction> junctions,
                  const ArmsOfJunctions& arms) {
  std::vector<Capsule> nodes;
  for (std::size_t j = 0; j < junctions.size(); ++j) {
    if (junctions[j].family != roads::Family::kStreet) continue;
    double half_m = 0;
    bool is_street = false;
    for (const roads::Arm& arm : arms[j]) {
      half_m = std::max(half_m, roads::width_m(roads[arm.road]) / 2);
      is_street |= roads::is_through_street(roads[arm.road]);
    }
    for (const Vec2 node : junctions[j].nodes)
      nodes.push_back({node, node, half_m + (is_street ? kSight_m : kBesideJunction_m)});
    // the corner between two arms reaches far where they meet at a small angle
    for (const Ring& ring : roads::stroke(junctions[j], roads, arms[j])) add_outline(ring, kBesideCorner_m, nodes);
  }
  return index_capsules(std::move(nodes));
}

}  // namespace

PolygonIndex index_polygons(std::vector<const Polygon*> all) {
  PolygonIndex index{std::move(all), {}};
  std::vector<Box2> boxes;
  for (const Polygon* polygon : index.all) boxes.push_back(box_of(polygon->outer));
  if (!boxes.empty()) index.grid = grid_of(boxes, kBucket_m);
  return index;
}

bool is_inside_any(const PolygonIndex& polygons, Vec2 p) {
  return !polygons.all.empty() && std::ranges::any_of(boxes_about(polygons.grid, p),
                                                      [&](std::uint32_t i) { return contains(*polygons.all[i], p); });
}

bool is_inside_any(const OwnPolygons& polygons, Vec2 p) {
  return !polygons.all.empty() && std::ranges::any_of(boxes_about(polygons.grid, p),
                                                      [&](std::uint32_t i) { return contains(polygons.all[i], p); });
}

MappedThings mapped_things(const map::FeatureView& features, std::span<const Road> roads,
                           std::span<const roads::Junction> junctions, std::span<const OsmId> private_ways) {
  std::vector<const Polygon*> buildings, pools;
  std::vector<Capsule> walls, streets, paths, drives, barriers, trees, wires, parking;
  for (const map::Footprint& f : features.footprints) {
    if (f.min_height_m > 0 || f.polygon.outer.size() < 3) continue;
    buildings.push_back(&f.polygon);
    for (const Ring* ring : rings_of(f.polygon)) add_outline(*ring, 0, walls);
  }
  for (const Road& road : roads) {
    const LandCoverGroup group = map::values_of(road.surface).group;
    const bool is_private = std::ranges::binary_search(private_ways, road.id.osm);
    add_road(road, is_private ? drives : group == LandCoverGroup::kPath ? paths : streets);
  }
  for (const map::Barrier& barrier : features.barriers)
    if (barrier.kind != map::BarrierKind::kKerb) add_line(barrier.axis, barrier.width_m / 2, barriers);
  for (const map::PointFeature& point : features.points)
    if (point.kind == map::PointKind::kTree) trees.push_back({point.at, point.at, 0});
  for (const map::TreeRow& row : features.tree_rows) add_line(row.axis, 0, trees);
  for (const map::PowerLine& line : features.power_lines)
    add_line(line.axis, line.corridor_m / 2 + kClearOfWires_m, wires);
  for (const map::AreaFeature& area : features.areas) {
    if (area.surface == map::LandCoverClass::kParking || area.surface == map::LandCoverClass::kServiceArea)
      add_outline(area.polygon.outer, 0, parking);
    if (area.surface == map::LandCoverClass::kPool) pools.push_back(&area.polygon);
  }
  const ArmsOfJunctions arms = roads::arms_of(junctions, roads);
  return {.buildings = index_polygons(std::move(buildings)),
          .walls = index_capsules(std::move(walls)),
          .roads = index_capsules(std::move(streets)),
          .paths = index_capsules(std::move(paths)),
          .drives = index_capsules(std::move(drives)),
          .barriers = index_capsules(std::move(barriers)),
          .trees = index_capsules(std::move(trees)),
          .wires = index_capsules(std::move(wires)),
          .junction_zones = zones_of(roads, junctions, arms),
          .corners = corners_of(roads, junctions, arms),
          .parking = index_capsules(std::move(parking)),
          .pools = index_polygons(std::move(pools))};
}

}  // namespace citykiln::lots
