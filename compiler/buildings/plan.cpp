#include "compiler/buildings/plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>

#include "compiler/buildings/meshes/posts.h"
#include "compiler/buildings/planning/doors.h"
#include "compiler/buildings/planning/fronts.h"
#include "compiler/buildings/planning/party_walls.h"
#include "compiler/buildings/planning/plan_roof.h"
#include "compiler/buildings/planning/street_sides.h"
#include "compiler/buildings/planning/vertical_support.h"
#include "compiler/buildings/styles/building_materials.h"
#include "compiler/buildings/styles/style.h"
#include "compiler/contract/equal_span.h"
#include "compiler/geometry/polygons/centroid.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/buildings/building_classes.h"
#include "compiler/map/buildings/part_outlines.h"
#include "compiler/structures/plates.h"

namespace citykiln::buildings {
namespace {

// A low storey. Less wall above the highest ground is an error of the heightmap, not a building.
constexpr double kMinWallAboveGround_m = 2;

// The ground may dip between two height samples, and coarse levels of the ground lie a little lower.
constexpr double kFoundation_m = 3;
// The depth of walls below the top of a bridge's deck: less than the thickness of the deck.
constexpr double kOnPlate_m = 0.25;

// Spacing of height samples along walls: embankments beside roads are a few metres wide.
constexpr double kSampleSpacing_m = 4;

// Storey heights outside this range mean that building:levels is wrong.
constexpr double kMinStorey_m = 2.1, kMaxStorey_m = 7;

// The least width of a wall that begins at a storey of its own.
constexpr double kBuriedPiece_m = 4;

// The thickness of a roof without walls, and the least room below it.
constexpr double kRoofSlab_m = 0.25, kLeastRoomBelow_m = 1;

// A storey with no more than this share of its height below the ground has windows.
constexpr double kMaxBuriedShare = 0.3;

// The wall that has to remain above the opening for a way, and the least clearance with which one is made.
constexpr double kLintel_m = 0.25, kLeastOpening_m = 2;

// The largest difference between the ground and the floor of an assumed front.
constexpr double kFrontStepUp_m = 0.75;

// Spacing of height samples along ways through buildings.
constexpr double kWaySpacing_m = 1;

struct GroundRange {
  double lowest_m = std::numeric_limits<double>::infinity(), highest_m = -std::numeric_limits<double>::infinity();
  void grow(const GroundRange& other) {
    lowest_m = std::min(lowest_m, other.lowest_m), highest_m = std::max(highest_m, other.highest_m);
  }
};

GroundRange ground_along(Vec2 from, Vec2 to, const ground::GradedTerrain& ground) {
  GroundRange range;
  const double steps = std::max(1.0, std::ceil(distance(from, to) / kSampleSpacing_m));
  for (double i = 0; i <= steps; ++i) {
    const double z_m = wall_ground_m(ground, from + (to - from) * (i / steps));
    range.grow({z_m, z_m});
  }
  return range;
}

// One range per edge of the outer ring.
std::vector<GroundRange> ground_along_walls(const Polygon& polygon, const ground::GradedTerrain& ground) {
  std::vector<GroundRange> ranges;
  for (std::size_t i = 0; i < polygon.outer.size(); ++i)
    ranges.push_back(ground_along(polygon.outer[i], polygon.outer[(i + 1) % polygon.outer.size()], ground));
  return ranges;
}

GroundRange all_of(const std::vector<GroundRange>& ranges) {
  GroundRange all;
  for (const GroundRange& range : ranges) all.grow(range);
  return all;
}

// Indexes of the whole map that all buildings are planned from.
struct Site {
  const ground::GradedTerrain& ground;
  std::span<const map::Footprint> footprints;
  const std::vector<std::uint32_t> outlines;
  const std::vector<bool> have_height;
  const std::vector<std::vector<SharedWall>> shared_walls;
  const Streets streets;
  const MappedDoors doors;
  const std::vector<bool> supported;
  const PostObstacles post_obstacles;
  std::span<const map::Passageway> passageways;
  const std::vector<const structures::Plate*> plates;  // by footprint: the plate of a bridge that it stands on, or null
};

// The height of what a footprint stands on along each edge of its outer ring.
std::vector<GroundRange> feet_of_walls(std::size_t i, const Site& site) {
  const Polygon& polygon = site.footprints[i].polygon;
  if (site.plates[i] == nullptr) return ground_along_walls(polygon, site.ground);
  std::vector<GroundRange> ranges;
  for (std::size_t k = 0; k < polygon.outer.size(); ++k) {
    GroundRange& range = ranges.emplace_back();
    for (const Vec2 p : {polygon.outer[k], polygon.outer[(k + 1) % polygon.outer.size()]}) {
      const double z_m = structures::plate_height_m(*site.plates[i], p);
      range.grow({z_m, z_m});
    }
  }
  return ranges;
}

// The footprint whose ground the heights of footprint i are measured from: its outline, or itself.
std::size_t root_of(std::size_t i, std::span<const std::uint32_t> outlines) {
  return outlines[i] == map::kNoOutline ? i : outlines[i];
}

// The index of each part's outline.
std::vector<std::uint32_t> outline_indices(std::span<const map::Footprint> footprints) {
  std::map<ObjectId, std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < footprints.size(); ++i) numbers.emplace(footprints[i].id, i);
  std::vector<std::uint32_t> outlines;
  for (const map::Footprint& footprint : footprints)
    outlines.push_back(footprint.outline ? numbers.at(*footprint.outline) : map::kNoOutline);
  return outlines;
}

// By outline: whether height=* is stated for it or one of its parts. All parts are measured from one height, so that
// what rests on a part meets it.
std::vector<bool> have_tagged_height(std::span<const map::Footprint> footprints,
                                     std::span<const std::uint32_t> outlines) {
  std::vector<bool> have(footprints.size());
  for (std::size_t i = 0; i < footprints.size(); ++i)
    if (footprints[i].has_roof_in_height) have[root_of(i, outlines)] = true;
  return have;
}

// The mean height of the ground along the walls that face a street, weighted by length; where none does, the highest.
double entrance_m(const Polygon& polygon, const std::vector<GroundRange>& walls, const std::vector<bool>& sides) {
  double sum = 0, length_m = 0;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    if (!sides[i]) continue;
    const double wall_m = distance(polygon.outer[i], polygon.outer[(i + 1) % walls.size()]);
    sum += wall_m * (walls[i].lowest_m + walls[i].highest_m) / 2, length_m += wall_m;
  }
  return length_m > 0 ? sum / length_m : all_of(walls).highest_m;
}

