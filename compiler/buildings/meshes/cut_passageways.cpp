#include "compiler/buildings/meshes/cut_passageways.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <tuple>

#include "compiler/buildings/meshes/passageways.h"
#include "compiler/buildings/meshes/terminal_meshes.h"
#include "compiler/geometry/polygons/clip_polygon.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"

namespace citykiln::buildings {
namespace {

using materials::MaterialMesh;

// Points nearer to a side are on it.
constexpr double kOnSide_m = 0x1p-11;
// A jamb this near to a wall of the building would lie in it.
constexpr double kInWall_m = 0.02;

// A convex prism that reaches from below everything up to top_m.
struct Prism {
  Ring ring;
  Box2 box;
  double top_m;
};

std::vector<Prism> prisms_of(const Building& building) {
  std::vector<Prism> prisms;
  for (const Passageway& passageway : building.passageways)
    for (Ring& ring : opening_rings(passageway)) {
      const Box2 box = box_of(ring);
      prisms.push_back({std::move(ring), box, passageway.top_m});
    }
  return prisms;
}

struct Corner {
  Vec3 at;
  Vec2 uv;
  Vec3 normal;
  materials::Tint tint;
};

// Convex and planar.
using Convex = std::vector<Corner>;

// The corner between two others. The order of a and b does not matter, so that neighbours stay vertex to vertex.
Corner between(const Corner& a, const Corner& b, double da, double db) {
  if (std::tuple(b.at.x, b.at.y, b.at.z) < std::tuple(a.at.x, a.at.y, a.at.z)) return between(b, a, db, da);
  const double share = da / (da - db);
  return {a.at + (b.at - a.at) * share, a.uv + (b.uv - a.uv) * share, a.normal, a.tint};
}

// The parts of a polygon where a linear function is positive, and where it is negative. Either may be empty.
struct Halves {
  Convex above, below;
};

template <typename Value>
Halves halves_of(const Convex& polygon, Value value_at) {
  Halves halves;
  std::vector<double> values;
  for (const Corner& corner : polygon) {
    const double value = value_at(corner.at);
    values.push_back(std::abs(value) <= kOnSide_m ? 0 : value);
  }
  // a polygon in the plane itself counts as above
  if (std::ranges::none_of(values, [](double v) { return v < 0; })) return {polygon, {}};
  if (std::ranges::none_of(values, [](double v) { return v > 0; })) return {{}, polygon};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t next = (i + 1) % polygon.size();
    if (values[i] >= 0) halves.above.push_back(polygon[i]);
    if (values[i] <= 0) halves.below.push_back(polygon[i]);
    if (values[i] * values[next] >= 0) continue;
    const Corner cut = between(polygon[i], polygon[next], values[i], values[next]);
    halves.above.push_back(cut), halves.below.push_back(cut);
  }
  return halves;
}

// Appends the parts of a polygon outside a prism; false if the prism leaves it whole.
bool cut(const Convex& polygon, const Prism& prism, std::vector<Convex>& kept) {
  Convex inside = polygon;
  std::vector<Convex> outside;
  const auto keep_above = [&](auto value_at) {
    Halves halves = halves_of(inside, value_at);
    if (!halves.above.empty()) outside.push_back(std::move(halves.above));
    inside = std::move(halves.below);
    return !inside.empty();
  };
  bool is_cut = keep_above([&](Vec3 p) { return p.z - prism.top_m; });
  for (std::size_t i = 0; is_cut && i < prism.ring.size(); ++i) {
    const Vec2 a = prism.ring[i], right = left_of(unit(prism.ring[(i + 1) % prism.ring.size()] - a)) * -1;
    is_cut = keep_above([&](Vec3 p) { return dot(right, in_plan(p) - a); });
  }
  if (!is_cut) return false;
  std::ranges::move(outside, std::back_inserter(kept));
  return true;
}

// The parts of a polygon outside all prisms; nothing if it stays whole.
std::optional<std::vector<Convex>> cut_all(const Convex& polygon, std::span<const Prism> prisms) {
  Box2 box;
  double low_m = polygon.front().at.z;
  for (const Corner& corner : polygon) box.grow(in_plan(corner.at)), low_m = std::min(low_m, corner.at.z);
  std::vector<Convex> parts = {polygon};
  bool is_cut = false;
  for (const Prism& prism : prisms) {
    if (low_m >= prism.top_m || !box.touches(prism.box)) continue;
    std::vector<Convex> kept;
    for (Convex& part : parts)
      if (cut(part, prism, kept))
        is_cut = true;
      else
        kept.push_back(std::move(part));
    parts = std::move(kept);
  }
  return is_cut ? std::optional(std::move(parts)) : std::nullopt;
}

Corner corner_of(const MaterialMesh& mesh, std::uint32_t i) {
  return {mesh.mesh.positions[i], mesh.uvs.empty() ? Vec2{} : mesh.uvs[i],
          mesh.mesh.normals.empty() ? Vec3{} : mesh.mesh.normals[i], mesh.tints.empty() ? mesh.tint : mesh.tints[i]};
}

std::uint32_t add_corner(const Corner& corner, const MaterialMesh& like, MaterialMesh& mesh) {
  mesh.mesh.positions.push_back(corner.at);
  if (!like.uvs.empty()) mesh.uvs.push_back(corner.uv);
  if (!like.mesh.normals.empty()) mesh.mesh.normals.push_back(corner.normal);
  if (!like.tints.empty()) mesh.tints.push_back(corner.tint);
  return static_cast<std::uint32_t>(mesh.mesh.positions.size() - 1);
}

bool has_area(const Corner& a, const Corner& b, const Corner& c) {
  constexpr double kLeast_m2 = 1e-7;
  return length(cross(b.at - a.at, c.at - a.at)) > kLeast_m2;
}

void add_convex(const Convex& polygon, const MaterialMesh& like, MaterialMesh& mesh) {
  std::vector<std::uint32_t> numbers;
  for (const Corner& corner : polygon) numbers.push_back(add_corner(corner, like, mesh));
  for (std::size_t i = 2; i < polygon.size(); ++i)
    if (has_area(polygon[0], polygon[i - 1], polygon[i]))
      mesh.mesh.triangles.push_back({numbers[0], numbers[i - 1], numbers[i]});
}

// The mesh without points that no triangle has.
MaterialMesh compacted(const MaterialMesh& mesh) {
  MaterialMesh compact{{}, mesh.material, mesh.tint, mesh.feature};
  compact.colour_source = mesh.colour_source;
  constexpr std::uint32_t kUnused = ~0u;
  std::vector<std::uint32_t> numbers(mesh.mesh.positions.size(), kUnused);
  for (const Triangle& triangle : mesh.mesh.triangles) {
    Triangle& added = compact.mesh.triangles.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& number = numbers[triangle[k]];
      if (number == kUnused) number = add_corner(corner_of(mesh, triangle[k]), mesh, compact);
      added[k] = number;
    }
  }
  return compact;
}

