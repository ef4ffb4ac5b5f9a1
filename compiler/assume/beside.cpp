#include "compiler/assume/beside.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "compiler/assume/room.h"
#include "compiler/assume/side_rays.h"
#include "compiler/geometry/segment.h"
#include "compiler/map/buildings/building_classes.h"

namespace citykiln::assume {
namespace {

using map::LandCoverClass;
using map::LandCoverGroup;
using LineKind = MappedLine::Kind;

constexpr double kLineBucket_m = 32;
constexpr double kLandSample_m = 8;
// Land use is looked up at every third sample.
constexpr std::size_t kLandEvery = 3;
// A paved square begins this far behind the kerb at most.
constexpr double kBehindKerb_m = 1.5;
// A quarter of a side may have less room before buildings and walls: the road narrows there (roads/width_limits).
constexpr double kNarrowShare = 0.25;

LandCoverGroup cover_group_of(LandCoverClass surface) { return map::values_of(surface).group; }

LandUse land_use_of(LandCoverClass surface) {
  switch (surface) {
    case LandCoverClass::kResidential:
      return LandUse::kResidential;
    case LandCoverClass::kRailwayLand:
      return LandUse::kRailway;
    case LandCoverClass::kParking:
    case LandCoverClass::kServiceArea:
      return LandUse::kParking;
    case LandCoverClass::kMeadow:
    case LandCoverClass::kGrassland:
    case LandCoverClass::kFell:
    case LandCoverClass::kHeath:
    case LandCoverClass::kGolfCourse:
      return LandUse::kFarmland;
    default:
      break;
  }
  switch (cover_group_of(surface)) {
    case LandCoverGroup::kTown:
      return LandUse::kShops;
    case LandCoverGroup::kIndustry:
      return LandUse::kIndustry;
    case LandCoverGroup::kFarm:
      return LandUse::kFarmland;
    case LandCoverGroup::kGarden:
    case LandCoverGroup::kSport:
    case LandCoverGroup::kGrassland:
      return LandUse::kGreen;
    case LandCoverGroup::kForest:
    case LandCoverGroup::kScrubland:
      return LandUse::kWood;
    case LandCoverGroup::kWater:
      return LandUse::kWater;
    default:
      return LandUse::kNone;
  }
}

// The greater distance from a way's axis to its outer edges.
double widest_half_m(const map::CrossSection& section) {
  double left_m = left_kerb_m(section), right_m = right_kerb_m(section);
  bool is_left = true;
  for (const map::Lane& lane : section.lanes) {
    is_left &= lane.is_raised;
    if (lane.is_raised) (is_left ? left_m : right_m) += lane.width_m;
  }
  return std::max(left_m, right_m);
}

// The direction of a one-way street's traffic: 1 along the way, -1 against it, 0 if it has both.
int flow_of(const map::Track& track) {
  if (!track.is_oneway && !track.is_roundabout) return 0;
  bool is_backward = false, is_forward = false;
  for (const map::Lane& lane : track.section.lanes) {
    if (lane.kind != map::LaneKind::kDriving && lane.kind != map::LaneKind::kBus) continue;
    is_backward |= lane.way == map::LaneDirection::kBackward, is_forward |= lane.way == map::LaneDirection::kForward;
  }
  return is_backward == is_forward ? 0 : is_forward ? 1 : -1;
}

bool is_through(LandCoverClass surface) {
  return surface == LandCoverClass::kResidentialRoad || surface == LandCoverClass::kTertiaryRoad ||
         surface == LandCoverClass::kSecondaryRoad || surface == LandCoverClass::kPrimaryRoad;
}

struct Indexer {
  Surroundings all;
  std::vector<Box2> line_boxes, area_boxes;