// The height that a footprint's heights are measured from.
double base_m(std::size_t i, const Site& site) {
  const std::size_t root = root_of(i, site.outlines);
  const Polygon& whole = site.footprints[root].polygon;
  const std::vector<GroundRange> walls = feet_of_walls(root, site);
  if (site.have_height[root]) return all_of(walls).lowest_m;
  return entrance_m(whole, walls, street_sides(whole, site.streets));
}

double min_height_m(const map::Footprint& footprint, Report& report) {
  if (footprint.min_height_m <= 0) return 0;
  if (footprint.min_height_m < footprint.height_m) return footprint.min_height_m;
  report.add(Code::kMinHeightNotBelowHeight, footprint.id.osm, footprint.min_height_m - footprint.height_m);
  return 0;
}

bool are_steps(const map::Footprint& footprint) {
  return footprint.building_class == static_cast<std::uint8_t>(map::BuildingClass::kSteps);
}

double top_m(const map::Footprint& footprint, double base_m, double roof_m, const GroundRange& ground, Report& report) {
  const double top_m = snapped(base_m + footprint.height_m + (footprint.has_roof_in_height ? 0 : roof_m));
  // a tagged roof may leave less of a wall, even none
  const double wall_m = footprint.height_m - (footprint.has_roof_in_height ? roof_m : 0);
  const double least_m = snapped(ground.highest_m + std::min(kMinWallAboveGround_m, wall_m) + roof_m);
  if (top_m >= least_m || footprint.min_height_m > 0 || are_steps(footprint)) return top_m;
  report.add(Code::kHeightRaised, footprint.id.osm, least_m - top_m);
  return least_m;
}

