#include "compiler/bake/tiles/simplify_tile.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "compiler/bake/tiles/weld.h"
#include "compiler/contract/disjoint_sets.h"
#include "compiler/simplify/decimate.h"
#include "compiler/simplify/distance_bound.h"

namespace citykiln::bake {
namespace {

using simplify::Corners;
using Index = std::uint32_t;
using FaceOf = std::array<Index, 3>;

Corners corners_of(const Primitive& p, const FaceOf& t) {
  return {widened(p.positions[t[0]]), widened(p.positions[t[1]]), widened(p.positions[t[2]])};
}

std::vector<Corners> corners_of(const BakedTile& tile, bool (*is_in)(const Primitive&)) {
  std::vector<Corners> all;
  for (const Primitive& p : tile.primitives)
    if (is_in(p))
      for (const FaceOf& t : p.triangles) all.push_back(corners_of(p, t));
  return all;
}

template <typename Goes>
void erase_triangles(Primitive& p, Goes goes) {
  std::vector<FaceOf> left;
  for (const FaceOf& t : p.triangles)
    if (!goes(t)) left.push_back(t);
  if (left.size() < p.triangles.size()) p = with_triangles(p, left);
}

void drop_empty(BakedTile& tile) {
  std::erase_if(tile.primitives, [](const Primitive& p) { return p.triangles.empty(); });
}

// Where a triangle lies in a line x = c: the line's place and the middle of its extent along it.
struct Standing {
  bool is_standing;
  double across_m, along_m;
};

Standing standing(const Corners& t, double Vec3::*across, double Vec3::*along) {
  const bool is_standing = t.a.*across == t.b.*across && t.b.*across == t.c.*across;
  const auto [low, high] = std::minmax({t.a.*along, t.b.*along, t.c.*along});
  return {is_standing, t.a.*across, (low + high) / 2};
}

bool is_multiple(double v, double of) { return std::floor(v / of) * of == v; }

bool is_on_border(const Box2& box, Vec2 p) {
  return p.x <= box.min.x || p.x >= box.max.x || p.y <= box.min.y || p.y >= box.max.y;
}

// Replaces terrain by its decimated triangles.
void write_back(BakedTile& tile, const WeldedPrimitives& terrain, const simplify::DecimatedMesh& decimated) {
  for (Index label = 0; label < tile.primitives.size(); ++label) {
    Primitive& p = tile.primitives[label];
    if (!is_terrain(p)) continue;
    p = decimated_primitive(p, terrain, label, decimated);
    std::ranges::fill(p.features, 0);
  }
  drop_empty(tile);
}

bool is_part(const Primitive& p) {
  return p.layer == Layer::kBuildings || p.layer == Layer::kStructures || p.layer == Layer::kProps;
}

// The part of each position: parts are connected sets of triangles of all primitives but terrain and plants.
struct Parts {
  PositionNumbers places;
  DisjointSets sets;

  explicit Parts(const BakedTile& tile) {
    for (const Primitive& p : tile.primitives)
      if (is_part(p))
        for (const FaceOf& t : p.triangles)
          for (std::size_t i = 1; i < 3; ++i) sets.join(number(p.positions[t[0]]), number(p.positions[t[i]]));
  }
  Index part_at(const Float3& p) { return sets.find(places.of(p)); }

 private:
  Index number(const Float3& p) {
    const Index i = places.of(p);
    if (i == sets.size()) sets.add();
    return i;
  }
};

// A bound of the height of instanced plants: of their mesh, times the scale.
double height_bound_m(const InstancedMesh& plants) {
  float highest = 0, largest = 0;
  for (const Primitive& p : plants.primitives)
    for (const Float3& at : p.positions) highest = std::max(highest, at[2]);
  for (const float scale : plants.scales) largest = std::max(largest, scale);
  return double{highest} * largest;
}

void drop_plants(BakedTile& tile, const simplify::TriangleTree& terrain) {
  const auto is_plant = [](const Primitive& p) { return p.layer == Layer::kPlants; };
  const std::vector<Corners> canopies = corners_of(tile, is_plant);
  constexpr double kPrecision_m = 1;
  tile.plant_error_m = std::max(tile.plant_error_m, distance_bound_m(canopies, terrain, {.precision_m = kPrecision_m}));
  const auto are_plants = [](const InstancedMesh& mesh) { return layer_of(mesh) == Layer::kPlants; };
  for (const InstancedMesh& mesh : tile.instanced)
    if (are_plants(mesh)) tile.plant_error_m = std::max(tile.plant_error_m, height_bound_m(mesh));
  std::erase_if(tile.primitives, is_plant);
  std::erase_if(tile.instanced, are_plants);
}

// The triangles of one copy of a mesh.
std::vector<Corners> corners_of(const InstancedMesh& mesh, std::size_t copy) {
  const Float4& turn = mesh.rotations[copy];
  const Vec3 axis{turn[0], turn[1], turn[2]}, at = widened(mesh.translations[copy]);
  const auto placed = [&](Vec3 p) {
    p = p * mesh.scales[copy];
    return at + p + cross(axis, cross(axis, p) + p * turn[3]) * 2;
  };
  std::vector<Corners> all;
  for (const Primitive& p : mesh.primitives)
    for (const FaceOf& t : p.triangles) {
      const Corners c = corners_of(p, t);
      all.push_back({placed(c.a), placed(c.b), placed(c.c)});
    }
  return all;
}

template <typename Value>
void keep_copies(std::vector<Value>& values, const std::vector<bool>& is_kept) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (is_kept[i]) values[kept++] = values[i];
  values.resize(kept);
}

// Removes lamps and things within the tolerance of the terrain. Returns the largest of their distances.
double drop_near_copies(BakedTile& tile, const simplify::TriangleTree& terrain, const simplify::BoundOptions& options) {
  double farthest_m = 0;
  for (InstancedMesh& mesh : tile.instanced) {
    std::vector<bool> is_kept(mesh.translations.size());
    for (std::size_t i = 0; i < is_kept.size(); ++i) {
      const double away_m = distance_bound_m(corners_of(mesh, i), terrain, options);
      is_kept[i] = away_m > options.most_m;
      if (!is_kept[i]) farthest_m = std::max(farthest_m, away_m);
    }
    keep_copies(mesh.translations, is_kept), keep_copies(mesh.rotations, is_kept);
    keep_copies(mesh.scales, is_kept), keep_copies(mesh.features, is_kept);
  }
  std::erase_if(tile.instanced, [](const InstancedMesh& mesh) { return mesh.translations.empty(); });
  return farthest_m;
}

}  // namespace