  void add(const MappedLine& line) {
    all.lines.push_back(line);
    all.widest_half_m = std::max(all.widest_half_m, line.half_m);
    line_boxes.push_back(box_of_segment(line.a, line.b));
  }
  void add_ring(const Ring& ring, LineKind kind, ObjectId element, bool is_of_town = false) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      add({.a = ring[i],
           .b = ring[(i + 1) % ring.size()],
           .kind = kind,
           .is_town_house = is_of_town,
           .element = element});
  }
  void add_track(const map::Track& track) {
    const LandCoverGroup group = cover_group_of(track.surface);
    const bool is_path = group == LandCoverGroup::kPath, is_road = group == LandCoverGroup::kRoad;
    const LineKind kind = is_path ? LineKind::kPath : is_road ? LineKind::kStreet : LineKind::kRail;
    const int flow = flow_of(track);
    const double half_m = widest_half_m(track.section);
    for (std::size_t i = 0; i + 1 < track.axis.size(); ++i)
      add({.a = track.axis[i],
           .b = track.axis[i + 1],
           .kind = kind,
           .half_m = half_m,
           .is_through = is_through(track.surface),
           .heading = unit(track.axis[i + 1] - track.axis[i]) * static_cast<double>(flow),
           .element = track.id,
           .way = &track});
  }
  // guard rails stand on the road
  void add_barrier(const map::Barrier& barrier) {
    if (barrier.kind == map::BarrierKind::kGuardRail || barrier.kind == map::BarrierKind::kKerb) return;
    for (std::size_t i = 0; i + 1 < barrier.axis.size(); ++i)
      add({.a = barrier.axis[i],
           .b = barrier.axis[i + 1],
           .kind = LineKind::kWall,
           .half_m = barrier.width_m / 2,
           .element = barrier.id});
  }
  void add_area(const map::AreaFeature& area) {
    const LandUse land = land_use_of(area.surface);
    const bool is_square = area.surface == LandCoverClass::kSquare;
    if (land == LandUse::kWater || land == LandUse::kParking || is_square)
      for (const Ring* ring : rings_of(area.polygon))
        add_ring(*ring,
                 is_square                 ? LineKind::kSquare
                 : land == LandUse::kWater ? LineKind::kWater
                                           : LineKind::kCarPark,
                 area.id);
    if ((land == LandUse::kNone && !is_square) || area.polygon.outer.empty()) return;
    all.areas.push_back({&area, land, is_square});
    area_boxes.push_back(box_of(area.polygon.outer));
  }
};

// The distance along a ray to a line; nothing if they do not meet.
std::optional<double> distance_to(const SideRay& ray, const MappedLine& line, double most_m) {
  const auto shares = crossing_shares(ray.at, ray.at + ray.out * most_m, line.a, line.b);
  return shares ? std::optional(shares->first * most_m) : std::nullopt;
}

bool runs_along(const SideRay& ray, const MappedLine& line) {
  return std::abs(dot(unit(line.b - line.a), ray.along)) > kAlong;
}

// The facts of one sample of a side.
struct Seen {
  bool has_house = false, has_path = false, has_oncoming = false;
  double room_m = std::numeric_limits<double>::infinity();
};

void look_at(const MappedLine& line, const SideRay& ray, Vec2 heading, Seen& seen) {
  const double most_m = std::max(kHouses_m, ray.kerb_m + kBesideKerb_m);
  const auto away_m = distance_to(ray, line, most_m);
  if (!away_m) return;
  const double from_kerb_m = *away_m - ray.kerb_m - line.half_m;
  const auto limit = [&] { seen.room_m = std::min(seen.room_m, std::max(0.0, from_kerb_m)); };
  switch (line.kind) {
    case LineKind::kBuilding:
      seen.has_house |= *away_m <= kHouses_m;
      return limit();
    case LineKind::kPath:
      seen.has_path |= *away_m > ray.kerb_m / 2 && from_kerb_m <= kBesideKerb_m && runs_along(ray, line);
      return;
    case LineKind::kWall:
      if (runs_along(ray, line)) limit();
      return;
    case LineKind::kCarPark:
      return limit();
    case LineKind::kStreet:
      seen.has_oncoming |= *away_m > 0 && *away_m <= kOncoming_m && dot(line.heading, heading) < -kAlong;
      return;
    case LineKind::kWater:
    case LineKind::kSquare:
    case LineKind::kRail:
      return;
  }
}

// The rooms that samples leave, sums of what they see, and the land use of some.
struct Side {
  std::vector<double> rooms_m;
  std::size_t houses = 0, paths = 0, oncoming = 0, squares = 0;
  std::array<std::size_t, static_cast<std::size_t>(LandUse::kCount)> lands{};

