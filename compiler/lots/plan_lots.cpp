#include "compiler/lots/plan_lots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>
#include <tuple>
#include <utility>

#include "compiler/contract/system/for_each_slot.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/polygons/centroid.h"
#include "compiler/geometry/segment.h"
#include "compiler/lots/coarse_outlines.h"
#include "compiler/lots/courts.h"
#include "compiler/lots/land_use.h"
#include "compiler/map/buildings/building_classes.h"

namespace citykiln::lots {
namespace {

using map::BuildingClass;
using map::LandCoverClass;

constexpr double kLotBucket_m = 64;
// Walls of houses that touch are this near, and opposite within 8 degrees.
constexpr double kTouchingWalls_m = 0.3, kOppositeWalls = -0.99;
// Houses touch along this length at least.
constexpr double kLeastShared_m = 3;
// Plain buildings: a larger one is no single house; one of this height is an apartment house; a low one of this area
// is a hall.
constexpr double kLargestHouse_m2 = 350, kApartmentLevels = 4, kApartmentHeight_m = 12, kLeastHall_m2 = 1200;
// Buildings have doors at mapped places up to this far from a wall, in edges of this length
// (buildings/planning/doors.h).
constexpr double kDoorDistance_m = 1.5, kLeastDoorEdge_m = 2.5;
// The place of a door in its edge: the middle of the ninth of the sixteen slots that buildings have.
constexpr double kDoorShare = 8.5 / 16;
// A wall faces the front within 45 degrees. A metre of length outweighs this much distance from the street.
constexpr double kFacesFront = 0.7, kPerLength = 0.2, kLongestWall_m = 10;

BuildingClass class_of(const map::Footprint& footprint) { return static_cast<BuildingClass>(footprint.building_class); }

// A wall of a footprint.
struct Wall {
  Vec2 a, b;
  std::uint32_t footprint;
};

struct Walls {
  std::vector<Wall> all;
  BoxGrid grid;
};

Walls walls_of_map(const map::FeatureView& features, const std::vector<std::uint32_t>& footprints) {
  Walls walls;
  std::vector<Box2> boxes;
  for (const std::uint32_t f : footprints) {
    const Ring& ring = features.footprints[f].polygon.outer;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      walls.all.push_back({ring[i], ring[(i + 1) % ring.size()], f});
      boxes.push_back(box_of_segment(ring[i], ring[(i + 1) % ring.size()]).widened(1));
    }
  }
  if (!boxes.empty()) walls.grid = grid_of(boxes, kLotBucket_m);
  return walls;
}

bool is_party_wall(const Walls& walls, std::uint32_t footprint, Vec2 at, Vec2 along) {
  return std::ranges::any_of(boxes_about(walls.grid, at), [&](std::uint32_t i) {
    const Wall& wall = walls.all[i];
    return wall.footprint != footprint && dot(unit(wall.b - wall.a), along) < kOppositeWalls &&
           distance_to_segment(wall.a, wall.b, at) <= kTouchingWalls_m;
  });
}

// The length along which a building touches others, from the quarters of its edges.
double shared_length_m(const Walls& walls, std::uint32_t footprint, const Ring& ring) {
  double shared_m = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
    for (const double share : {0.125, 0.375, 0.625, 0.875})
      if (a != b && is_party_wall(walls, footprint, a + (b - a) * share, unit(b - a))) shared_m += distance(a, b) / 4;
  }
  return shared_m;
}

bool is_shed(const map::Footprint& f) {
  return class_of(f) == BuildingClass::kGarage || class_of(f) == BuildingClass::kHut ||
         class_of(f) == BuildingClass::kGreenhouse;
}

bool is_public(BuildingClass own) {
  return own == BuildingClass::kChurch || own == BuildingClass::kCivic || own == BuildingClass::kSchool ||
         own == BuildingClass::kHospital || own == BuildingClass::kCastle || own == BuildingClass::kTower;
}

bool is_shop(BuildingClass own) {
  return own == BuildingClass::kShop || own == BuildingClass::kOffice || own == BuildingClass::kHotel;
}

LotKind kind_of_house(const map::Footprint& f, double area, bool is_attached) {
  const bool is_high = f.levels > 0 ? f.levels >= kApartmentLevels : f.height_m >= kApartmentHeight_m;
  const bool is_block = class_of(f) == BuildingClass::kApartments || is_high ||
                        (class_of(f) != BuildingClass::kHouse && area > kLargestHouse_m2);
  if (is_attached) return is_block ? LotKind::kPerimeter : LotKind::kRow;
  return is_block ? LotKind::kApartments : LotKind::kDetached;
}

