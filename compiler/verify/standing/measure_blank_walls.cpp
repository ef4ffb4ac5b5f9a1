#include "compiler/verify/standing/measure_blank_walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "compiler/buildings/meshes/passageways.h"
#include "compiler/contract/tolerance.h"

namespace citykiln::verify {
namespace {

// The spacing of columns along a wall, and the distance from the wall at which the ground beside it is measured.
constexpr double kColumn_m = 2, kBesideWall_m = 0.25;
// Storeys are not lower than this; buildings whose storeys are have none.
constexpr double kLowestStorey_m = 2.1;
// Less is rounding, or the error of the ground.
constexpr double kLeastBlank_m2 = 1;

// The lower end and the storey of a building, and its openings for ways in plan, in which jambs and pillars stand.
struct Base {
  double bottom_m = 0, storey_m = 0;
  std::vector<Ring> openings{};

  bool is_in_opening(Vec2 p) const {
    return std::ranges::any_of(openings, [&](const Ring& ring) { return winding_number(ring, p) != 0; });
  }
};
using BasesOf = std::map<OsmId, std::vector<Base>>;

BasesOf bases_of(const scene::Chunk& chunk) {
  BasesOf bases;
  for (const buildings::Building& b : chunk.buildings) {
    if (!b.stands_on_ground) continue;
    Base& base = bases[b.id.osm].emplace_back(Base{b.bottom_m, std::max(kLowestStorey_m, buildings::storey_m(b))});
    for (const buildings::Passageway& opening : b.passageways)
      for (Ring& ring : buildings::opening_rings(opening)) base.openings.push_back(std::move(ring));
  }
  return bases;
}

// The elements under which the ground is a building's floor.
std::set<OsmId> covered_by_buildings(const scene::Chunk& chunk) {
  std::set<OsmId> ids;
  for (const buildings::Building& b : chunk.buildings) ids.insert(b.id.osm);
  for (const ground::LandCoverPolygon& surface : chunk.surfaces)
    if (surface.surface == map::LandCoverClass::kBuilding) ids.insert(surface.id.osm);
  return ids;
}

using Triangle3 = std::array<Vec3, 3>;

Triangle3 corners_of(const bake::BakedTile& tile, const bake::Primitive& primitive,
                     const std::array<std::uint32_t, 3>& triangle) {
  Triangle3 corners;
  for (std::size_t i = 0; i < 3; ++i) corners[i] = bake::widened(primitive.positions[triangle[i]]) + tile.origin;
  return corners;
}

// True for the elements that have windows, by index into the tile's features.
std::vector<bool> have_windows(const bake::BakedTile& tile) {
  std::vector<bool> have(tile.features.size());
  for (const bake::Primitive& p : tile.primitives) {
    const bool is_window = p.material == materials::Material::kGlass ||
                           p.material == materials::Material::kGlassFacade ||
                           p.colour_source == materials::ColourSource::kByAtlas;
    if (p.layer != bake::Layer::kBuildings || !is_window) continue;
    for (const std::uint32_t feature : p.features) have[feature] = true;
  }
  return have;
}

// Three corners over one line in plan: its ends, and the heights over it.
struct Upright {
  Vec2 from, to, out;  // `out` points away from the building, length 1
  Triangle3 corners;