// The longest of those edges that `is_candidate`, or nothing.
template <typename IsCandidate>
std::optional<std::size_t> longest_edge(const Ring& ring, IsCandidate is_candidate) {
  std::optional<std::size_t> longest;
  double longest_m = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const double length_m = distance(ring[i], ring[(i + 1) % ring.size()]);
    if (!is_candidate(i) || length_m <= longest_m) continue;
    longest = i, longest_m = length_m;
  }
  return longest;
}

// The outward normal of the longest wall that faces a street.
std::optional<Vec2> street_normal(const Ring& ring, const std::vector<bool>& sides) {
  const auto edge = longest_edge(ring, [&](std::size_t i) { return sides[i]; });
  if (!edge) return std::nullopt;
  return unit(left_of(ring[(*edge + 1) % ring.size()] - ring[*edge])) * -1;
}

double usual_storey_m(const map::Footprint& footprint) {
  if (footprint.storey_m > 0) return footprint.storey_m;
  return map::values_of(static_cast<map::BuildingClass>(footprint.building_class)).level_m;
}

std::uint8_t levels_of(const map::Footprint& footprint, double wall_m) {
  const double storey_m = usual_storey_m(footprint);
  const double tagged = std::floor(footprint.levels - footprint.min_height_m / storey_m + 0.5);
  const bool is_plausible = tagged >= 1 && wall_m >= tagged * kMinStorey_m && wall_m <= tagged * kMaxStorey_m;
  const double levels = footprint.levels > 0 && is_plausible ? tagged : std::floor(wall_m / storey_m + 0.5);
  return static_cast<std::uint8_t>(std::clamp(levels, 1.0, 250.0));
}

// The storeys below the floor that have a wall above the lowest ground.
// Walls lower than this have no storeys.
constexpr double kLeastStorey_m = 1;

// True for what stands on the ground with walls that count as storeys: roofs down to the ground and treads have none.
bool has_storeys(const Building& building) { return building.stands_on_ground && storey_m(building) >= kLeastStorey_m; }

std::uint8_t storeys_below(const Building& building, double lowest_m) {
  if (!has_storeys(building)) return 0;
  const double count = std::floor((building.floor_m - lowest_m) / storey_m(building) + kMaxBuriedShare);
  return static_cast<std::uint8_t>(std::clamp(count, 0.0, 250.0 - building.levels));
}

// Moves the floor down by so many storeys.
Building extended_below(Building building, std::uint8_t storeys) {
  building.floor_m = snapped(building.floor_m - storeys * storey_m(building));
  building.levels = static_cast<std::uint8_t>(building.levels + storeys);
  return building;
}

std::uint8_t buried_storeys(const Building& building, const GroundRange& ground) {
  if (!has_storeys(building)) return 0;
  const double storeys = (ground.highest_m - building.floor_m) / storey_m(building) - kMaxBuriedShare;
  return static_cast<std::uint8_t>(std::clamp(std::ceil(storeys), 0.0, static_cast<double>(building.levels)));
}

// The ground along pieces of an edge, each about kBuriedPiece_m long, from samples at their ends and middles.
std::vector<GroundRange> ground_along_pieces(Vec2 from, Vec2 to, const ground::GradedTerrain& ground) {
  const double count = std::max(1.0, std::floor(distance(from, to) / kBuriedPiece_m));
  std::vector<GroundRange> pieces;
  for (double i = 0; i < count; ++i)
    pieces.push_back(ground_along(from + (to - from) * (i / count), from + (to - from) * ((i + 1) / count), ground));
  return pieces;
}

