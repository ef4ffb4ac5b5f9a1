#include "compiler/bake/parts/stands.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <functional>
#include <set>
#include <utility>

#include "compiler/bake/merge.h"
#include "compiler/bake/parts/bake_instances.h"

namespace citykiln::bake {
namespace {

// The elements with the most plants, so many that the others have at most `most`; none with few plants, and no roads,
// whose trees stand singly and are seen from below.
std::set<OsmId> elements_to_take(const plants::PlacedPlants& placed, std::span<const roads::Road> roads,
                                 std::size_t most) {
  std::set<OsmId> lined;
  for (const roads::Road& road : roads) lined.insert(road.id.osm);
  std::map<OsmId, std::size_t> plants_of;
  std::size_t left = 0;
  for (const auto& [prototype, placements] : placed)
    for (const Placement& p : placements) ++plants_of[p.feature], ++left;
  std::vector<std::pair<std::size_t, OsmId>> largest;
  for (const auto& [element, count] : plants_of)
    if (count > kMostLoosePlants && !lined.contains(element)) largest.emplace_back(count, element);
  std::ranges::sort(largest, std::greater());
  std::set<OsmId> taken;
  for (const auto& [count, element] : largest) {
    if (left <= most) break;
    left -= count, taken.insert(element);
  }
  return taken;
}

// Squares of a tile.
struct WoodSquares {
  Box2 tile;
  std::set<std::pair<std::int64_t, std::int64_t>> filled;
};

std::pair<std::int64_t, std::int64_t> square_at(Vec2 p) {
  return {static_cast<std::int64_t>(std::floor(p.x / kWoodSquare_m)),
          static_cast<std::int64_t>(std::floor(p.y / kWoodSquare_m))};
}

// The squares with plants through which no road leads.
WoodSquares squares_of(const plants::PlacedPlants& placed, const std::set<OsmId>& taken,
                       const StandSurroundings& around) {
  WoodSquares squares{around.tile, {}};
  for (const auto& [prototype, placements] : placed)
    for (const Placement& p : placements)
      if (taken.contains(p.feature)) squares.filled.insert(square_at(in_plan(p.at)));
  for (const roads::Road& road : around.roads)
    for (std::size_t i = 0; i + 1 < road.axis.size(); ++i) {
      const int steps = 1 + static_cast<int>(distance(road.axis[i], road.axis[i + 1]) / (kWoodSquare_m / 4));
      for (int k = 0; k <= steps; ++k)
        squares.filled.erase(square_at(road.axis[i] + (road.axis[i + 1] - road.axis[i]) * (1.0 * k / steps)));
    }
  return squares;
}

bool is_inside(const WoodSquares& squares, Vec2 p) {
  constexpr int kRings = 1;
  for (int i = -kRings; i <= kRings; ++i)
    for (int j = -kRings; j <= kRings; ++j) {
      const Vec2 other = p + Vec2{i * kWoodSquare_m, j * kWoodSquare_m};
      if (squares.tile.contains(other) && !squares.filled.contains(square_at(other))) return false;
    }
  return true;
}

Vec3 turned_by_yaw(const Placement& p, Vec3 v) {
  return {p.cos_yaw * v.x - p.sin_yaw * v.y, p.sin_yaw * v.x + p.cos_yaw * v.y, v.z};
}

Float3 in_single_precision(Vec3 v) { return offset_from({}, v); }

// Adds a copy of a primitive at a place relative to `at`.
void add_plant(Primitive& to, const Primitive& from, double height_m, const Placement& p, Vec3 at) {
  const auto first = static_cast<std::uint32_t>(to.positions.size());
  const double scale = p.scale / height_m;
  for (const Float3& v : from.positions)
    to.positions.push_back(in_single_precision(turned_by_yaw(p, widened(v) * scale) + (p.at - at)));
  for (const Float3& n : from.normals) to.normals.push_back(in_single_precision(turned_by_yaw(p, widened(n))));
  to.colours.insert(to.colours.end(), from.colours.begin(), from.colours.end());
  to.uvs.insert(to.uvs.end(), from.uvs.begin(), from.uvs.end());
  for (const auto& t : from.triangles) to.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

}  // namespace

double stand_tolerance_m(const plants::SpeciesValues& species, double tolerance_m, bool is_inner) {
  return std::max(tolerance_m, (is_inner ? kInnerTolerance : kEdgeTolerance) * species.tallest_m);
}

Stands take_stands(plants::PlacedPlants& placed, const StandSurroundings& around, double tolerance_m, std::size_t most,
                   const plants::SpeciesTable& table) {
  const std::set<OsmId> taken = elements_to_take(placed, around.roads, most);
  const WoodSquares squares = squares_of(placed, taken, around);
  Stands stands;
  for (auto& [prototype, placements] : placed) {
    const auto is_kept = [&](const Placement& p) { return !taken.contains(p.feature); };
    const auto rest = std::stable_partition(placements.begin(), placements.end(), is_kept);
    const plants::SpeciesValues& species = table[prototype.species];
    const plants::Prototype at_edge = merged_variant(prototype, stand_tolerance_m(species, tolerance_m, false)),
                            inside = merged_variant(prototype, stand_tolerance_m(species, tolerance_m, true));
    for (auto p = rest; p != placements.end(); ++p) {
      const bool is_inner = is_inside(squares, in_plan(p->at));
      stands[{p->feature, is_inner ? inside : at_edge, is_inner}].push_back(*p);
    }
    placements.erase(rest, placements.end());
  }
  return stands;
}

InstancedMesh stand_mesh(const BakedPrototype& prototype, double height_m, const std::vector<Placement>& plants,
                         Vec3 origin, std::uint32_t feature) {
  assert(!plants.empty());
  const Vec3 at = plants.front().at;
  InstancedMesh stand{.name = {},
                      .primitives = {},
                      .translations = {offset_from(origin, at)},
                      .rotations = {{0, 0, 0, 1}},
                      .scales = {1},
                      .features = {feature},
                      .cutout = prototype.cutout};
  for (const Primitive& like : prototype.primitives) {
    Primitive& all = stand.primitives.emplace_back();
    all.material = like.material, all.colour_source = like.colour_source, all.layer = like.layer;
    for (const Placement& p : plants) add_plant(all, like, height_m, p, at);
  }
  return stand;
}

}  // namespace citykiln::bake