void cut_mesh(MaterialMesh& mesh, std::span<const Prism> prisms) {
  MaterialMesh result = mesh;
  result.mesh.triangles.clear();
  bool is_cut = false;
  for (const Triangle& t : mesh.mesh.triangles) {
    const auto parts = cut_all({corner_of(mesh, t[0]), corner_of(mesh, t[1]), corner_of(mesh, t[2])}, prisms);
    if (!parts) {
      result.mesh.triangles.push_back(t);
      continue;
    }
    is_cut = true;
    for (const Convex& part : *parts) add_convex(part, mesh, result);
  }
  if (is_cut) mesh = compacted(result);
}

// An opening as valid polygons.
struct Opening {
  std::vector<Polygon> plan;
  std::vector<Ring> rings;
  double top_m;
};

std::vector<Opening> openings_in(const Building& building) {
  std::vector<Opening> openings;
  for (const Passageway& passageway : building.passageways) {
    std::vector<Ring> rings = opening_rings(passageway);
    std::vector<Polygon> plan = united(rings);
    openings.push_back({std::move(plan), std::move(rings), passageway.top_m});
  }
  return openings;
}

bool is_in_plan(const Opening& opening, Vec2 p) {
  return std::ranges::any_of(opening.plan, [&](const Polygon& polygon) {
    const bool is_on_side = std::ranges::any_of(
        rings_of(polygon), [&](const Ring* ring) { return distance_to_ring(*ring, p) <= kOnSide_m; });
    return !is_on_side && contains(polygon, p);
  });
}