// Sets the buried storeys of one edge: where the ground rises by storeys along it, in steps.
void bury_edge(std::uint32_t edge, const ground::GradedTerrain& ground, Building& building) {
  const Ring& ring = building.footprint.outer;
  const Vec2 from = ring[edge], to = ring[(edge + 1) % ring.size()];
  const std::vector<GroundRange> pieces = ground_along_pieces(from, to, ground);
  std::uint8_t last = building.facade_edges[edge].buried_storeys = buried_storeys(building, pieces.front());
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const std::uint8_t storeys = buried_storeys(building, pieces[i]);
    if (storeys == last) continue;
    const double share = static_cast<double>(i) / static_cast<double>(pieces.size());
    building.buried_from.push_back({edge, snapped(distance(from, to) * share), storeys});
    last = storeys;
  }
}

// An edge with a mapped door counts as facing a street. A building without either has its door in its longest edge.
std::vector<FacadeEdge> facade_edges_of(const Building& building, const std::vector<bool>& sides,
                                        const std::vector<std::uint16_t>& doors) {
  std::vector<FacadeEdge> edges;
  for (std::size_t i = 0; i < sides.size(); ++i) edges.push_back({sides[i] || doors[i] != 0, 0, doors[i]});
  if (std::ranges::none_of(edges, &FacadeEdge::faces_street)) {
    const auto longest = longest_edge(building.footprint.outer, [](std::size_t) { return true; });
    edges[longest.value_or(0)].faces_street = true;
  }
  return edges;
}

// Lifts a roof without walls off the ground, if there is room below it.
void open_below(Building& building, double ground_m) {
  const double bottom_m = snapped(eaves_m(building) - kRoofSlab_m);
  if (!building.stands_on_ground || bottom_m < ground_m + kLeastRoomBelow_m) return;
  building.bottom_m = building.floor_m = bottom_m;
  building.stands_on_ground = false;
}

void set_posts(std::size_t i, const Site& site, double lowest_m, Building& building) {
  building.post_foot_m = snapped(std::min(lowest_m, building.bottom_m) - kFoundation_m);
  building.posts = plan_posts(i, site.post_obstacles, building.bottom_m - building.post_foot_m);
  if (building.posts.empty()) building.post_foot_m = 0;
}

// The highest ground along a way inside a building.
double highest_along(const map::Passageway& passageway, const ground::GradedTerrain& ground) {
  double highest_m = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < passageway.axis.size(); ++i) {
    const Vec2 a = passageway.axis[i], b = passageway.axis[i + 1], left = left_of(unit(b - a));
    const double steps = std::max(1.0, std::ceil(distance(a, b) / kWaySpacing_m));
    for (double k = 0; k <= steps; ++k)
      for (const double side_m : {-passageway.right_m, 0.0, passageway.left_m})
        highest_m = std::max(highest_m, land_m(ground, a + (b - a) * (k / steps) + left * side_m));
  }
  return highest_m;
}

std::span<const map::Passageway> passageways_in(ObjectId building, std::span<const map::Passageway> all) {
  return equal_span(all, building, &map::Passageway::building);
}

// Walls of an assumed height are made high enough for the ways that lead through them, and an assumed roof lower.
void make_room(Building& building, const map::Footprint& footprint, std::span<const map::Passageway> passageways,
               const ground::GradedTerrain& ground, Report& report) {
  double wanted_m = eaves_m(building);
  for (const map::Passageway& passageway : passageways)
    wanted_m = std::max(wanted_m, snapped(highest_along(passageway, ground) + passageway.clear_m + kLintel_m));
  const double lacking_m = wanted_m - eaves_m(building);
  if (lacking_m <= 0) return;
  if (!footprint.has_roof_in_height && footprint.levels == 0) {
    report.add(Code::kHeightRaised, footprint.id.osm, lacking_m);
    building.top_m += lacking_m;
  } else if (!footprint.has_roof_shape) {
    building.roof_shape.height_m = std::max(0.0, building.roof_shape.height_m - lacking_m);
  }
}

