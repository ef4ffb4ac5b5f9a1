#include "compiler/assume/fronts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <vector>

#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/buildings/building_classes.h"

namespace citykiln::assume {
namespace {

using map::LandCoverClass;

constexpr double kFrontBucket_m = 64;
// Shorter walls have no room for a front and a door.
constexpr double kLeastWall_m = 4;
// Assumed points lie this far behind their wall.
constexpr double kBehindWall_m = 0.5;
// Wider carriageways count as this wide.
constexpr double kWidestStreet_m = 24;

struct ShareRow {
  map::CountryGroup group;
  std::array<double, 5> shares;  // by class, as below
};
constexpr ShareRow kShares[] = {
#define FRONT_SHARE(group, ...) {map::CountryGroup::group, {__VA_ARGS__}},
#include "compiler/assume/fronts.inc"
#undef FRONT_SHARE
};
constexpr std::array<double, 5> kSharesElsewhere =
#define FRONT_SHARE_ELSEWHERE(...) \
  { __VA_ARGS__ }
#include "compiler/assume/fronts.inc"
#undef FRONT_SHARE_ELSEWHERE
    ;
constexpr LandCoverClass kClasses[] = {LandCoverClass::kPrimaryRoad, LandCoverClass::kSecondaryRoad,
                                       LandCoverClass::kTertiaryRoad, LandCoverClass::kResidentialRoad,
                                       LandCoverClass::kPedestrianStreet};

struct MixRow {
  map::FrontKind kind;
  std::uint32_t weight;
};
constexpr MixRow kMix[] = {
#define FRONT_MIX(kind, weight) {map::FrontKind::kind, weight},
#include "compiler/assume/fronts.inc"
#undef FRONT_MIX
};

// The share of walls with fronts along streets of a class.
double share_of(map::CountryGroup group, LandCoverClass street) {
  const auto row = std::ranges::find(kShares, group, &ShareRow::group);
  const auto at = std::ranges::find(kClasses, street) - std::begin(kClasses);
  return (row == std::end(kShares) ? kSharesElsewhere : row->shares)[static_cast<std::size_t>(at)];
}

map::FrontKind kind_of(std::uint32_t draw) {
  for (const MixRow& row : kMix) {
    if (draw < row.weight) return row.kind;
    draw -= row.weight;
  }
  return map::FrontKind::kShop;
}

std::uint32_t whole_mix() {
  std::uint32_t sum = 0;
  for (const MixRow& row : kMix) sum += row.weight;
  return sum;
}

bool is_main_street(const map::Track& track) {
  return track.passage == map::Passage::kGround && !track.is_rail && !track.is_link &&
         std::ranges::find(kClasses, track.surface) != std::end(kClasses);
}

// A line with the index of its street or footprint.
struct FrontSegment {
  Vec2 from, to;
  std::uint32_t owner;
  double reach_m;  // half the width of a street
};

struct FrontSegments {
  std::vector<FrontSegment> all;
  BoxGrid grid;
};

void index(FrontSegments& segments, double reach_m) {
  std::vector<Box2> boxes;
  for (const FrontSegment& s : segments.all) boxes.push_back(box_of_segment(s.from, s.to).widened(reach_m));
  segments.grid = grid_of(boxes, kFrontBucket_m);
}

FrontSegments main_streets(std::span<const map::Track> tracks) {
  FrontSegments streets;
  for (std::uint32_t t = 0; t < tracks.size(); ++t) {
    const map::Track& track = tracks[t];
    if (!is_main_street(track)) continue;
    const double half_m = std::min(kWidestStreet_m, map::carriageway_width_m(track.section)) / 2;
    for (std::size_t i = 0; i + 1 < track.axis.size(); ++i)
      streets.all.push_back({track.axis[i], track.axis[i + 1], t, half_m});
  }
  index(streets, kWidestStreet_m / 2 + kFrontKerb_m);
  return streets;
}

FrontSegments walls_of(std::span<const map::Footprint> footprints) {
  FrontSegments walls;
  for (std::uint32_t f = 0; f < footprints.size(); ++f) {
    const Ring& ring = footprints[f].polygon.outer;
    if (footprints[f].has_parts || ring.size() < 3) continue;
    for (std::size_t i = 0; i < ring.size(); ++i) walls.all.push_back({ring[i], ring[(i + 1) % ring.size()], f, 0});
  }
  index(walls, 1);
  return walls;
}

// True if the wall of another footprint runs along a place on a wall, within the distance at which walls touch.
bool is_against_neighbour(std::uint32_t footprint, Vec2 place, Vec2 along, const FrontSegments& walls) {
  constexpr double kTouching_m = 0.06, kOpposite = -0.99;
  return std::ranges::any_of(boxes_about(walls.grid, place), [&](std::uint32_t i) {
    const FrontSegment& wall = walls.all[i];
    return wall.owner != footprint && dot(unit(wall.to - wall.from), along) < kOpposite &&
           distance_to_segment(wall.from, wall.to, place) <= kTouching_m;
  });
}

// The class of the nearest main street that a wall faces, if its kerb is near.
std::optional<LandCoverClass> street_before(Vec2 middle, Vec2 outward, const FrontSegments& streets,
                                            std::span<const map::Track> tracks) {
  constexpr double kCos30 = 0.866;
  std::optional<std::tuple<double, LandCoverClass>> nearest;
  for (const std::uint32_t i : boxes_about(streets.grid, middle)) {
    const FrontSegment& street = streets.all[i];
    const Vec2 way = nearest_point(street.from, street.to, middle) - middle;
    const double away_m = length(way), kerb_m = away_m - street.reach_m;
    if (kerb_m > kFrontKerb_m || dot(way, outward) < kCos30 * away_m) continue;
    const std::tuple candidate{kerb_m, tracks[street.owner].surface};
    if (!nearest || candidate < *nearest) nearest = candidate;
  }
  return nearest ? std::optional(std::get<1>(*nearest)) : std::nullopt;
}

// The places of mapped shops, as points and as corners of outlines.
struct MappedShops {
  std::vector<Vec2> at;
  BoxGrid grid;
};

MappedShops mapped_shops(const map::FeatureView& features) {
  MappedShops shops;
  for (const map::PointFeature& point : features.points)
    if (point.kind == map::PointKind::kShop || point.front) shops.at.push_back(point.at);
  for (const map::Footprint& footprint : features.footprints)
    if (footprint.has_shop)
      shops.at.insert(shops.at.end(), footprint.polygon.outer.begin(), footprint.polygon.outer.end());
  std::vector<Box2> boxes;
  for (const Vec2 p : shops.at) boxes.push_back(Box2{p, p});
  shops.grid = grid_of(boxes, kFrontBucket_m);
  return shops;
}

bool is_near_shop(Vec2 place, const MappedShops& shops) {
  if (shops.at.empty()) return false;
  return std::ranges::any_of(boxes_about(shops.grid, Box2{place, place}.widened(kFrontSearch_m)),
                             [&](std::uint32_t i) { return distance(shops.at[i], place) <= kFrontSearch_m; });
}

// True for houses of several storeys that may have shops below.
bool is_house_of_centre(const map::Footprint& footprint) {
  using map::BuildingClass;
  const auto own = static_cast<BuildingClass>(footprint.building_class);
  const bool is_house = own == BuildingClass::kPlain || own == BuildingClass::kApartments ||
                        own == BuildingClass::kShop || own == BuildingClass::kHotel || own == BuildingClass::kOffice;
  const bool is_high = footprint.levels > 0 ? footprint.levels >= kFrontStoreys : footprint.height_m >= kFrontHeight_m;
  return is_house && is_high && !footprint.has_parts && !footprint.is_open && footprint.min_height_m <= 0 &&
         footprint.polygon.outer.size() >= 3;
}

struct FrontAssumer {
  const map::FeatureView& features;
  std::uint64_t seed;
  FrontSegments streets = main_streets(features.tracks);
  FrontSegments walls = walls_of(features.footprints);
  MappedShops shops = mapped_shops(features);
  std::vector<map::FrontPoint> fronts{};