LotKind kind_of_lot(const map::Footprint& f, LandCoverClass use, bool is_attached) {
  const BuildingClass own = class_of(f);
  const double area = area_m2(f.polygon);
  if (is_shed(f) || own == BuildingClass::kBarn || own == BuildingClass::kShell) return LotKind::kNone;
  if (is_public(own)) return LotKind::kPublic;
  if (own == BuildingClass::kHall || use == LandCoverClass::kIndustrial) return LotKind::kWorks;
  if (is_shop(own) || use == LandCoverClass::kRetail || use == LandCoverClass::kCommercial) return LotKind::kShop;
  if (own == BuildingClass::kPlain && f.has_shop && !is_attached) return LotKind::kShop;
  const bool is_low = f.levels > 0 ? f.levels <= 2 : f.height_m <= kApartmentHeight_m;
  if (own == BuildingClass::kPlain && use == LandCoverClass::kUnknown && area >= kLeastHall_m2 && is_low)
    return LotKind::kWorks;
  return kind_of_house(f, area, is_attached);
}

Vec2 outward_of(Vec2 a, Vec2 b) { return left_of(unit(b - a)) * -1; }

// The place on a wall that is nearest to a mapped door, if it is near enough.
std::optional<Door> door_near(const Ring& ring, Vec2 p) {
  std::optional<Door> door;
  double least_m = kDoorDistance_m;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
    if (distance(a, b) < kLeastDoorEdge_m) continue;
    const Vec2 at = nearest_point(a, b, p);
    if (distance(at, p) > least_m) continue;
    least_m = distance(at, p);
    door = Door{at, outward_of(a, b), true};
  }
  return door;
}

// Entrances and house numbers of a map.
struct DoorPoints {
  std::span<const map::PointFeature> points;
  std::vector<std::uint32_t> numbers;
  BoxGrid grid;
};

DoorPoints index_door_points(const map::FeatureView& features) {
  DoorPoints doors{features.points, {}, {}};
  std::vector<Box2> boxes;
  for (std::uint32_t i = 0; i < doors.points.size(); ++i) {
    const map::PointFeature& point = doors.points[i];
    if (point.kind != map::PointKind::kEntrance && point.kind != map::PointKind::kAddress) continue;
    doors.numbers.push_back(i);
    boxes.push_back(Box2{point.at, point.at});
  }
  if (!boxes.empty()) doors.grid = grid_of(boxes, kLotBucket_m);
  return doors;
}

// The mapped door nearest to the street; house numbers count only where no entrance is mapped.
std::optional<Door> mapped_door(const Ring& ring, const Frame& frame, const DoorPoints& doors) {
  if (doors.numbers.empty()) return std::nullopt;
  const std::vector<std::uint32_t> near = boxes_about(doors.grid, box_of(ring).widened(kDoorDistance_m));
  for (const map::PointKind kind : {map::PointKind::kEntrance, map::PointKind::kAddress}) {
    std::optional<Door> nearest;
    for (const std::uint32_t i : near) {
      const map::PointFeature& point = doors.points[doors.numbers[i]];
      if (point.kind != kind) continue;
      const std::optional<Door> door = door_near(ring, point.at);
      if (door && (!nearest || frame.local(door->at).y < frame.local(nearest->at).y)) nearest = door;
    }
    if (nearest) return nearest;
  }
  return std::nullopt;
}

// The middle of the wall that faces the front and is nearest to it.
std::optional<Door> door_to_front(std::uint32_t footprint, const Ring& ring, const Frame& frame, const Walls& walls) {
  std::optional<Door> best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()], outward = outward_of(a, b);
    if (distance(a, b) < kLeastDoorEdge_m || dot(outward, frame.inward) > -kFacesFront) continue;
    const Vec2 at = a + (b - a) * kDoorShare;
    const double score = frame.local(at).y - kPerLength * std::min(distance(a, b), kLongestWall_m);
    if (score >= least || is_party_wall(walls, footprint, at, unit(b - a))) continue;
    least = score;
    best = Door{at, outward, false};
  }
  return best;
}

struct LotPlanner {
  const map::FeatureView& features;
  const MapLand& land;
  const ClimateAt& climate_at;
  Walls walls = walls_of_map(features, land.footprints);
  LandUse uses = index_land_use(features);
  DoorPoints doors = index_door_points(features);
  CourtGreen green = index_court_green(features);

  // The largest building, sheds last.
  std::uint32_t main_of(const std::vector<std::uint32_t>& footprints) const {
    return *std::ranges::max_element(footprints, {}, [&](std::uint32_t f) {
      const map::Footprint& footprint = features.footprints[f];
      return std::tuple(!is_shed(footprint), area_m2(footprint.polygon), footprint.id);
    });
  }