// The openings of a building. A ceiling stays below the eaves.
std::vector<Passageway> openings_of(const Building& building, std::span<const map::Passageway> passageways,
                                    const ground::GradedTerrain& ground, Report& report) {
  std::vector<Passageway> openings;
  for (const map::Passageway& p : passageways) {
    const double ground_m = highest_along(p, ground), top_m = snapped(ground_m + p.clear_m);
    const double lowest_m = std::min(top_m, snapped(eaves_m(building) - kLintel_m));
    if (lowest_m < ground_m + p.least_m) report.add(Code::kPassageTooLow, p.way.osm, ground_m + p.least_m - lowest_m);
    if (lowest_m < ground_m + std::min(p.least_m, kLeastOpening_m)) continue;
    openings.push_back({.way = p.way,
                        .axis = p.axis,
                        .left_m = p.left_m,
                        .right_m = p.right_m,
                        .top_m = lowest_m,
                        .pillars_left_m = p.pillars_left_m,
                        .pillars_right_m = p.pillars_right_m});
  }
  return openings;
}

// A building, and how many of its storeys lie below the entrance.
struct Planned {
  Building building;
  std::uint8_t storeys_below = 0;
};

Planned plan_building(std::size_t i, const Site& site, Report& report) {
  const map::Footprint& footprint = site.footprints[i];
  const std::vector<GroundRange> walls = feet_of_walls(i, site);
  const GroundRange under = all_of(walls);
  const double from_m = base_m(i, site), lift_m = min_height_m(footprint, report);
  const std::vector<bool> sides = street_sides(footprint.polygon, site.streets);
  const roofs::RoofShape roof =
      plan_roof(footprint, {!site.shared_walls[i].empty(), street_normal(footprint.polygon.outer, sides)});
  const BuildingMaterials materials = building_materials(footprint, roof.form);
  Building building{.id = footprint.id,
                    .footprint = footprint.polygon,
                    .floor_m = snapped(from_m + lift_m),
                    .top_m = top_m(footprint, from_m, roof.height_m, under, report),
                    .stands_on_ground = lift_m == 0 && site.plates[i] == nullptr,
                    .wall = materials.wall,
                    .roof = materials.roof,
                    .wall_colour = footprint.wall_colour,
                    .roof_colour = footprint.roof_colour,
                    .roof_shape = roof,
                    .building_class = footprint.building_class,
                    .year = footprint.year,
                    .has_shop = footprint.has_shop,
                    .country = footprint.country,
                    .assumed = footprint.assumed};
  const double foundation_m = site.plates[i] != nullptr ? kOnPlate_m : kFoundation_m;
  building.bottom_m = lift_m > 0 ? building.floor_m : snapped(std::min(from_m, under.lowest_m) - foundation_m);
  building.roof_shape.height_m = std::min(roof.height_m, building.top_m - building.floor_m);
  const std::span<const map::Passageway> passageways = passageways_in(footprint.id, site.passageways);
  if (!footprint.is_open) make_room(building, footprint, passageways, site.ground, report);
  if (footprint.is_open) open_below(building, under.highest_m);
  const bool is_opened = building.stands_on_ground != (lift_m == 0) && site.plates[i] == nullptr;
  if (!building.stands_on_ground && (lift_m > 0 || is_opened) && (is_opened || !site.supported[i]))
    set_posts(i, site, under.lowest_m, building);
  if (building.stands_on_ground) building.passageways = openings_of(building, passageways, site.ground, report);
  building.levels = levels_of(footprint, eaves_m(building) - building.floor_m);
  const std::uint8_t below = storeys_below(building, under.lowest_m);
  building = extended_below(std::move(building), below);
  building.facade_edges = facade_edges_of(building, sides, mapped_doors_by_edge(footprint.polygon, site.doors));
  for (std::uint32_t edge = 0; edge < building.facade_edges.size(); ++edge) bury_edge(edge, site.ground, building);
  return {std::move(building), below};
}

// The part of a building above its entrance, by which the style is chosen: storeys below it do not turn a villa into a
// block.
Building above_entrance(const Planned& planned) {
  Building above = planned.building;
  const double below_m = planned.storeys_below * storey_m(above);
  above.floor_m += below_m;
  above.levels = static_cast<std::uint8_t>(above.levels - planned.storeys_below);
  return above;
}

// The height at which the walls begin at a place on an edge.
double wall_foot_m(const Building& building, std::uint32_t edge, double at_m) {
  std::uint8_t storeys = building.facade_edges[edge].buried_storeys;
  for (const BuriedFrom& place : building.buried_from)
    if (place.edge == edge && place.from_m <= at_m) storeys = place.storeys;
  return building.floor_m + storeys * storey_m(building);
}