  void add(const Seen& seen) {
    houses += seen.has_house, paths += seen.has_path, oncoming += seen.has_oncoming;
    rooms_m.push_back(seen.room_m);
  }
};

// The smallest area at a place, of squares or of land uses.
const MappedLand* area_at(const Surroundings& surroundings, Vec2 p, bool is_square) {
  const MappedLand* least = nullptr;
  for (const std::uint32_t i : boxes_about(surroundings.area_grid, p)) {
    const MappedLand& land = surroundings.areas[i];
    if (land.is_square != is_square || !contains(land.area->polygon, p)) continue;
    if (least == nullptr || land.area->area_m2 < least->area->area_m2) least = &land;
  }
  return least;
}

void look_at_land(const Surroundings& surroundings, const SideRay& ray, Side& side) {
  const MappedLand* land = area_at(surroundings, ray.at + ray.out * kLandUse_m, false);
  ++side.lands[static_cast<std::size_t>(land == nullptr ? LandUse::kNone : land->land)];
  side.squares += area_at(surroundings, ray.at + ray.out * (ray.kerb_m + kBehindKerb_m), true) != nullptr;
}

SideFacts facts_of(Side side) {
  SideFacts facts;
  if (side.rooms_m.empty()) return facts;
  const auto n = static_cast<double>(side.rooms_m.size());
  const std::size_t looked = (side.rooms_m.size() + kLandEvery - 1) / kLandEvery;
  const double squares = static_cast<double>(side.squares) / static_cast<double>(looked);
  const auto narrow = side.rooms_m.begin() + static_cast<std::ptrdiff_t>(kNarrowShare * n);
  std::ranges::nth_element(side.rooms_m, narrow);
  facts.houses = static_cast<double>(side.houses) / n;
  facts.path = std::min(1.0, static_cast<double>(side.paths) / n + squares);
  facts.oncoming = static_cast<double>(side.oncoming) / n;
  facts.room_m = *narrow;
  facts.land = static_cast<LandUse>(std::ranges::max_element(side.lands) - side.lands.begin());
  return facts;
}

// The way along a stretch, with what was seen on either side.
struct Walk {
  const Surroundings& surroundings;
  const map::Track& stretch;
  double flow = 0;
  Side left = {}, right = {};
  std::size_t samples = 0, samples_near_streets = 0;

  bool is_near_cross_street(const SideRay& ray, std::span<const std::uint32_t> near) const {
    return std::ranges::any_of(near, [&](std::uint32_t n) {
      const MappedLine& line = surroundings.lines[n];
      return line.is_through && line.element.osm != stretch.id.osm && !runs_along(ray, line) &&
             distance_to_segment(line.a, line.b, ray.at) < kCrossStreet_m;
    });
  }

  // Looks to one side from a sample, at the lines near it.
  void look(const SideRay& ray, std::span<const std::uint32_t> near, Side& side) const {
    Seen seen;
    for (const std::uint32_t n : near)
      if (const MappedLine& line = surroundings.lines[n]; line.element.osm != stretch.id.osm)
        look_at(line, ray, ray.along * flow, seen);
    if (side.rooms_m.size() % kLandEvery == 0) look_at_land(surroundings, ray, side);
    side.add(seen);
  }

