#include "compiler/buildings/mass_model.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <span>

#include "compiler/contract/detail_tolerances.h"
#include "compiler/geometry/snap.h"
#include "grammars/derivation/form_roofs.h"
#include "grammars/roofs/generate_roof.h"

namespace citykiln::buildings {
namespace {

using grammars::Face;
using grammars::FaceTag;

// Lower strips of wall are not worth a face of their own.
constexpr double kLeastWall_m = 0.25;

// A straight wall of the roof's plan, with the footprint's edges that it runs along.
struct Run {
  std::vector<Vec2> points;          // two, and those between them where a ridge or valley ends over the wall
  std::vector<std::uint32_t> edges;  // of the outer ring; none along a hole
  Vec2 from() const { return points.front(); }
  Vec2 to() const { return points.back(); }
  double length_m() const { return distance(from(), to()); }
};

// Corners by place. Those of holes, which no edge of the outer ring starts at, count up from its size.
std::map<Vec2, std::uint32_t> corners_of(const Polygon& footprint) {
  std::map<Vec2, std::uint32_t> corners;
  std::uint32_t count = 0;
  for (const Vec2 p : footprint.outer) corners.try_emplace(p, count++);
  for (const Ring& hole : footprint.holes)
    for (const Vec2 p : hole) corners.try_emplace(p, count++);
  return corners;
}

bool is_straight(Vec2 a, Vec2 b, Vec2 c) {
  const Vec2 way = c - a;
  return std::abs(cross(way, b - a)) <= kQuantum_m * length(way) && dot(b - a, way) > 0;
}

// Edges of the outer ring from one of its corners to another.
std::vector<std::uint32_t> edges_between(std::uint32_t from, std::uint32_t to, std::size_t count) {
  std::vector<std::uint32_t> edges;
  for (std::uint32_t i = from; i != to; i = (i + 1) % static_cast<std::uint32_t>(count)) edges.push_back(i);
  return edges;
}

// A ring of the eaves, cut at its corners.
std::vector<Run> runs_of(const std::vector<Vec2>& ring, const Ring& outer,
                         const std::map<Vec2, std::uint32_t>& corners) {
  const std::size_t n = ring.size();
  std::vector<Run> runs;
  std::size_t first = 0;
  while (first < n && is_straight(ring[(first + n - 1) % n], ring[first], ring[(first + 1) % n]) &&
         !corners.contains(ring[first]))
    ++first;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 a = ring[(first + i) % n], b = ring[(first + i + 1) % n];
    const bool goes_on = !runs.empty() && !corners.contains(a) && is_straight(runs.back().from(), a, b);
    if (goes_on)
      runs.back().points.push_back(b);
    else
      runs.push_back({{a, b}, {}});
  }
  for (Run& run : runs) {
    const auto from = corners.find(run.from()), to = corners.find(run.to());
    if (from == corners.end() || to == corners.end()) continue;
    if (std::max(from->second, to->second) >= outer.size()) continue;
    std::vector<std::uint32_t> edges = edges_between(from->second, to->second, outer.size());
    if (edges.size() < outer.size() / 2 + 1) run.edges = std::move(edges);
  }
  return runs;
}

// The rings of the eaves in the footprint's order, each from its first corner on: a wall keeps its number, and so its
// dice, whatever is done about the roof.
std::vector<std::vector<Vec2>> eaves_in_order(const roofs::Roof& roof, const std::map<Vec2, std::uint32_t>& corners) {
  const auto number_of = [&](Vec2 p) {
    const auto corner = corners.find(p);
    return corner == corners.end() ? ~0u : corner->second;
  };
  std::vector<std::vector<Vec2>> rings;
  for (const std::vector<std::uint32_t>& eaves : roof.eaves) {
    std::vector<Vec2>& ring = rings.emplace_back();
    for (const std::uint32_t p : eaves) ring.push_back(in_plan(roof.positions[p]));
    std::rotate(ring.begin(), std::ranges::min_element(ring, {}, number_of), ring.end());
  }
  std::ranges::stable_sort(rings, {}, [&](const std::vector<Vec2>& ring) { return number_of(ring.front()); });
  return rings;
}

std::vector<Run> runs_of(const Building& building, const roofs::Roof& roof) {
  const std::map<Vec2, std::uint32_t> corners = corners_of(building.footprint);
  std::vector<Run> runs;
  for (const std::vector<Vec2>& ring : eaves_in_order(roof, corners))
    for (Run& run : runs_of(ring, building.footprint.outer, corners)) runs.push_back(std::move(run));
  return runs;
}

// The part of a run between two distances along it, from one height up to another. What ends over it does so at the
// eaves: below them walls are straight, so that what lies under them meets them corner to corner.
Face wall_face(const Run& run, double from_m, double to_m, double low_m, double high_m, double eaves_m) {
  const Vec2 along = unit(run.to() - run.from());
  const double length_m = run.length_m();
  const auto place = [&](double at_m) {
    return at_m <= 0 ? run.from() : at_m >= length_m ? run.to() : run.from() + along * at_m;
  };
  const Vec2 a = place(from_m), b = place(to_m);
  Face face;
  face.tag = FaceTag::kSide;
  face.outer = {at_height(a, low_m), at_height(b, low_m), at_height(b, high_m)};
  for (std::size_t i = run.points.size() - 1; high_m == eaves_m && i-- > 1;) {
    const double at_m = dot(along, run.points[i] - run.from());
    if (at_m > from_m && at_m < to_m) face.outer.push_back(at_height(run.points[i], high_m));
  }
  face.outer.push_back(at_height(a, high_m));
  return face;
}

// A party wall, in distances along a run.
struct Stretch {
  double from_m, to_m;
  const PartyWall* wall;
};

std::vector<Stretch> stretches_on(const Run& run, const Building& building) {
  const Vec2 along = unit(run.to() - run.from());
  const Ring& ring = building.footprint.outer;
  std::vector<Stretch> stretches;
  for (const PartyWall& wall : building.party_walls) {
    if (std::find(run.edges.begin(), run.edges.end(), wall.edge) == run.edges.end()) continue;
    const Vec2 corner = ring[wall.edge], next = ring[(wall.edge + 1) % ring.size()];
    const double start_m = dot(along, corner - run.from()), end_m = start_m + distance(corner, next);
    const auto near = [&](double at_m) {
      return at_m < kLeastWall_m ? 0 : at_m > run.length_m() - kLeastWall_m ? run.length_m() : at_m;
    };
    const double from_m = near(start_m + wall.from_m), to_m = near(std::min(end_m, start_m + wall.to_m));
    if (from_m < to_m) stretches.push_back({from_m, to_m, &wall});
  }
  std::sort(stretches.begin(), stretches.end(), [](const Stretch& a, const Stretch& b) { return a.from_m < b.from_m; });
  return stretches;
}

// What is known of a wall from the recipe.
FacadeEdge front_of(const Run& run, const Building& building) {
  FacadeEdge front;
  for (const std::uint32_t edge : run.edges) {
    if (edge >= building.fronts.size()) continue;
    front.faces_street |= building.fronts[edge].faces_street;
    front.buried_storeys = std::max(front.buried_storeys, building.fronts[edge].buried_storeys);
  }
  return front;
}

// How walls are made.
struct Walling {
  const Building& building;
  double eaves_m;
  bool hides;  // what a neighbour hides is left out
  MassModel& mass;
};

void add_wall(const Walling& walling, Face face, FaceTag tag, bool faces_street) {
  face.tag = tag, face.street = faces_street;
  walling.mass.walls.push_back(std::move(face));
}

// Above what the neighbour hides a fire wall, or a wall like others.
void add_party_wall(const Walling& walling, const Run& run, const Stretch& stretch, double low_m, bool faces_street) {
  const double top_m = std::clamp(stretch.wall->top_m, low_m, walling.eaves_m);
  const double over_m = top_m > walling.eaves_m - kLeastWall_m ? walling.eaves_m : top_m;
  if ((!stretch.wall->is_hidden || !walling.hides) && over_m > low_m)
    add_wall(walling, wall_face(run, stretch.from_m, stretch.to_m, low_m, over_m, walling.eaves_m), FaceTag::kInside,
             false);
  if (over_m >= walling.eaves_m) return;
  const FaceTag tag = stretch.wall->has_windows_above ? FaceTag::kSide : FaceTag::kInside;
  add_wall(walling, wall_face(run, stretch.from_m, stretch.to_m, over_m, walling.eaves_m, walling.eaves_m), tag,
           faces_street);
}

void add_walls(const Walling& walling, const Run& run) {
  const Building& building = walling.building;
  const FacadeEdge front = front_of(run, building);
  const double low_m = snapped(std::min(walling.eaves_m, building.floor_m + front.buried_storeys * storey_m(building)));
  if (low_m > building.bottom_m) {
    walling.mass.foundation.push_back(wall_face(run, 0, run.length_m(), building.bottom_m, low_m, walling.eaves_m));
  }
  if (low_m >= walling.eaves_m) return;
  double from_m = 0;
  for (const Stretch& stretch : stretches_on(run, building)) {
    if (stretch.from_m > from_m)
      add_wall(walling, wall_face(run, from_m, stretch.from_m, low_m, walling.eaves_m, walling.eaves_m), FaceTag::kSide,
               front.faces_street);
    add_party_wall(walling, run, stretch, low_m, front.faces_street);
    from_m = stretch.to_m;
  }
  if (from_m < run.length_m())
    add_wall(walling, wall_face(run, from_m, run.length_m(), low_m, walling.eaves_m, walling.eaves_m), FaceTag::kSide,
             front.faces_street);
}

// Places along walls where something ends over them.
std::set<Vec2> between_ends(std::span<const Run> runs) {
  std::set<Vec2> places;
  for (const Run& run : runs) places.insert(run.points.begin() + 1, run.points.end() - 1);
  return places;
}

// As straight as the walls above it.
void straighten(grammars::Ring3& ring, const std::set<Vec2>& between) {
  grammars::Ring3 kept;
  for (const Vec3 p : ring)
    if (!between.contains(in_plan(p))) kept.push_back(p);
  ring = std::move(kept);
}

void add_underside(const Building& building, std::span<const Run> runs, MassModel& mass) {
  const std::set<Vec2> between = between_ends(runs);
  for (Face& face : grammars::faces_of(mass.roof)) {
    if (face.tag != FaceTag::kBottom) continue;
    straighten(face.outer, between);
    for (grammars::Ring3& hole : face.holes) straighten(hole, between);
    each_vertex(face, [&](Vec3& p) { p.z += building.bottom_m; });
    mass.foundation.push_back(std::move(face));
  }
}

double length_of(const Face& wall) { return length(wall.outer[1] - wall.outer[0]); }

// Along the longest wall at a street, or the longest.
Vec3 front_axis(const MassModel& mass) {
  const Face* best = nullptr;
  for (const Face& wall : mass.walls)
    if (!best || std::pair(wall.street, length_of(wall)) > std::pair(best->street, length_of(*best))) best = &wall;
  return best ? unit(best->outer[1] - best->outer[0]) : Vec3{1, 0, 0};
}

}  // namespace