// True if the ground in the middle of a front is no more than a step above or below the foot of its wall.
bool is_level_with_ground(const Front& front, const Building& building, const ground::GradedTerrain& ground) {
  const Ring& ring = building.footprint.outer;
  const Vec2 from = ring[front.edge], along = unit(ring[(front.edge + 1) % ring.size()] - from);
  const double at_m = (front.from_m + front.to_m) / 2;
  return std::abs(land_m(ground, from + along * at_m) - wall_foot_m(building, front.edge, at_m)) <= kFrontStepUp_m;
}

// Gives a building its fronts. Assumed ones are left out where the ground lies too high or too low.
void set_fronts(std::vector<Front> fronts, const ground::GradedTerrain& ground, Building& building) {
  if (!building.stands_on_ground) return;
  std::erase_if(fronts,
                [&](const Front& front) { return front.is_assumed && !is_level_with_ground(front, building, ground); });
  for (const Front& front : fronts) building.facade_edges[front.edge].faces_street = true;
  building.fronts = std::move(fronts);
  if (std::ranges::none_of(building.fronts, &Front::is_assumed))
    building.assumed = static_cast<Assumptions>(building.assumed & ~bit_of(Assumption::kFronts));
}

// Sets the style, and the materials that depend on it.
void set_style(const map::Footprint& footprint, Planned& planned, Report& report) {
  if (!footprint.style_name.empty() && !style_named(footprint.style_name))
    report.add_tag(Code::kBadTagValue, footprint.id.osm, "citykiln:style", footprint.style_name);
  Building& building = planned.building;
  building.style = style_of(footprint, above_entrance(planned));
  const BuildingMaterials materials = regional_materials(footprint, building.roof_shape.form, building.style);
  building.wall = materials.wall;
  building.roof = materials.roof;
}

// Adds a party wall where it does not overlap the last one. The higher of two along one stretch counts.
void add_party_wall(std::vector<PartyWall>& walls, PartyWall wall) {
  if (!walls.empty() && walls.back().edge == wall.edge && wall.from_m < walls.back().to_m) {
    PartyWall& last = walls.back();
    if (wall.to_m <= last.to_m) {
      if (wall.from_m == last.from_m && wall.to_m == last.to_m && wall.top_m > last.top_m) last = wall;
      return;
    }
    wall.from_m = last.to_m;
  }
  walls.push_back(wall);
}

// @param planned  By footprint; nothing for footprints that do not become buildings.
std::vector<PartyWall> party_walls_of(std::size_t i, const Site& site,
                                      const std::vector<std::optional<Planned>>& planned) {
  const Building& building = planned[i]->building;
  std::vector<PartyWall> walls;
  for (const SharedWall& wall : site.shared_walls[i]) {
    if (!planned[wall.neighbour]) continue;
    const Building& other = planned[wall.neighbour]->building;
    if (other.bottom_m > building.floor_m || eaves_m(other) <= building.floor_m) continue;
    add_party_wall(walls, {.edge = wall.edge,
                           .from_m = wall.from_m,
                           .to_m = wall.to_m,
                           .top_m = eaves_m(other),
                           .is_hidden = wall.is_coplanar,
                           .has_windows_above = site.footprints[i].is_part && site.footprints[wall.neighbour].is_part});
  }
  return walls;
}

void diagnose_unsupported(std::span<const map::Footprint> footprints, const std::vector<bool>& supported,
                          Report& report) {
  for (std::size_t i = 0; i < footprints.size(); ++i)
    if (!supported[i] && !footprints[i].is_open)
      report.add(Code::kUnsupportedBuilding, footprints[i].id.osm, footprints[i].min_height_m);
}

