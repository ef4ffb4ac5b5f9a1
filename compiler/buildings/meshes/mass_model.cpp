#include "compiler/buildings/meshes/mass_model.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <set>
#include <span>

#include "compiler/buildings/meshes/passageways.h"
#include "compiler/contract/detail_tolerances.h"
#include "compiler/geometry/snap.h"
#include "grammars/derivation/form_roofs.h"
#include "grammars/roofs/generate_roof.h"

namespace citykiln::buildings {
namespace {

using grammars::Face;
using grammars::FaceTag;

// Lower or shorter strips of wall do not become faces of their own.
constexpr double kMinStrip_m = 0.25;

// A straight stretch of the eaves in plan.
struct Run {
  std::vector<Vec2> points;          // both ends, and between them where a ridge or valley of the roof ends
  std::vector<std::uint32_t> edges;  // the edges of the outer ring along it; none along a hole
  Vec2 from() const { return points.front(); }
  Vec2 to() const { return points.back(); }
  Vec2 along() const { return unit(to() - from()); }
  double length_m() const { return distance(from(), to()); }
};

// Vertices of the footprint by position. Edges of holes are numbered after the edges of the outer ring.
using CornerNumbers = std::map<Vec2, std::uint32_t>;

CornerNumbers corner_numbers_of(const Polygon& footprint) {
  CornerNumbers corners;
  std::uint32_t count = 0;
  for (const Vec2 p : footprint.outer) corners.try_emplace(p, count++);
  for (const Ring& hole : footprint.holes)
    for (const Vec2 p : hole) corners.try_emplace(p, count++);
  return corners;
}

bool is_straight(Vec2 a, Vec2 b, Vec2 c) {
  const Vec2 along = c - a;
  return std::abs(cross(along, b - a)) <= kQuantum_m * length(along) && dot(b - a, along) > 0;
}

// The edges of the outer ring along a run; none if they would go round most of the ring.
std::vector<std::uint32_t> edges_along(const Run& run, std::size_t count, const CornerNumbers& corners) {
  const auto from = corners.find(run.from()), to = corners.find(run.to());
  if (from == corners.end() || to == corners.end() || std::max(from->second, to->second) >= count) return {};
  std::vector<std::uint32_t> edges;
  for (std::uint32_t i = from->second; i != to->second; i = (i + 1) % static_cast<std::uint32_t>(count))
    edges.push_back(i);
  return edges.size() < count / 2 + 1 ? edges : std::vector<std::uint32_t>{};
}

// Adds the runs of one ring of the eaves, which bends or has a corner of the footprint at their ends.
void add_runs(const std::vector<Vec2>& ring, std::size_t outer_count, const CornerNumbers& corners,
              std::vector<Run>& runs) {
  const std::size_t n = ring.size(), first_run = runs.size();
  std::size_t first = 0;
  while (first < n && is_straight(ring[(first + n - 1) % n], ring[first], ring[(first + 1) % n]) &&
         !corners.contains(ring[first]))
    ++first;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 a = ring[(first + i) % n], b = ring[(first + i + 1) % n];
    if (runs.size() > first_run && !corners.contains(a) && is_straight(runs.back().from(), a, b))
      runs.back().points.push_back(b);
    else
      runs.push_back({{a, b}, {}});
  }
  for (std::size_t i = first_run; i < runs.size(); ++i) runs[i].edges = edges_along(runs[i], outer_count, corners);
}

// The rings of the eaves in the order of the footprint's rings, each from its first corner on. Walls then have the same
// numbers, and rules the same random draws, for every roof.
std::vector<std::vector<Vec2>> eaves_in_order(const roofs::Roof& roof, const CornerNumbers& corners) {
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
  const CornerNumbers corners = corner_numbers_of(building.footprint);
  std::vector<Run> runs;
  for (const std::vector<Vec2>& ring : eaves_in_order(roof, corners))
    add_runs(ring, building.footprint.outer.size(), corners, runs);
  return runs;
}

// A party wall, in distances along a run.
struct Stretch {
  double from_m, to_m;
  const PartyWall* wall;
};

std::vector<Stretch> stretches_on(const Run& run, const Building& building) {
  const Ring& ring = building.footprint.outer;
  std::vector<Stretch> stretches;
  for (const PartyWall& wall : building.party_walls) {
    if (std::ranges::find(run.edges, wall.edge) == run.edges.end()) continue;
    const Vec2 corner = ring[wall.edge], next = ring[(wall.edge + 1) % ring.size()];
    const double start_m = dot(run.along(), corner - run.from()), end_m = start_m + distance(corner, next);
    const auto snapped_to_ends = [&](double at_m) {
      return at_m < kMinStrip_m ? 0 : at_m > run.length_m() - kMinStrip_m ? run.length_m() : at_m;
    };
    const double from_m = snapped_to_ends(start_m + wall.from_m);
    const double to_m = snapped_to_ends(std::min(end_m, start_m + wall.to_m));
    if (from_m < to_m) stretches.push_back({from_m, to_m, &wall});
  }
  std::ranges::sort(stretches, {}, &Stretch::from_m);
  return stretches;
}

// Where the height at which walls begin changes along a run.
struct WallBase {
  double from_m;
  std::uint8_t buried_storeys;
};

// Adds the walls and the foundation along one run.
struct WallBuilder {
  const Building& building;
  const Run& run;
  double tolerance_m;
  MassModel& mass;
  double eaves = eaves_m(building);
  double low_m = 0;  // where walls begin: above the buried storeys
  bool faces_street = false;

