#include "compiler/buildings/plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "compiler/buildings/building_materials.h"
#include "compiler/buildings/doors.h"
#include "compiler/buildings/outline_index.h"
#include "compiler/buildings/party_walls.h"
#include "compiler/buildings/plan_roof.h"
#include "compiler/buildings/street_sides.h"
#include "compiler/buildings/style.h"
#include "compiler/buildings/vertical_support.h"
#include "compiler/geometry/snap.h"
#include "compiler/geometry/triangulate.h"
#include "compiler/map/building_classes.h"

namespace citykiln::buildings {
namespace {

// A building shows at least this much wall over its highest corner: a low storey. Less is a slip of the heightmap, not
// a building.
constexpr double kLeastRise_m = 2;

// How deep walls reach under the lowest corner: the ground may dip between two corners, and coarse levels lie a little
// lower.
constexpr double kFoundation_m = 3;

// Along the walls the ground is looked at this often: banks beside roads are a few metres wide.
constexpr double kWallStep_m = 4;

// Storeys lower or higher than these were not counted well.
constexpr double kLowStorey_m = 2.1, kHighStorey_m = 7;

// A storey with no more than this share of it in the ground keeps its windows there.
constexpr double kBuriedShare = 0.3;

struct GroundRange {
  double lowest_m = std::numeric_limits<double>::infinity(), highest_m = -std::numeric_limits<double>::infinity();
  void grow(double low_m, double high_m) {
    lowest_m = std::min(lowest_m, low_m), highest_m = std::max(highest_m, high_m);
  }
};

GroundRange ground_along(Vec2 from, Vec2 to, const ground::GradedTerrain& ground) {
  GroundRange range;
  const double steps = std::max(1.0, std::ceil(distance(from, to) / kWallStep_m));
  for (double i = 0; i <= steps; ++i) {
    const double z = land_m(ground, from + (to - from) * (i / steps));
    range.grow(z, z);
  }
  return range;
}

// Of each wall of the outer ring.
std::vector<GroundRange> ground_along_walls(const Polygon& polygon, const ground::GradedTerrain& ground) {
  std::vector<GroundRange> ranges;
  for (std::size_t i = 0; i < polygon.outer.size(); ++i)
    ranges.push_back(ground_along(polygon.outer[i], polygon.outer[(i + 1) % polygon.outer.size()], ground));
  return ranges;
}

GroundRange all_of(const std::vector<GroundRange>& ranges) {
  GroundRange all;
  for (const GroundRange& range : ranges) all.grow(range.lowest_m, range.highest_m);
  return all;
}

// A point well inside: the middle of the largest triangle.
Vec2 inner_point(const Polygon& polygon) {
  const PlaneTriangles t = triangulate(polygon);
  double largest = 0;
  Vec2 middle = polygon.outer.front();
  for (const auto& [ia, ib, ic] : t.triangles) {
    const Vec2 a = t.points[ia], b = t.points[ib], c = t.points[ic];
    if (cross(b - a, c - a) <= largest) continue;
    largest = cross(b - a, c - a);
    middle = (a + b + c) * (1 / 3.0);
  }
  return middle;
}

// The height that a footprint's heights count from.
double base_of(const map::Footprint& footprint, const GroundRange& under, const OutlineIndex& outlines,
               const ground::GradedTerrain& ground) {
  if (!footprint.is_part) return under.lowest_m;
  const map::Footprint* outline = outline_at(outlines, inner_point(footprint.polygon));
  return outline == nullptr ? under.lowest_m : all_of(ground_along_walls(outline->polygon, ground)).lowest_m;
}

// What all buildings are planned from.
struct Site {
  const ground::GradedTerrain& ground;
  const OutlineIndex outlines;
  const Streets streets;
  const MappedDoors doors;
  const std::vector<std::vector<SharedWall>> shared;
};

double lift_of(const map::Footprint& footprint, Report& report) {
  if (footprint.min_height_m <= 0) return 0;
  if (footprint.min_height_m < footprint.height_m) return footprint.min_height_m;
  report.add(Code::kMinHeightNotBelowHeight, footprint.id.osm, footprint.min_height_m - footprint.height_m);
  return 0;
}

// Where the building ends at the top: raised out of a slope that would bury its walls.
double top_of(const map::Footprint& footprint, double base_m, double roof_m, const GroundRange& ground,
              Report& report) {
  const double over_m = footprint.has_roof_in_height ? 0 : roof_m;
  const double top_m = snapped(base_m + footprint.height_m + over_m);
  const double least_m = snapped(ground.highest_m + kLeastRise_m + roof_m);
  if (top_m >= least_m || footprint.min_height_m > 0) return top_m;
  report.add(Code::kHeightRaised, footprint.id.osm, least_m - top_m);
  return least_m;
}

// Outward from the longest wall at a street.
std::optional<Vec2> street_of(const map::Footprint& footprint, const std::vector<bool>& sides) {
  std::optional<Vec2> street;
  double longest_m = 0;
  const Ring& ring = footprint.polygon.outer;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 along = ring[(i + 1) % ring.size()] - ring[i];
    if (!sides[i] || length(along) <= longest_m) continue;
    longest_m = length(along);
    street = unit(left_of(along)) * -1;
  }
  return street;
}

std::uint8_t levels_of(const map::Footprint& footprint, double wall_m) {
  const double storey_m = map::values_of(static_cast<map::BuildingClass>(footprint.building_class)).level_m;
  const double lifted = footprint.min_height_m / storey_m;
  const double told = std::floor(footprint.levels - lifted + 0.5);
  const bool is_likely = told >= 1 && wall_m >= told * kLowStorey_m && wall_m <= told * kHighStorey_m;
  const double levels = footprint.levels > 0 && is_likely ? told : std::floor(wall_m / storey_m + 0.5);
  return static_cast<std::uint8_t>(std::clamp(levels, 1.0, 250.0));
}

std::uint8_t buried_storeys(const Building& building, const GroundRange& ground) {
  const double storeys = (ground.highest_m - building.floor_m) / storey_m(building) - kBuriedShare;
  return static_cast<std::uint8_t>(std::clamp(std::ceil(storeys), 0.0, static_cast<double>(building.levels)));
}

std::size_t longest_edge(const Ring& ring) {
  std::size_t longest = 0;
  const auto length_of = [&](std::size_t i) { return distance(ring[i], ring[(i + 1) % ring.size()]); };
  for (std::size_t i = 1; i < ring.size(); ++i)
    if (length_of(i) > length_of(longest)) longest = i;
  return longest;
}

// Doors are told of, or lie towards streets. A building without either has its door in its longest wall.
std::vector<FacadeEdge> fronts_of(const Building& building, std::vector<bool> sides,
                                  const std::vector<std::uint16_t>& doors, const std::vector<GroundRange>& ground) {
  for (std::size_t i = 0; i < sides.size(); ++i) sides[i] = sides[i] || doors[i] != 0;
  if (std::find(sides.begin(), sides.end(), true) == sides.end()) sides[longest_edge(building.footprint.outer)] = true;
  std::vector<FacadeEdge> fronts;
  for (std::size_t i = 0; i < sides.size(); ++i)
    fronts.push_back(
        {sides[i], building.stands_on_ground ? buried_storeys(building, ground[i]) : std::uint8_t{0}, doors[i]});
  return fronts;
}

Building build(const map::Footprint& footprint, const Site& site, const std::vector<SharedWall>& shared,
               Report& report) {
  const std::vector<GroundRange> walls = ground_along_walls(footprint.polygon, site.ground);
  const GroundRange under = all_of(walls);
  const double base_m = base_of(footprint, under, site.outlines, site.ground), lift_m = lift_of(footprint, report);
  const std::vector<bool> sides = street_sides(footprint.polygon, site.streets);
  const roofs::RoofShape roof = plan_roof(footprint, {!shared.empty(), street_of(footprint, sides)});
  const BuildingMaterials dress = building_materials(footprint, roof.form);
  Building building{footprint.id,          footprint.polygon,     0,   0, 0, lift_m == 0, dress.wall, dress.roof,
                    footprint.wall_colour, footprint.roof_colour, roof};
  building.top_m = top_of(footprint, base_m, building.roof_shape.height_m, under, report);
  building.floor_m = snapped(base_m + lift_m);
  building.bottom_m = lift_m > 0 ? building.floor_m : snapped(std::min(base_m, under.lowest_m) - kFoundation_m);
  building.roof_shape.height_m = std::min(building.roof_shape.height_m, building.top_m - building.floor_m);
  building.building_class = footprint.building_class;
  building.levels = levels_of(footprint, eaves_m(building) - building.floor_m);
  building.year = footprint.year;
  building.has_shop = footprint.has_shop;
  building.fronts = fronts_of(building, sides, mapped_doors_by_edge(footprint.polygon, site.doors), walls);
  return building;
}

// Of neighbours along one stretch the one that hides most; they do not overlap.
void add_party_wall(std::vector<PartyWall>& walls, PartyWall wall) {
  if (!walls.empty() && walls.back().edge == wall.edge && wall.from_m < walls.back().to_m) {
    if (wall.to_m <= walls.back().to_m) {
      if (wall.from_m == walls.back().from_m && wall.to_m == walls.back().to_m && wall.top_m > walls.back().top_m)
        walls.back() = wall;
      return;
    }
    wall.from_m = walls.back().to_m;
  }
  walls.push_back(wall);
}

// @param built  By the footprint's number; nothing of what was not built.
std::vector<PartyWall> party_walls_of(const map::Footprint& footprint, const Building& building,
                                      const std::vector<SharedWall>& shared, const std::vector<map::Footprint>& all,
                                      const std::vector<std::optional<Building>>& built) {
  std::vector<PartyWall> walls;
  for (const SharedWall& wall : shared) {
    const std::optional<Building>& other = built[wall.neighbour];
    if (!other || other->bottom_m > building.floor_m || eaves_m(*other) <= building.floor_m) continue;
    const bool is_one_building = footprint.is_part && all[wall.neighbour].is_part;
    add_party_wall(walls, {wall.edge, wall.from_m, wall.to_m, eaves_m(*other), wall.is_coplanar, is_one_building});
  }
  return walls;
}

// Walls of what nothing holds up go down to the ground.
std::vector<map::Footprint> extended_to_ground(std::vector<map::Footprint> footprints,
                                               std::span<const map::Track> tracks, Report& report) {
  const std::vector<bool> held = find_supported(footprints, tracks);
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    if (held[i]) continue;
    report.add(Code::kUnsupportedBuilding, footprints[i].id.osm, footprints[i].min_height_m);
    footprints[i].min_height_m = 0;
  }
  return footprints;
}

}  // namespace