void add_crossings(Vec2 a, Vec2 b, const Polygon& polygon, std::vector<double>& shares) {
  for (const Ring* ring : rings_of(polygon))
    for (std::size_t i = 0; i < ring->size(); ++i)
      if (const auto crossing = crossing_shares(a, b, (*ring)[i], (*ring)[(i + 1) % ring->size()]))
        shares.push_back(crossing->first);
}

// Where a side of one opening can change from open to closed.
std::vector<double> changes_along(Vec2 a, Vec2 b, const Building& building, std::span<const Opening> openings) {
  std::vector<double> shares = {0, 1};
  add_crossings(a, b, building.footprint, shares);
  for (const Opening& opening : openings)
    for (const Polygon& polygon : opening.plan) add_crossings(a, b, polygon, shares);
  std::ranges::sort(shares);
  return shares;
}

bool is_in_building(const Building& building, Vec2 p) {
  const auto is_in_wall = [&](const Ring* ring) { return distance_to_ring(*ring, p) < kInWall_m; };
  return contains(building.footprint, p) && std::ranges::none_of(rings_of(building.footprint), is_in_wall);
}

// A jamb that faces the left of a to b.
void add_jamb(Vec2 a, Vec2 b, double bottom_m, double top_m, MaterialMesh& mesh) {
  if (top_m <= bottom_m) return;
  grammars::Face face;
  face.outer = {at_height(b, bottom_m), at_height(a, bottom_m), at_height(a, top_m), at_height(b, top_m)};
  add_face(face, mesh);
}

void add_jambs(std::size_t number, std::span<const Opening> openings, const Building& building, MaterialMesh& mesh) {
  const Opening& opening = openings[number];
  const auto add_side = [&](Vec2 a, Vec2 b) {
    const std::vector<double> shares = changes_along(a, b, building, openings);
    for (std::size_t i = 1; i < shares.size(); ++i) {
      const Vec2 from = a + (b - a) * shares[i - 1], to = a + (b - a) * shares[i], middle = (from + to) * 0.5;
      if (distance(from, to) < kOnSide_m || !is_in_building(building, middle)) continue;
      double bottom_m = building.bottom_m;
      for (std::size_t other = 0; other < openings.size(); ++other)
        if (other != number && is_in_plan(openings[other], middle))
          bottom_m = std::max(bottom_m, openings[other].top_m);
      add_jamb(from, to, bottom_m, opening.top_m, mesh);
    }
  };
  for (const Polygon& polygon : opening.plan)
    for (const Ring* ring : rings_of(polygon))
      for (std::size_t i = 0; i < ring->size(); ++i) add_side((*ring)[i], (*ring)[(i + 1) % ring->size()]);
}

// A box around the rings, clockwise, which lowers all winding numbers by one.
Ring clockwise_box(const Box2& box) { return {box.min, {box.min.x, box.max.y}, box.max, {box.max.x, box.min.y}}; }

// The part of an opening inside the building that no higher opening has.
std::vector<Polygon> ceiling_of(std::size_t number, std::span<const Opening> openings, const Building& building) {
  const Opening& opening = openings[number];
  std::vector<Ring> rings = copied_rings(building.footprint);
  Box2 box = box_of(building.footprint.outer);
  for (const Polygon& polygon : opening.plan)
    for (Ring& ring : copied_rings(polygon)) {
      for (const Vec2 p : ring) box.grow(p);
      rings.push_back(std::move(ring));
    }
  rings.push_back(clockwise_box(box.widened(1)));
  for (std::size_t other = 0; other < openings.size(); ++other) {
    const bool is_above =
        openings[other].top_m > opening.top_m || (openings[other].top_m == opening.top_m && other < number);
    if (!is_above) continue;
    for (Ring ring : openings[other].rings) {
      std::ranges::reverse(ring);
      rings.push_back(std::move(ring));
    }
  }
  return united(rings);
}

