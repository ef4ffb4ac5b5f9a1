// Towns of boxes on level ground, for tests of blocks.
#pragma once

#include <vector>

#include "compiler/buildings/blocks/certified_blocks.h"
#include "tests/compiler/simplify/samples.h"

namespace citykiln::buildings {

inline Building box_building(std::int64_t id, Vec2 corner, double width_m, double depth_m, double height_m,
                             double bottom_m = 0) {
  const auto [x, y] = corner;
  Building b;
  b.id.osm = {OsmType::kWay, id};
  b.footprint.outer = {{x, y}, {x + width_m, y}, {x + width_m, y + depth_m}, {x, y + depth_m}};
  b.bottom_m = b.floor_m = bottom_m, b.top_m = bottom_m + height_m;
  return b;
}

/// Returns boxes at random places, some of which overlap, on a slope that rises towards the east.
inline std::vector<Building> random_town(std::uint64_t seed, std::size_t count, double rise = 0.1) {
  std::vector<Building> town;
  for (std::size_t i = 0; i < count; ++i) {
    const auto whole = [&](std::uint64_t k, double from, double to) {
      return std::floor(from + (to - from) * simplify::noise(seed * 65537 + i * 8 + k));
    };
    const double height_m = simplify::noise(seed + i * 8 + 7) < 0.1 ? whole(4, 40, 150) : whole(4, 3, 25);
    const Vec2 corner{whole(0, 0, 400), whole(1, 0, 400)};
    town.push_back(box_building(static_cast<std::int64_t>(i + 1), corner, whole(2, 6, 40), whole(3, 6, 30), height_m,
                                std::floor(corner.x * rise)));
  }
  return town;
}

inline std::vector<simplify::Corners> ground_below(double low_m = 0, double rise = 0.1) {
  const auto at = [&](double x, double y) { return Vec3{x, y, low_m + x * rise}; };
  return {{at(-500, -500), at(1000, -500), at(1000, 1000)}, {at(-500, -500), at(1000, 1000), at(-500, 1000)}};
}

inline std::vector<GeneratedBuilding> shapes_of(std::span<const Building> buildings, const Rulebook& rules,
                                                double tolerance_m, bool is_for_blocks = true) {
  std::vector<GeneratedBuilding> shapes;
  Report report;
  for (const Building& b : buildings)
    shapes.push_back(generate(b, rules, {.seed = 1, .is_for_blocks = is_for_blocks}, tolerance_m, report));
  return shapes;
}

inline void add(std::vector<simplify::Corners>& all, const Mesh& mesh) {
  const std::vector<simplify::Corners> more = simplify::corners_of(mesh);
  all.insert(all.end(), more.begin(), more.end());
}

inline void add(std::vector<simplify::Corners>& all, const GeneratedBuilding& shape) {
  for (const materials::MaterialMesh& part : shape.meshes) add(all, part.mesh);
}

/// Returns the roofs and walls of blocks, and the shapes of kept buildings.
inline std::vector<simplify::Corners> surface_of(const CertifiedBlocks& made,
                                                 std::span<const GeneratedBuilding> shapes) {
  std::vector<simplify::Corners> all;
  for (const Block& block : made.blocks) add(all, block.roof), add(all, block.walls);
  for (const std::uint32_t i : made.kept) add(all, shapes[i]);
  return all;
}

}  // namespace citykiln::buildings