  std::optional<Lot> lot_of(const parcels::Lot& parcel) const {
    if (parcel.footprints.empty()) return std::nullopt;
    Lot lot{.parcel = parcel};
    for (const std::uint32_t f : parcel.footprints) lot.footprints.push_back(land.footprints[f]);
    lot.main = main_of(lot.footprints);
    const map::Footprint& main = features.footprints[lot.main];
    const Vec2 middle = centroid(main.polygon);
    const std::optional<Frame> at_street = frame_of(parcel.frontage, land.land.lines[parcel.frontage.line], middle);
    if (!at_street) return std::nullopt;
    lot.frame = place_of(*at_street);
    const Frame frame = frame_at(lot.frame);
    const Ring& ring = main.polygon.outer;
    const bool is_attached = shared_length_m(walls, lot.main, ring) >= kLeastShared_m;
    lot.kind = kind_of_lot(main, land_use_at(uses, middle), is_attached);
    if (lot.kind == LotKind::kPerimeter) lot.kind = court_of(green, middle);
    lot.country = main.country;
    lot.climate = climate_at(middle);
    lot.setback_m = setback_of(ring, lot.frame);
    lot.door = mapped_door(ring, frame, doors);
    if (!lot.door) lot.door = door_to_front(lot.main, ring, frame, walls);
    return lot;
  }
};

// Gives all lots coarse outlines.
void coarsen(std::vector<Lot>& lots) {
  std::vector<Polygon> outlines;
  for (Lot& lot : lots) outlines.push_back(std::move(lot.parcel.polygon));
  outlines = coarse_outlines(outlines);
  for (std::size_t i = 0; i < lots.size(); ++i) lots[i].parcel.polygon = std::move(outlines[i]);
}

}  // namespace

std::optional<Frame> frame_of(const parcels::Frontage& frontage, const parcels::Line& line, Vec2 to) {
  const auto [from, end] = std::minmax(frontage.from, frontage.to, [](const auto& a, const auto& b) {
    return std::pair(a.segment, a.at_m) < std::pair(b.segment, b.at_m);
  });
  const double sign = frontage.side == parcels::Side::kLeft ? 1 : -1;
  const double half_m =
      std::max(parcels::kLeastRightOfWay_m, frontage.side == parcels::Side::kLeft ? line.left_m : line.right_m);
  std::optional<Frame> nearest;
  double least_m = std::numeric_limits<double>::infinity();
  for (std::uint32_t s = from.segment; s <= end.segment && s + 1 < line.axis.size(); ++s) {
    const Vec2 a = line.axis[s], along = unit(line.axis[s + 1] - a);
    const double length = distance(a, line.axis[s + 1]);
    const double low_m = s == from.segment ? std::clamp(from.at_m, 0.0, length) : 0,
                 high_m = s == end.segment ? std::clamp(end.at_m, 0.0, length) : length;
    const Vec2 on_axis = nearest_point(a + along * std::min(low_m, high_m), a + along * high_m, to);
    if (along == Vec2{} || distance(on_axis, to) >= least_m) continue;
    least_m = distance(on_axis, to);
    const Vec2 inward = left_of(along) * sign;
    nearest = Frame{on_axis + inward * half_m, along, inward};
  }
  return nearest;
}

std::string_view name_of(LotKind kind) {
  constexpr std::string_view kNames[] = {"detached", "row",      "apartments",  "perimeter",   "shop",   "works",
                                         "public",   "none",     "green_court", "paved_court", "school", "church",
                                         "storage",  "car_park", "green",       "allotment",   "site"};
  static_assert(std::size(kNames) == static_cast<std::size_t>(LotKind::kCount));
  return kNames[static_cast<std::size_t>(kind)];
}

std::vector<Lot> plan_lots(const map::FeatureView& features, const MapLand& land, const parcels::Parcels& parcels,
                           const ClimateAt& climate_at, int threads) {
  const LotPlanner planner{features, land, climate_at};
  auto slots = for_each_slot<std::optional<Lot>>(parcels.lots.size(), threads,
                                                 [&](std::size_t i) { return planner.lot_of(parcels.lots[i]); });
  std::vector<Lot> lots;
  for (std::optional<Lot>& slot : slots)
    if (slot) lots.push_back(std::move(*slot));
  std::ranges::sort(lots, {}, [&](const Lot& lot) { return features.footprints[lot.main].id; });
  coarsen(lots);
  return lots;
}

}  // namespace citykiln::lots