std::vector<Building> plan(const map::Features& features, const ground::GradedTerrain& ground, Report& report) {
  const std::vector<map::Footprint> footprints = extended_to_ground(features.footprints, features.tracks, report);
  const Site site{ground, index_outlines(footprints), index_streets(features.tracks), index_doors(features.points),
                  shared_walls(footprints)};
  std::vector<std::optional<Building>> built(footprints.size());
  Account account;
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    ++account.in;
    if (footprints[i].polygon.outer.size() < 3) {
      report.drop(account, Code::kDegenerateRing, footprints[i].id.osm);
    } else if (footprints[i].has_parts) {
      ++account.merged;
      report.add(Code::kOutlineReplacedByParts, footprints[i].id.osm);
    } else {
      ++account.out;
      built[i] = build(footprints[i], site, site.shared[i], report);
    }
  }
  report.account("buildings", "footprint") = account;
  for (std::size_t i = 0; i < footprints.size(); ++i)
    if (built[i]) built[i]->party_walls = party_walls_of(footprints[i], *built[i], site.shared[i], footprints, built);
  std::vector<Building> buildings;
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    if (!built[i]) continue;
    built[i]->style = style_of(footprints[i], *built[i]);
    buildings.push_back(std::move(*built[i]));
  }
  std::sort(buildings.begin(), buildings.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  return buildings;
}

}  // namespace citykiln::buildings