grammars::Ring3 turned_at_height(const Ring& ring, double z_m) {
  grammars::Ring3 turned;
  for (auto p = ring.rbegin(); p != ring.rend(); ++p) turned.push_back(at_height(*p, z_m));
  return turned;
}

void add_ceiling(std::size_t number, std::span<const Opening> openings, const Building& building, MaterialMesh& mesh) {
  for (const Polygon& polygon : ceiling_of(number, openings, building)) {
    grammars::Face face;
    face.outer = turned_at_height(polygon.outer, openings[number].top_m);
    for (const Ring& hole : polygon.holes) face.holes.push_back(turned_at_height(hole, openings[number].top_m));
    add_face(face, mesh);
  }
}

// An upright box about a point, without its ends.
void add_pillar(Vec2 at, Vec2 along, double bottom_m, double top_m, MaterialMesh& mesh) {
  const Vec2 a = along * (kPillar_m / 2), b = left_of(a);
  const std::array<Vec2, 4> ring = {at - a - b, at + a - b, at + a + b, at - a + b};
  // each face looks away from the middle
  for (std::size_t i = 0; i < 4; ++i) add_jamb(snapped(ring[(i + 1) % 4]), snapped(ring[i]), bottom_m, top_m, mesh);
}

// The distance from the axis of a way that a pillar keeps: that of the way's own pillars, or beside its jambs.
double pillars_from_axis_m(const Passageway& passageway) {
  const auto of_side = [](double side_m, double pillars_m) { return pillars_m > 0 ? pillars_m : side_m + kPillar_m; };
  return std::max(of_side(passageway.left_m, passageway.pillars_left_m),
                  of_side(passageway.right_m, passageway.pillars_right_m));
}

// True for a pillar in a way: inside a bend of its own, or in another way that crosses the arcade.
bool stands_in_way(Vec2 pillar, double offset_m, const Passageway& own, const Building& building) {
  const auto is_near = [&](const Passageway& other) {
    const double least_m = &other == &own ? std::abs(offset_m) - kPillar_m / 8 : pillars_from_axis_m(other);
    return distance_to_polyline(other.axis, pillar) < least_m;
  };
  return std::ranges::any_of(building.passageways, is_near);
}

// Pillars at equal distances along each segment, where it is inside the building and no way runs.
void add_pillars(const Passageway& passageway, const Building& building, MaterialMesh& mesh) {
  for (const double offset_m : {passageway.pillars_left_m, -passageway.pillars_right_m}) {
    if (offset_m == 0) continue;
    for (std::size_t i = 0; i + 1 < passageway.axis.size(); ++i) {
      const Vec2 a = passageway.axis[i], b = passageway.axis[i + 1], along = unit(b - a);
      const double count = std::max(1.0, std::floor(distance(a, b) / kLeastPillarSpacing_m));
      for (double k = 0.5; k < count; ++k) {
        const Vec2 on_axis = a + (b - a) * (k / count);
        const Vec2 at = on_axis + left_of(along) * offset_m;
        if (contains(building.footprint, on_axis) && !stands_in_way(at, offset_m, passageway, building))
          add_pillar(at, along, building.bottom_m, passageway.top_m, mesh);
      }
    }
  }
}

}  // namespace

void cut_passageways(const Building& building, MaterialMesh wall, GeneratedBuilding& generated) {
  if (building.passageways.empty()) return;
  const std::vector<Prism> prisms = prisms_of(building);
  for (MaterialMesh& mesh : generated.meshes) cut_mesh(mesh, prisms);
  for (TexturedFace& face : generated.textured_faces) cut_mesh(face.mesh, prisms);
  const std::vector<Opening> openings = openings_in(building);
  for (std::size_t i = 0; i < openings.size(); ++i) {
    add_jambs(i, openings, building, wall);
    add_ceiling(i, openings, building, wall);
    add_pillars(building.passageways[i], building, wall);
  }
  std::erase_if(generated.meshes, [](const MaterialMesh& mesh) { return mesh.mesh.triangles.empty(); });
  std::erase_if(generated.textured_faces, [](const TexturedFace& face) { return face.mesh.mesh.triangles.empty(); });
  if (!wall.mesh.triangles.empty()) generated.meshes.push_back(std::move(wall));
}

}  // namespace citykiln::buildings
