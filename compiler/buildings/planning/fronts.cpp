#include "compiler/buildings/planning/fronts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "compiler/contract/equal_span.h"
#include "compiler/geometry/segment.h"
#include "compiler/map/buildings/building_classes.h"

namespace citykiln::buildings {
namespace {

constexpr double kFrontBucket_m = 64;
// Smaller buildings have no windows either (style.cpp).
constexpr double kLeastArea_m2 = 12;

int steps_of(double length_m) { return static_cast<int>(std::floor(length_m / kFrontStep_m + 1e-9)); }

// A stretch of wall where fronts may be.
struct FrontWall {
  std::uint32_t edge = 0;
  LinePart stretch;
  bool faces_street = false;
  std::vector<const map::FrontPoint*> points{};  // that belong to it
  double length_m() const { return stretch.to_m - stretch.from_m; }
};

// The walls of a footprint.
struct FrontWalls {
  std::vector<FrontWall> walls;
  bool has_mapped_doors = false;
};

FrontWalls front_walls_of(std::size_t footprint, const FrontSite& site) {
  const Polygon& polygon = site.footprints[footprint].polygon;
  const std::vector<std::uint16_t> doors = mapped_doors_by_edge(polygon, site.doors);
  const std::vector<bool> sides = street_sides(polygon, site.streets);
  FrontWalls all;
  for (std::uint32_t edge = 0; edge < sides.size(); ++edge) {
    all.has_mapped_doors |= doors[edge] != 0;
    for (const LinePart& stretch : free_parts(footprint, edge, doors[edge], site))
      all.walls.push_back({edge, stretch, sides[edge] || doors[edge] != 0});
  }
  return all;
}

// The point's place along an edge.
double place_m(const map::Footprint& footprint, std::uint32_t edge, Vec2 p) {
  const Ring& ring = footprint.polygon.outer;
  return dot(p - ring[edge], unit(ring[(edge + 1) % ring.size()] - ring[edge]));
}

double distance_m(const map::Footprint& footprint, const FrontWall& wall, Vec2 p) {
  const Ring& ring = footprint.polygon.outer;
  const Vec2 from = ring[wall.edge], along = unit(ring[(wall.edge + 1) % ring.size()] - from);
  return distance_to_segment(from + along * wall.stretch.from_m, from + along * wall.stretch.to_m, p);
}

// A wall for a point; the least rank is the best.
struct Choice {
  std::tuple<bool, bool, double, ObjectId> rank;  // outside, faces no street, distance, footprint
  FrontWall* wall;
};

struct FrontPlanner {
  const FrontSite& site;
  std::map<std::size_t, FrontWalls> walls{};
  std::vector<std::uint32_t> candidates{};  // footprints that may have fronts
  BoxGrid grid{};

  void index() {
    std::vector<Box2> boxes;
    for (std::uint32_t i = 0; i < site.footprints.size(); ++i) {
      if (!may_have_fronts(site.footprints[i])) continue;
      candidates.push_back(i);
      boxes.push_back(box_of(site.footprints[i].polygon.outer).widened(kFrontOutside_m));
    }
    grid = grid_of(boxes, kFrontBucket_m);
  }

  FrontWalls& walls_of(std::size_t footprint) {
    const auto known = walls.find(footprint);
    return known != walls.end() ? known->second
                                : walls.emplace(footprint, front_walls_of(footprint, site)).first->second;
  }