// The plate that a footprint stands on: most of its corners lie on it, and no layer says that it is below.
const structures::Plate* plate_under(const map::Footprint& footprint, std::span<const structures::BoxedPlate> plates) {
  constexpr double kLeastShare = 0.75;
  const Ring& ring = footprint.polygon.outer;
  for (const structures::BoxedPlate& boxed : plates) {
    if (footprint.has_tagged_layer && footprint.layer < boxed.layer) continue;
    const auto on = std::ranges::count_if(ring, [&](Vec2 p) { return structures::is_on_plate(boxed, p); });
    if (on >= kLeastShare * static_cast<double>(ring.size())) return boxed.plate;
  }
  return nullptr;
}

std::vector<const structures::Plate*> plates_under(std::span<const map::Footprint> footprints,
                                                   std::span<const structures::Span> bridges) {
  const std::vector<structures::BoxedPlate> plates = structures::boxed_plates(bridges);
  std::vector<const structures::Plate*> under;
  for (const map::Footprint& footprint : footprints) under.push_back(plate_under(footprint, plates));
  return under;
}

Site site_of(const map::FeatureView& features, std::span<const map::Passageway> passageways,
             std::span<const structures::Span> bridges, const ground::GradedTerrain& ground, Report& report) {
  std::vector<std::vector<SharedWall>> shared = shared_walls(features.footprints);
  std::vector<bool> supported = find_supported(features.footprints, shared);
  diagnose_unsupported(features.footprints, supported, report);
  std::vector<std::uint32_t> outlines = outline_indices(features.footprints);
  std::vector<bool> have_height = have_tagged_height(features.footprints, outlines);
  return {.ground = ground,
          .footprints = features.footprints,
          .outlines = std::move(outlines),
          .have_height = std::move(have_height),
          .shared_walls = std::move(shared),
          .streets = index_streets(features.tracks),
          .doors = index_doors(features.points),
          .supported = std::move(supported),
          .post_obstacles = index_post_obstacles(features.tracks, features.footprints),
          .passageways = passageways,
          .plates = plates_under(features.footprints, bridges)};
}

// A building belongs to the extent by its centroid, and all parts of an outline with it.
bool is_in_region(std::size_t i, const Site& site, const Box2& extent) {
  return extent.contains(centroid(site.footprints[root_of(i, site.outlines)].polygon));
}

}  // namespace

std::vector<Building> plan(const map::FeatureView& features, const ground::GradedTerrain& ground, Report& report,
                           std::span<const map::Passageway> passageways, std::span<const structures::Span> bridges) {
  const Site site = site_of(features, passageways, bridges, ground, report);
  std::vector<std::optional<Planned>> planned(site.footprints.size());
  Account account;
  for (std::size_t i = 0; i < planned.size(); ++i) {
    const map::Footprint& footprint = site.footprints[i];
    const bool counts = report.counts(footprint.id.osm);
    account.in += counts;
    if (footprint.polygon.outer.size() < 3) {
      report.drop(account, Code::kDegenerateRing, footprint.id.osm);
    } else if (!is_in_region(i, site, features.extent)) {
      report.drop(account, Code::kOutsideBounds, footprint.id.osm);
    } else if (footprint.has_parts) {
      account.merged += counts;
      report.add(Code::kOutlineReplacedByParts, footprint.id.osm);
    } else {
      account.out += counts;
      planned[i] = plan_building(i, site, report);
    }
  }
  report.account("buildings", "footprint") = account;
  std::vector<std::vector<Front>> fronts = plan_fronts(
      features.fronts, {site.footprints, site.shared_walls, site.streets, site.doors, site.passageways}, report);
  // these depend on the neighbours' heights, styles on party walls
  for (std::size_t i = 0; i < planned.size(); ++i)
    if (planned[i]) planned[i]->building.party_walls = party_walls_of(i, site, planned);
  std::vector<Building> buildings;
  for (std::size_t i = 0; i < planned.size(); ++i) {
    if (!planned[i]) continue;
    set_style(site.footprints[i], *planned[i], report);
    set_fronts(std::move(fronts[i]), site.ground, planned[i]->building);
    buildings.push_back(std::move(planned[i]->building));
  }
  std::ranges::sort(buildings, {}, &Building::id);
  return buildings;
}

}  // namespace citykiln::buildings