  // The bases along the run; of an edge without places of its own they are one.
  std::vector<WallBase> bases() {
    std::vector<WallBase> all;
    for (const std::uint32_t edge : run.edges) {
      if (edge >= building.facade_edges.size()) continue;
      faces_street |= building.facade_edges[edge].faces_street;
      const double start_m = dot(run.along(), building.footprint.outer[edge] - run.from());
      all.push_back({start_m, building.facade_edges[edge].buried_storeys});
      for (const BuriedFrom& place : building.buried_from)
        if (place.edge == edge) all.push_back({start_m + place.from_m, place.storeys});
    }
    // without steps the wall begins at its lowest base: what lies above that is below the ground
    if (!has_detail(Detail::kStoreySteps, tolerance_m) && !all.empty())
      all = {*std::ranges::min_element(all, {}, &WallBase::buried_storeys)}, all.front().from_m = 0;
    return merged(std::move(all));
  }

  // Neighbours of one height are one base, and so are those that leave no more than a strip between them.
  std::vector<WallBase> merged(std::vector<WallBase> all) const {
    std::vector<WallBase> kept{{0, 0}};
    for (const WallBase& base : all) {
      WallBase& last = kept.back();
      if (base.from_m - last.from_m < kMinStrip_m || run.length_m() - base.from_m < kMinStrip_m)
        last.buried_storeys = std::max(last.buried_storeys, base.buried_storeys);
      else if (base.buried_storeys != last.buried_storeys)
        kept.push_back({snapped(base.from_m), base.buried_storeys});
    }
    return kept;
  }

  // The face between two distances along the run and two heights. Points between the run's ends are added at the eaves
  // alone, so that lower walls match those below them vertex to vertex.
  Face face(double from_m, double to_m, double bottom_m, double top_m) const {
    const auto at = [&](double at_m) {
      return at_m <= 0 ? run.from() : at_m >= run.length_m() ? run.to() : run.from() + run.along() * at_m;
    };
    const Vec2 a = at(from_m), b = at(to_m);
    Face face;
    face.tag = FaceTag::kSide;
    face.outer = {at_height(a, bottom_m), at_height(b, bottom_m), at_height(b, top_m)};
    for (std::size_t i = run.points.size() - 1; top_m == eaves && i-- > 1;) {
      const double at_m = dot(run.along(), run.points[i] - run.from());
      if (at_m > from_m && at_m < to_m) face.outer.push_back(at_height(run.points[i], top_m));
    }
    face.outer.push_back(at_height(a, top_m));
    return face;
  }

  void add_wall(const Stretch& stretch, double bottom_m, double top_m, FaceTag tag, bool is_street) {
    Face wall = face(stretch.from_m, stretch.to_m, bottom_m, top_m);
    wall.tag = tag, wall.street = is_street;
    mass.walls.push_back(std::move(wall));
  }