  std::optional<Choice> best_wall(const map::FrontPoint& point) {
    std::optional<Choice> best;
    for (const std::uint32_t candidate : boxes_about(grid, point.at)) {
      const std::uint32_t i = candidates[candidate];
      const map::Footprint& footprint = site.footprints[i];
      if (point.is_assumed && footprint.id != point.id) continue;
      const bool is_inside = contains(footprint.polygon, point.at);
      for (FrontWall& wall : walls_of(i).walls) {
        const double away_m = distance_m(footprint, wall, point.at);
        if (away_m > (!is_inside ? kFrontOutside_m : wall.faces_street ? kFrontInside_m : kNearWall_m)) continue;
        const Choice choice{{!is_inside, !wall.faces_street, away_m, footprint.id}, &wall};
        if (!best || choice.rank < best->rank) best = choice;
      }
    }
    return best;
  }
};

// A piece of a stretch in steps: a front, or the place for the building's own door.
struct Piece {
  const map::FrontPoint* point = nullptr;  // null: the door
  int middle = 0, width = 0;
  int start = 0;
};

// Moves the pieces, which fit into the length, so that they keep their order and do not overlap.
void push_apart(std::vector<Piece>& pieces, int length) {
  int end = 0;
  for (Piece& piece : pieces) {
    piece.start = std::max(piece.middle - piece.width / 2, end);
    end = piece.start + piece.width;
  }
  for (auto piece = pieces.rbegin(); piece != pieces.rend(); ++piece) {
    piece->start = std::min(piece->start, length - piece->width);
    length = piece->start;
  }
}

// Inserts the door's place: in the middle, or beside a front that is alone, on its longer side.
void insert_door(std::vector<Piece>& pieces, int length) {
  const int width = steps_of(kDoorTile_m);
  if (pieces.size() > 1)
    pieces.insert(pieces.begin() + static_cast<std::ptrdiff_t>(pieces.size() / 2), {nullptr, length / 2, width});
  else if (pieces.front().middle > length / 2)
    pieces.insert(pieces.begin(), {nullptr, width / 2, width});
  else
    pieces.push_back({nullptr, length - width / 2, width});
}

// Returns the fronts of one stretch, in order. Points for which there is no room are not among them.
std::vector<std::pair<const map::FrontPoint*, Front>> share_wall(const map::Footprint& footprint, const FrontWall& wall,
                                                                 bool keeps_door) {
  const int first = -steps_of(-wall.stretch.from_m), length = steps_of(wall.stretch.to_m) - first;
  const int least = steps_of(kLeastFront_m), door = steps_of(kDoorTile_m);
  const bool has_door = keeps_door && length >= least + door;
  const int room = length - (has_door ? door : 0);
  std::vector<const map::FrontPoint*> points = wall.points;
  points.resize(std::min(points.size(), static_cast<std::size_t>(room / least)));
  if (points.empty()) return {};
  const int width = std::min(steps_of(kWidestFront_m), room / static_cast<int>(points.size()));
  std::vector<Piece> pieces;
  for (const map::FrontPoint* point : points)
    pieces.push_back({point, steps_of(place_m(footprint, wall.edge, point->at)) - first, width});
  std::ranges::stable_sort(pieces, {}, &Piece::middle);
  if (has_door) insert_door(pieces, length);
  push_apart(pieces, length);
  std::vector<std::pair<const map::FrontPoint*, Front>> fronts;
  for (const Piece& piece : pieces) {
    if (!piece.point) continue;
    fronts.emplace_back(piece.point, Front{.edge = wall.edge,
                                           .from_m = (first + piece.start) * kFrontStep_m,
                                           .to_m = (first + piece.start + piece.width) * kFrontStep_m,
                                           .kind = piece.point->tags.kind,
                                           .hours = piece.point->tags.hours,
                                           .is_assumed = piece.point->is_assumed});
  }
  return fronts;
}

const FrontWall* longest_street_wall(const FrontWalls& all) {
  const FrontWall* longest = nullptr;
  for (const FrontWall& wall : all.walls)
    if (wall.faces_street && (!longest || wall.length_m() > longest->length_m())) longest = &wall;
  return longest;
}

// Adds the fronts of a footprint, and the points that have one.
void add_fronts(const map::Footprint& footprint, const FrontWalls& all, std::vector<Front>& fronts,
                std::vector<const map::FrontPoint*>& placed) {
  const FrontWall* longest = longest_street_wall(all);
  for (const FrontWall& wall : all.walls)
    for (const auto& [point, front] : share_wall(footprint, wall, !all.has_mapped_doors && &wall == longest))
      fronts.push_back(front), placed.push_back(point);
  std::ranges::sort(fronts, {}, [](const Front& front) { return std::pair(front.edge, front.from_m); });
}

// The openings of a footprint as a building has them, without heights.
Building with_openings(ObjectId footprint, std::span<const map::Passageway> passageways) {
  Building building;
  for (const map::Passageway& p : equal_span(passageways, footprint, &map::Passageway::building))
    building.passageways.push_back({.way = p.way, .axis = p.axis, .left_m = p.left_m, .right_m = p.right_m});
  return building;
}

void remove_stretch(std::vector<LinePart>& stretches, LinePart gone) {
  std::vector<LinePart> kept;
  for (const LinePart& stretch : stretches) {
    if (const double end_m = std::min(stretch.to_m, gone.from_m); end_m > stretch.from_m)
      kept.push_back({stretch.from_m, end_m});
    if (const double begin_m = std::max(stretch.from_m, gone.to_m); begin_m < stretch.to_m)
      kept.push_back({begin_m, stretch.to_m});
  }
  stretches = std::move(kept);
}

}  // namespace

bool may_have_fronts(const map::Footprint& footprint) {
  using map::BuildingClass;
  constexpr BuildingClass kWithout[] = {BuildingClass::kHall,  BuildingClass::kGarage,     BuildingClass::kHut,
                                        BuildingClass::kBarn,  BuildingClass::kChurch,     BuildingClass::kTower,
                                        BuildingClass::kRoof,  BuildingClass::kGreenhouse, BuildingClass::kCastle,
                                        BuildingClass::kSteps, BuildingClass::kShelter,    BuildingClass::kColumn,
                                        BuildingClass::kShell};
  const auto own = static_cast<BuildingClass>(footprint.building_class);
  return !footprint.has_parts && !footprint.is_open && footprint.min_height_m <= 0 &&
         footprint.polygon.outer.size() >= 3 && area_m2(footprint.polygon) >= kLeastArea_m2 &&
         std::ranges::find(kWithout, own) == std::end(kWithout);
}

std::vector<LinePart> free_parts(std::size_t footprint, std::size_t edge, std::uint16_t doors, const FrontSite& site) {
  const Ring& ring = site.footprints[footprint].polygon.outer;
  const Vec2 from = ring[edge], to = ring[(edge + 1) % ring.size()];
  std::vector<LinePart> stretches{{0, distance(from, to)}};
  if (stretches[0].to_m < kLeastFront_m) return {};
  for (const SharedWall& wall : site.shared_walls[footprint])
    if (wall.edge == edge) remove_stretch(stretches, {wall.from_m, wall.to_m});
  for (const LinePart& opening :
       parts_in_openings(with_openings(site.footprints[footprint].id, site.passageways), from, to, 0.25))
    remove_stretch(stretches, opening);
  for (const double door_m : door_places_m(doors, distance(from, to)))
    remove_stretch(stretches, {door_m - kMinDoorToCorner_m, door_m + kMinDoorToCorner_m});
  std::erase_if(stretches, [](const LinePart& s) { return s.to_m - s.from_m < kLeastFront_m; });
  return stretches;
}

std::vector<std::vector<Front>> plan_fronts(std::span<const map::FrontPoint> points, const FrontSite& site,
                                            Report& report) {
  std::vector<std::vector<Front>> fronts(site.footprints.size());
  if (points.empty()) return fronts;
  std::vector<const map::FrontPoint*> sorted, placed;
  for (const map::FrontPoint& point : points) sorted.push_back(&point);
  // mapped ones first: where there is no room for all, assumed ones are left out
  std::ranges::stable_sort(sorted, {},
                           [](const map::FrontPoint* p) { return std::tuple(p->is_assumed, p->id, p->at); });
  FrontPlanner planner{site};
  planner.index();
  for (const map::FrontPoint* point : sorted)
    if (const std::optional<Choice> choice = planner.best_wall(*point)) choice->wall->points.push_back(point);
  for (const auto& [footprint, walls] : planner.walls)
    add_fronts(site.footprints[footprint], walls, fronts[footprint], placed);
  std::ranges::sort(placed);
  Account account;
  for (const map::FrontPoint* point : sorted) {
    if (point->is_assumed) continue;
    const bool counts = report.counts(point->id.osm);
    account.in += counts;
    if (std::ranges::binary_search(placed, point))
      account.out += counts;
    else
      report.drop(account, Code::kNoWallForFront, point->id.osm);
  }
  report.account("buildings", "front") = account;
  return fronts;
}

}  // namespace citykiln::buildings