  bool is_attached(std::uint32_t f) const {
    const Ring& ring = features.footprints[f].polygon.outer;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 from = ring[i], to = ring[(i + 1) % ring.size()];
      for (const double share : {0.25, 0.5, 0.75})
        if (from != to && is_against_neighbour(f, from + (to - from) * share, unit(to - from), walls)) return true;
    }
    return false;
  }

  // Adds the fronts of one wall.
  void add_wall(std::uint32_t f, std::uint32_t edge, const RandomSequence& draw) {
    const map::Footprint& footprint = features.footprints[f];
    const Ring& ring = footprint.polygon.outer;
    const Vec2 from = ring[edge], along = ring[(edge + 1) % ring.size()] - from;
    const auto count = static_cast<std::uint32_t>(std::max(1.0, std::floor(length(along) / kWallPerFront_m + 0.5)));
    for (std::uint32_t i = 0; i < count; ++i) {
      const Vec2 at = from + along * ((i + 0.5) / count) + left_of(unit(along)) * kBehindWall_m;
      const map::FrontKind kind = kind_of(draw.below(whole_mix(), 64 * (edge + 1) + i % 64));
      fronts.push_back({footprint.id, snapped(at), {kind, {}}, true});
    }
  }

  // Returns true if the footprint has got a front.
  bool add_footprint(std::uint32_t f) {
    const map::Footprint& footprint = features.footprints[f];
    const Ring& ring = footprint.polygon.outer;
    if (!is_house_of_centre(footprint) || streets.all.empty()) return false;
    const RandomSequence draw(seed, stable_id(footprint.id), "assumed front");
    const std::size_t before = fronts.size();
    std::optional<bool> attached;
    for (std::uint32_t edge = 0; edge < ring.size(); ++edge) {
      const Vec2 from = ring[edge], along = ring[(edge + 1) % ring.size()] - from, middle = from + along * 0.5;
      if (length(along) < kLeastWall_m) continue;
      const auto street = street_before(middle, unit(left_of(along)) * -1, streets, features.tracks);
      if (!street || draw.unit(64 * (edge + 1) - 1) >= share_of(footprint.country, *street)) continue;
      if (!attached) attached = is_attached(f);
      if (!*attached || is_against_neighbour(f, middle, unit(along), walls) || is_near_shop(middle, shops)) continue;
      add_wall(f, edge, draw);
    }
    return fronts.size() > before;
  }
};

}  // namespace

AssumedFronts assume_fronts(const map::FeatureView& features, std::uint64_t seed, Report& report) {
  FrontAssumer assumer{features, seed};
  AssumedFronts made;
  for (const map::PointFeature& point : features.points)
    if (point.front) assumer.fronts.push_back({point.id, point.at, *point.front, false});
  for (std::uint32_t f = 0; f < features.footprints.size(); ++f) {
    if (!assumer.add_footprint(f)) continue;
    made.footprints.push_back(f);
    report.count_assumed(Assumption::kFronts, features.footprints[f].id.osm);
  }
  made.fronts = std::move(assumer.fronts);
  std::ranges::sort(made.fronts, {}, [](const map::FrontPoint& p) { return std::tuple(p.id, p.at); });
  return made;
}

}  // namespace citykiln::assume