  // The heights of the triangle over a place between the ends.
  std::pair<double, double> heights_at(double share) const {
    double low_m = 1e30, high_m = -1e30;
    const Vec2 along = to - from;
    const double at = share * dot(along, along);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 a = corners[i], b = corners[(i + 1) % 3];
      const double of_a = dot(in_plan(a) - from, along), of_b = dot(in_plan(b) - from, along);
      if (of_a == of_b || at < std::min(of_a, of_b) || at > std::max(of_a, of_b)) continue;
      const double z_m = a.z + (b.z - a.z) * (at - of_a) / (of_b - of_a);
      low_m = std::min(low_m, z_m), high_m = std::max(high_m, z_m);
    }
    return {low_m, high_m};
  }
};

// The triangle as part of a vertical wall; nothing for others.
std::optional<Upright> upright_of(const Triangle3& t) {
  const Vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
  const Vec2 out = in_plan(normal);
  const double size = length(out);
  if (size == 0 || std::abs(normal.z) > 1e-3 * size) return std::nullopt;
  const Vec2 along = left_of(out);
  const auto [from, to] =
      std::ranges::minmax_element(t, {}, [&](const Vec3& corner) { return dot(in_plan(corner), along); });
  return Upright{in_plan(*from), in_plan(*to), out * (1 / size), t};
}

const Base* base_at(const std::vector<Base>& bases, const Triangle3& t) {
  const double low_m = std::min({t[0].z, t[1].z, t[2].z});
  const auto found =
      std::ranges::find_if(bases, [&](const Base& base) { return std::abs(base.bottom_m - low_m) <= 2 * kQuantum_m; });
  return found == bases.end() ? nullptr : &*found;
}

// The bases of the features of a tile that are buildings with windows; null for others.
using BasesByFeature = std::vector<const std::vector<Base>*>;

BasesByFeature bases_by_feature(const BasesOf& bases, const bake::BakedTile& tile) {
  const std::vector<bool> windows = have_windows(tile);
  BasesByFeature by_feature(tile.features.size());
  for (std::size_t i = 0; i < tile.features.size(); ++i)
    if (const auto found = bases.find(tile.features[i]); found != bases.end() && windows[i])
      by_feature[i] = &found->second;
  return by_feature;
}

// Measures the triangles of one building after another.
struct BlankWallMeter {
  const GroundIndex& ground;
  const std::set<OsmId> covered;
  std::map<OsmId, BlankWall> walls{};
  std::map<OsmId, double> highest_m{};

  // The ground beside a wall; nothing if it is unknown, or another building stands there.
  std::optional<double> beside_m(Vec2 p, OsmId building) const {
    const std::vector<GroundHit> hits = ground_at(ground, p);
    if (hits.empty()) return std::nullopt;
    const OsmId feature = hits.back().feature;
    if (feature != building && covered.contains(feature)) return std::nullopt;
    return hits.back().z_m;
  }

  void measure(OsmId building, const Triangle3& corners, const std::vector<Base>& bases) {
    const Base* base = base_at(bases, corners);
    if (base == nullptr) return;
    if (const auto wall = upright_of(corners)) measure(building, *wall, *base);
  }

  void measure(OsmId building, const Upright& wall, const Base& base) {
    const double length_m = distance(wall.from, wall.to);
    const int columns = std::max(1, static_cast<int>(std::ceil(length_m / kColumn_m)));
    for (int k = 0; k < columns; ++k) {
      const double share = (k + 0.5) / columns;
      const Vec2 at = wall.from + (wall.to - wall.from) * share;
      const Vec2 beside = at + wall.out * kBesideWall_m;
      const auto ground_m = beside_m(beside, building);
      if (!ground_m || base.is_in_opening(beside)) continue;
      const auto [low_m, high_m] = wall.heights_at(share);
      const double above_m = high_m - std::max(low_m, *ground_m + base.storey_m);
      if (above_m > 0) add(building, at, above_m * length_m / columns, high_m - *ground_m);
    }
  }

  void add(OsmId building, Vec2 at, double area_m2, double height_m) {
    BlankWall& wall = walls.try_emplace(building, BlankWall{building, 0, at}).first->second;
    wall.area_m2 += area_m2;
    double& highest = highest_m[building];
    if (height_m > highest) highest = height_m, wall.at = at;
  }
};

}  // namespace

std::vector<BlankWall> measure_blank_walls(const scene::Chunk& chunk, const bake::BakedTile& tile,
                                           const GroundIndex& ground) {
  const BasesOf bases = bases_of(chunk);
  const BasesByFeature by_feature = bases_by_feature(bases, tile);
  BlankWallMeter meter{ground, covered_by_buildings(chunk)};
  for (const bake::Primitive& primitive : tile.primitives) {
    if (primitive.layer != bake::Layer::kBuildings) continue;
    for (const auto& triangle : primitive.triangles) {
      const std::uint32_t feature = primitive.features[triangle[0]];
      if (by_feature[feature] != nullptr)
        meter.measure(tile.features[feature], corners_of(tile, primitive, triangle), *by_feature[feature]);
    }
  }
  std::vector<BlankWall> walls;
  for (const auto& [building, wall] : meter.walls)
    if (wall.area_m2 >= kLeastBlank_m2) walls.push_back(wall);
  return walls;
}

}  // namespace citykiln::verify
