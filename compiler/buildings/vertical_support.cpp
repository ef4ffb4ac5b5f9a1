#include "compiler/buildings/vertical_support.h"

#include <algorithm>

#include "compiler/buildings/party_walls.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/map/building_classes.h"

namespace citykiln::buildings {
namespace {

using map::Footprint;

constexpr double kBucket_m = 32;
// What ends so far below carries what is above: storeys are guessed.
constexpr double kStorey_m = 3.5;
// What hovers higher has lost more than its base: a dome without its drum is no column.
constexpr double kBase_m = 12;
// Bays and bridges between houses are smaller.
constexpr double kBay_m2 = 150;
// Of the places under it; less is how roughly outlines are drawn.
constexpr double kCarriedShare = 0.02;
constexpr int kPlacesASide = 16;

Box2 box_of(const Footprint& footprint) { return citykiln::box_of(footprint.polygon.outer); }

// Footprints by place.
struct Lots {
  std::span<const Footprint> footprints;
  std::vector<std::uint32_t> numbers;  ///< Of those that are built.
  BoxGrid grid;                        ///< Of their boxes.

  // Calls `visit` for those that hold the place.
  template <typename Visit>
  void at(Vec2 p, Visit visit) const {
    for (const std::uint32_t i : boxes_about(grid, p)) {
      const Footprint& lot = footprints[numbers[i]];
      if (box_of(lot).contains(p) && contains(lot.polygon, p)) visit(numbers[i]);
    }
  }
};

Lots lots_of(std::span<const Footprint> footprints) {
  Lots lots{footprints, {}, {}};
  std::vector<Box2> boxes;
  for (std::uint32_t i = 0; i < footprints.size(); ++i) {
    if (footprints[i].has_parts || footprints[i].polygon.outer.size() < 3) continue;
    lots.numbers.push_back(i);
    boxes.push_back(box_of(footprints[i]));
  }
  lots.grid = grid_of(boxes, kBucket_m);
  return lots;
}

bool carries(const Footprint& lower, const Footprint& upper) {
  return lower.min_height_m < upper.min_height_m && lower.height_m + kStorey_m >= upper.min_height_m;
}

bool is_carried_at(const Lots& lots, const Footprint& upper, Vec2 p) {
  bool is_carried = false;
  lots.at(p, [&](std::uint32_t i) { is_carried |= carries(lots.footprints[i], upper); });
  return is_carried;
}

// Columns and shafts, which may be thin, stand whole under what they carry.
bool has_column(const Lots& lots, const Footprint& upper) {
  return std::ranges::any_of(boxes_about(lots.grid, box_of(upper)), [&](std::uint32_t i) {
    const Footprint& lower = lots.footprints[lots.numbers[i]];
    return carries(lower, upper) && contains(upper.polygon, box_of(lower).centre());
  });
}

bool is_carried(const Lots& lots, const Footprint& upper) {
  if (has_column(lots, upper)) return true;
  const Box2 box = box_of(upper);
  int places = 0, carried = 0;
  for (int i = 0; i < kPlacesASide * kPlacesASide; ++i) {
    const Vec2 share{(i % kPlacesASide + 0.5) / kPlacesASide, (i / kPlacesASide + 0.5) / kPlacesASide};
    const Vec2 p{box.min.x + share.x * box.width(), box.min.y + share.y * box.height()};
    if (!contains(upper.polygon, p)) continue;
    ++places, carried += is_carried_at(lots, upper, p);
  }
  return carried > kCarriedShare * places;
}

// Of tracks on the ground and on bridges; those in tunnels pass under everything.
std::vector<Vec2> places_along(std::span<const map::Track> tracks) {
  constexpr double kStep_m = 2;
  std::vector<Vec2> places;
  for (const map::Track& track : tracks) {
    if (track.passage == map::Passage::kTunnel) continue;
    for (std::size_t i = 0; i + 1 < track.axis.size(); ++i) {
      const Vec2 a = track.axis[i], b = track.axis[i + 1];
      const int steps = 1 + static_cast<int>(distance(a, b) / kStep_m);
      for (int k = 0; k < steps; ++k) places.push_back(a + (b - a) * (static_cast<double>(k) / steps));
    }
  }
  return places;
}

// Which footprints a way passes under, or through.
std::vector<bool> passed_under(const Lots& lots, std::span<const map::Track> tracks) {
  std::vector<bool> passed(lots.footprints.size());
  for (const Vec2 p : places_along(tracks)) lots.at(p, [&](std::uint32_t i) { passed[i] = true; });
  return passed;
}

bool is_joined(const Footprint& bay, std::span<const SharedWall> shared, std::span<const Footprint> footprints) {
  return std::ranges::any_of(shared, [&](const SharedWall& wall) {
    const Footprint& other = footprints[wall.neighbour];
    return other.min_height_m <= bay.min_height_m && other.height_m > bay.min_height_m;
  });
}

// Off the ground, and nothing that may be.
bool has_to_be_held(const Footprint& f, bool is_passed) {
  const bool is_roof = static_cast<map::BuildingClass>(f.building_class) == map::BuildingClass::kRoof;
  return f.min_height_m > 0 && f.min_height_m <= kBase_m && !f.has_parts && f.polygon.outer.size() >= 3 && !is_roof &&
         !is_passed;
}

}  // namespace

std::vector<bool> find_supported(std::span<const Footprint> footprints, std::span<const map::Track> tracks) {
  const Lots lots = lots_of(footprints);
  const std::vector<bool> passed = passed_under(lots, tracks);
  const std::vector<std::vector<SharedWall>> shared = shared_walls(footprints);
  std::vector<bool> held(footprints.size(), true);
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    const Footprint& f = footprints[i];
    if (!has_to_be_held(f, passed[i])) continue;
    const bool is_bay = area_m2(f.polygon) < kBay_m2 && is_joined(f, shared[i], footprints);
    held[i] = is_bay || is_carried(lots, f);
  }
  return held;
}

}  // namespace citykiln::buildings