  void go() {
    const double widest_m = std::max(kCrossStreet_m, farther_kerb_m(stretch.section) + kBesideKerb_m);
    for_each_side_ray(surroundings, stretch, widest_m, [&](const SideRay& ray, std::span<const std::uint32_t> near) {
      if (ray.is_left) ++samples, samples_near_streets += is_near_cross_street(ray, near);
      look(ray, near, ray.is_left ? left : right);
    });
  }
};

}  // namespace

bool is_town_house(const map::Footprint& footprint) {
  using enum map::BuildingClass;
  const auto storeys_at_least = [&](int storeys) {
    constexpr double kStorey_m = 3;
    return footprint.levels > 0 ? footprint.levels >= storeys : footprint.height_m >= storeys * kStorey_m;
  };
  switch (static_cast<map::BuildingClass>(footprint.building_class)) {
    case kOffice:
    case kShop:
    case kChurch:
    case kCivic:
    case kTower:
    case kCastle:
    case kHotel:
    case kSchool:
    case kHospital:
      return true;
    case kHouse:
      return footprint.has_shop || storeys_at_least(4);
    case kPlain:
    case kApartments:
      return footprint.has_shop || storeys_at_least(3);
    default:
      return false;
  }
}

Surroundings index_surroundings(const map::FeatureView& features) {
  return index_surroundings(features, features.tracks);
}

Surroundings index_surroundings(const map::FeatureView& features, std::span<const map::Track> tracks) {
  Indexer indexer;
  for (const map::Footprint& footprint : features.footprints)
    if (!footprint.is_part && !footprint.is_open && footprint.min_height_m == 0)
      for (const Ring* ring : rings_of(footprint.polygon))
        indexer.add_ring(*ring, LineKind::kBuilding, footprint.id, is_town_house(footprint));
  for (const map::Track& track : tracks)
    if (track.passage == map::Passage::kGround && !track.is_indoor) indexer.add_track(track);
  for (const map::Barrier& barrier : features.barriers) indexer.add_barrier(barrier);
  for (const map::AreaFeature& area : features.areas) indexer.add_area(area);
  indexer.all.line_grid = grid_of(indexer.line_boxes, kLineBucket_m);
  indexer.all.area_grid = grid_of(indexer.area_boxes, kLineBucket_m);
  return std::move(indexer.all);
}

LandUse land_use_along(const Surroundings& surroundings, const Polyline& line) {
  std::array<std::size_t, static_cast<std::size_t>(LandUse::kCount)> counts{};
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const int steps = std::max(1, static_cast<int>(distance(line[i], line[i + 1]) / kLandSample_m));
    for (int k = 0; k < steps; ++k) {
      const MappedLand* land = area_at(surroundings, line[i] + (line[i + 1] - line[i]) * ((k + 0.5) / steps), false);
      ++counts[static_cast<std::size_t>(land == nullptr ? LandUse::kNone : land->land)];
    }
  }
  return static_cast<LandUse>(std::ranges::max_element(counts) - counts.begin());
}

BothSides facts_beside(const Surroundings& surroundings, const map::Track& stretch) {
  Walk walk{surroundings, stretch, static_cast<double>(flow_of(stretch))};
  walk.go();
  BothSides sides{facts_of(std::move(walk.left)), facts_of(std::move(walk.right))};
  const auto samples = static_cast<double>(std::max<std::size_t>(walk.samples, 1));
  sides.left.near_cross_street = sides.right.near_cross_street =
      static_cast<double>(walk.samples_near_streets) / samples;
  sides.left.houses_across = sides.right.houses, sides.right.houses_across = sides.left.houses;
  const Room room = room_beside(surroundings, stretch);
  sides.left.room_m = std::min(sides.left.room_m, room.left_m);
  sides.right.room_m = std::min(sides.right.room_m, room.right_m);
  return sides;
}

}  // namespace citykiln::assume