void remove_inner_skirts(BakedTile& joined, const std::set<scene::TileKey>& tiles, double tile_m) {
  const auto is_between = [&](const Standing& at, double across_m, double along_m, bool is_east) {
    const double line = at.across_m + across_m;
    if (!at.is_standing || !is_multiple(line, tile_m)) return false;
    const auto beyond = static_cast<std::int32_t>(line / tile_m);
    const auto along = static_cast<std::int32_t>(std::floor((at.along_m + along_m) / tile_m));
    const auto key = [&](std::int32_t i) { return is_east ? scene::TileKey{i, along} : scene::TileKey{along, i}; };
    return tiles.contains(key(beyond - 1)) && tiles.contains(key(beyond));
  };
  for (Primitive& p : joined.primitives) {
    if (!is_terrain(p)) continue;
    erase_triangles(p, [&](const FaceOf& t) {
      const Corners c = corners_of(p, t);
      return is_between(standing(c, &Vec3::x, &Vec3::y), joined.origin.x, joined.origin.y, true) ||
             is_between(standing(c, &Vec3::y, &Vec3::x), joined.origin.y, joined.origin.x, false);
    });
  }
  drop_empty(joined);
}

void simplify_terrain(BakedTile& joined, const Box2& square, double tolerance_m) {
  WeldedPrimitives terrain = welded(joined.primitives, is_terrain);
  if (terrain.mesh.triangles.empty()) return;
  for (std::size_t i = 0; i < terrain.mesh.positions.size(); ++i)
    if (is_on_border(square, in_plan(joined.origin + terrain.mesh.positions[i]))) terrain.mesh.is_locked[i] = true;
  const simplify::DecimatedMesh decimated = simplify::decimated(terrain.mesh, tolerance_m);
  write_back(joined, terrain, decimated);
  joined.error_m += decimated.error_m;
}

void drop_near_terrain(BakedTile& joined, double tolerance_m) {
  const simplify::TriangleTree terrain(corners_of(joined, is_terrain));
  drop_plants(joined, terrain);
  Parts parts(joined);
  std::map<Index, std::vector<Corners>> by_part;
  for (const Primitive& p : joined.primitives)
    if (is_part(p))
      for (const FaceOf& t : p.triangles) by_part[parts.part_at(p.positions[t[0]])].push_back(corners_of(p, t));
  constexpr double kPrecision = 0x1p-5;
  const simplify::BoundOptions options{.precision_m = kPrecision * tolerance_m, .most_m = tolerance_m};
  double farthest_m = drop_near_copies(joined, terrain, options);
  std::set<Index> near;
  for (const auto& [part, triangles] : by_part) {
    const double away_m = distance_bound_m(triangles, terrain, options);
    if (away_m > tolerance_m) continue;
    near.insert(part), farthest_m = std::max(farthest_m, away_m);
  }
  for (Primitive& p : joined.primitives)
    if (is_part(p))
      erase_triangles(p, [&](const FaceOf& t) { return near.contains(parts.part_at(p.positions[t[0]])); });
  drop_empty(joined);
  joined.error_m += farthest_m;
  joined.object_error_m = joined.error_m;
}

void drop_unused_features(BakedTile& tile) {
  std::vector<bool> is_used(tile.features.size(), false);
  is_used[0] = true;
  for (const Primitive& p : tile.primitives)
    for (const Index f : p.features) is_used[f] = true;
  for (const InstancedMesh& i : tile.instanced)
    for (const Index f : i.features) is_used[f] = true;

  std::vector<Index> moved(tile.features.size(), 0);
  Index count = 0;
  for (Index f = 0; f < is_used.size(); ++f) {
    if (!is_used[f]) continue;
    tile.features[count] = tile.features[f];
    if (!tile.attributes.empty()) tile.attributes[count] = std::move(tile.attributes[f]);
    moved[f] = count++;
  }
  tile.features.resize(count);
  if (!tile.attributes.empty()) tile.attributes.resize(count);
  for (Primitive& p : tile.primitives)
    for (Index& f : p.features) f = moved[f];
  for (InstancedMesh& i : tile.instanced)
    for (Index& f : i.features) f = moved[f];
}

}  // namespace citykiln::bake