  // An ordinary wall. Above an opening for a way it is a face of its own, so that no window is cut at the sides.
  void add_facade(double from_m, double to_m, double bottom_m, double top_m) {
    for (const LinePart& opening : parts_in_openings(building, run.from(), run.to(), kMinStrip_m)) {
      const double begin_m = std::clamp(opening.from_m, from_m, to_m), end_m = std::clamp(opening.to_m, from_m, to_m);
      if (begin_m > from_m) add_wall({from_m, begin_m, nullptr}, bottom_m, top_m, FaceTag::kSide, faces_street);
      if (end_m > begin_m) add_wall({begin_m, end_m, nullptr}, bottom_m, top_m, FaceTag::kSide, false);
      from_m = std::max(from_m, end_m);
    }
    if (from_m < to_m) add_wall({from_m, to_m, nullptr}, bottom_m, top_m, FaceTag::kSide, faces_street);
  }

  // The wall against a neighbour, and the blind or ordinary wall above it.
  void add_party_wall(const Stretch& stretch) {
    double top_m = std::clamp(stretch.wall->top_m, low_m, eaves);
    if (top_m > eaves - kMinStrip_m) top_m = eaves;
    const bool is_kept = !stretch.wall->is_hidden || !has_detail(Detail::kPartyWallOpenings, tolerance_m);
    if (is_kept && top_m > low_m) add_wall(stretch, low_m, top_m, FaceTag::kInside, false);
    const FaceTag above = stretch.wall->has_windows_above ? FaceTag::kSide : FaceTag::kInside;
    if (top_m < eaves) add_wall(stretch, top_m, eaves, above, faces_street);
  }

  void build() {
    const std::vector<WallBase> along = bases();
    for (std::size_t i = 0; i < along.size(); ++i)
      build_on(along[i], i + 1 < along.size() ? along[i + 1].from_m : run.length_m());
  }

  // The walls on one base, which ends at to_m.
  void build_on(const WallBase& base, double to_m) {
    low_m = snapped(std::min(eaves, building.floor_m + base.buried_storeys * storey_m(building)));
    if (low_m > building.bottom_m) mass.foundation.push_back(face(base.from_m, to_m, building.bottom_m, low_m));
    if (low_m >= eaves) return;
    double from_m = base.from_m;
    for (Stretch stretch : stretches_on(run, building)) {
      stretch.from_m = std::max(stretch.from_m, base.from_m), stretch.to_m = std::min(stretch.to_m, to_m);
      if (stretch.from_m >= stretch.to_m) continue;
      if (stretch.from_m > from_m) add_facade(from_m, stretch.from_m, low_m, eaves);
      add_party_wall(stretch);
      from_m = stretch.to_m;
    }
    if (from_m < to_m) add_facade(from_m, to_m, low_m, eaves);
  }
};

// Positions where a ridge or valley ends between the ends of a run.
std::set<Vec2> points_between_ends(std::span<const Run> runs) {
  std::set<Vec2> points;
  for (const Run& run : runs) points.insert(run.points.begin() + 1, run.points.end() - 1);
  return points;
}

// The underside of the roof, moved down to close a lifted building, without the points that its walls do not have.
void add_underside(const Building& building, std::span<const Run> runs, MassModel& mass) {
  const std::set<Vec2> between = points_between_ends(runs);
  const auto remove_between = [&](grammars::Ring3& ring) {
    grammars::Ring3 kept;
    for (const Vec3 p : ring)
      if (!between.contains(in_plan(p))) kept.push_back(p);
    ring = std::move(kept);
  };
  for (Face& face : grammars::faces_of(mass.roof)) {
    if (face.tag != FaceTag::kBottom) continue;
    remove_between(face.outer);
    std::ranges::for_each(face.holes, remove_between);
    each_vertex(face, [&](Vec3& p) { p.z += building.bottom_m; });
    mass.foundation.push_back(std::move(face));
  }
}

// The direction of the longest wall that faces a street, or of the longest wall.
Vec3 front_axis(const MassModel& mass) {
  const auto rank = [](const Face& wall) { return std::pair(wall.street, length(wall.outer[1] - wall.outer[0])); };
  const auto front = std::ranges::max_element(mass.walls, {}, rank);
  return front != mass.walls.end() ? unit(front->outer[1] - front->outer[0]) : Vec3{1, 0, 0};
}

}  // namespace

MassModel mass_model_of(const Building& building, double tolerance_m, Report& report) {
  assert(tolerance_m > 0);
  MassModel mass;
  mass.roof = roofs::generate_roof(building.footprint, building.roof_shape, tolerance_m, building.id.osm, report);
  const std::vector<Run> runs = runs_of(building, mass.roof);
  for (const Run& run : runs) WallBuilder{building, run, tolerance_m, mass}.build();
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
