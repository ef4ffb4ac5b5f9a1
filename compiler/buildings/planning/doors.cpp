#include "compiler/buildings/planning/doors.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "compiler/geometry/segment.h"

namespace citykiln::buildings {
namespace {

constexpr double kDoorBucket_m = 32;
// Mappers put house numbers up to a step behind the wall.
constexpr double kMaxDistance_m = 1.5;

// A place on an edge; `share` is the distance along it over its length.
struct EdgePoint {
  std::size_t edge;
  double share, distance_m;
};

bool is_long_enough(double length_m) { return length_m >= 2 * kMinDoorToCorner_m; }

std::optional<EdgePoint> nearest_edge_point(const Ring& ring, Vec2 p) {
  std::optional<EdgePoint> nearest;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
    if (!is_long_enough(distance(a, b))) continue;
    const double share = nearest_share(a, b, p);
    const double distance_m = distance(p, a + (b - a) * share);
    if (distance_m <= kMaxDistance_m && (!nearest || distance_m < nearest->distance_m))
      nearest = EdgePoint{i, share, distance_m};
  }
  return nearest;
}

std::uint16_t slot_bit(double share) {
  const auto slot = static_cast<std::uint32_t>(share * kDoorSlots);
  return static_cast<std::uint16_t>(1u << std::min(slot, kDoorSlots - 1));
}

}  // namespace

MappedDoors index_doors(std::span<const map::PointFeature> points) {
  MappedDoors doors;
  std::vector<Box2> boxes;
  for (const map::PointFeature& point : points) {
    if (point.kind != map::PointKind::kEntrance && point.kind != map::PointKind::kAddress) continue;
    doors.at.push_back(point.at);
    doors.is_entrance.push_back(point.kind == map::PointKind::kEntrance);
    boxes.emplace_back().grow(point.at);
  }
  doors.grid = grid_of(boxes, kDoorBucket_m);
  return doors;
}

std::vector<std::uint16_t> mapped_doors_by_edge(const Polygon& footprint, const MappedDoors& doors) {
  assert(doors.at.size() == doors.is_entrance.size());
  const Ring& ring = footprint.outer;
  std::vector<std::uint16_t> entrances(ring.size()), addresses(ring.size());
  bool has_entrance = false;
  if (doors.at.empty()) return entrances;
  for (const std::uint32_t i : boxes_about(doors.grid, box_of(ring).widened(kMaxDistance_m))) {
    const std::optional<EdgePoint> point = nearest_edge_point(ring, doors.at[i]);
    if (!point) continue;
    (doors.is_entrance[i] ? entrances : addresses)[point->edge] |= slot_bit(point->share);
    has_entrance |= doors.is_entrance[i];
  }
  return has_entrance ? entrances : addresses;
}

std::vector<double> door_places_m(std::uint16_t doors, double length_m) {
  std::vector<double> places;
  if (!is_long_enough(length_m)) return places;
  for (std::uint32_t slot = 0; slot < kDoorSlots; ++slot) {
    if ((doors >> slot & 1) == 0) continue;
    places.push_back(
        std::clamp((slot + 0.5) / kDoorSlots * length_m, kMinDoorToCorner_m, length_m - kMinDoorToCorner_m));
  }
  return places;
}

std::vector<Vec2> door_positions(const Building& building) {
  const Ring& ring = building.footprint.outer;
  std::vector<Vec2> positions;
  for (std::size_t i = 0; i < building.facade_edges.size() && i < ring.size(); ++i) {
    const Vec2 from = ring[i], along = ring[(i + 1) % ring.size()] - from;
    for (const double at_m : door_places_m(building.facade_edges[i].doors, length(along)))
      positions.push_back(from + unit(along) * at_m);
  }
  return positions;
}

}  // namespace citykiln::buildings
