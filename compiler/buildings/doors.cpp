#include "compiler/buildings/doors.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace citykiln::buildings {
namespace {

constexpr double kBucket_m = 32;
// Mappers put numbers a step behind the wall.
constexpr double kNear_m = 1.5;

// An edge, and how far along it, as a share.
struct Place {
  std::size_t edge;
  double share, away_m;
};

bool is_long_enough(double length_m) { return length_m >= 2 * kMinDoorToCorner_m; }

std::optional<Place> place_of(const Ring& ring, Vec2 p) {
  std::optional<Place> nearest;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 along = ring[(i + 1) % ring.size()] - ring[i];
    if (!is_long_enough(length(along))) continue;
    const double share = std::clamp(dot(p - ring[i], along) / dot(along, along), 0.0, 1.0);
    const double away_m = distance(p, ring[i] + along * share);
    if (away_m <= kNear_m && (!nearest || away_m < nearest->away_m)) nearest = Place{i, share, away_m};
  }
  return nearest;
}

std::uint16_t bit_at(double share) {
  const auto part = static_cast<std::uint32_t>(share * kDoorSlots);
  return static_cast<std::uint16_t>(1u << std::min(part, kDoorSlots - 1));
}

}  // namespace

MappedDoors index_doors(std::span<const map::PointFeature> points) {
  MappedDoors told;
  std::vector<Box2> boxes;
  for (const map::PointFeature& point : points) {
    if (point.kind != map::PointKind::kEntrance && point.kind != map::PointKind::kAddress) continue;
    told.at.push_back(point.at);
    told.is_entrance.push_back(point.kind == map::PointKind::kEntrance);
    boxes.emplace_back().grow(point.at);
  }
  told.grid = grid_of(boxes, kBucket_m);
  return told;
}

std::vector<std::uint16_t> mapped_doors_by_edge(const Polygon& footprint, const MappedDoors& told) {
  const Ring& ring = footprint.outer;
  std::vector<std::uint16_t> entrances(ring.size()), addresses(ring.size());
  bool has_entrance = false;
  if (told.at.empty()) return entrances;
  for (const std::uint32_t i : boxes_about(told.grid, box_of(ring).widened(kNear_m))) {
    const std::optional<Place> place = place_of(ring, told.at[i]);
    if (!place) continue;
    (told.is_entrance[i] ? entrances : addresses)[place->edge] |= bit_at(place->share);
    has_entrance |= told.is_entrance[i];
  }
  return has_entrance ? entrances : addresses;
}

std::vector<Vec2> door_positions(const Building& building) {
  const Ring& ring = building.footprint.outer;
  std::vector<Vec2> places;
  for (std::size_t i = 0; i < building.fronts.size() && i < ring.size(); ++i) {
    const Vec2 from = ring[i], way = ring[(i + 1) % ring.size()] - from;
    const double length_m = length(way);
    if (!is_long_enough(length_m)) continue;
    for (std::uint32_t part = 0; part < kDoorSlots; ++part) {
      if ((building.fronts[i].doors >> part & 1) == 0) continue;
      const double at_m = (part + 0.5) / kDoorSlots * length_m;
      places.push_back(from + unit(way) * std::clamp(at_m, kMinDoorToCorner_m, length_m - kMinDoorToCorner_m));
    }
  }
  return places;
}

}  // namespace citykiln::buildings