MassModel mass_model_of(const Building& building, double tolerance_m, Report& report) {
  MassModel mass;
  mass.roof = roofs::generate_roof(building.footprint, building.roof_shape, tolerance_m, building.id.osm, report);
  const Walling walling{building, eaves_m(building), has_detail(Detail::kPartyWallOpenings, tolerance_m), mass};
  const std::vector<Run> runs = runs_of(building, mass.roof);
  for (const Run& run : runs) add_walls(walling, run);
  if (!building.stands_on_ground) add_underside(building, runs, mass);
  return mass;
}

grammars::Shape shape_of(const Building& building, const MassModel& mass) {
  grammars::Shape shape;
  shape.id = stable_id(building.id);
  shape.faces = mass.walls;
  for (Face& face : grammars::faces_of(mass.roof)) {
    if (face.tag == FaceTag::kBottom) continue;
    if (face.tag == FaceTag::kSide) face.tag = FaceTag::kVertical;
    each_vertex(face, [&](Vec3& p) { p.z += eaves_m(building); });
    shape.faces.push_back(std::move(face));
  }
  const Vec3 x = front_axis(mass), up{0, 0, 1};
  shape.scope = grammars::scope_around(shape.faces, {x, up, cross(x, up)}, {});
  shape.parent_scope = shape.scope;
  return shape;
}

}  // namespace citykiln::buildings
