#include "compiler/bake/fire_ground.h"

#include <algorithm>

#include "compiler/contract/draw.h"
#include "compiler/contract/for_each_slot.h"
#include "compiler/ground/plan.h"
#include "compiler/map/locate.h"

namespace citykiln::bake {
namespace {

using ground::kNoSurface;
using ground::Surface;

// What lies farther than this from a cell cannot touch it; a whole number keeps trimming independent of rounding.
constexpr double kCellReach_m = 1;

// The rings near a cell, and which surface of the tile each of the cell's surfaces is.
struct CellSurfaces {
  std::vector<Surface> surfaces;
  std::vector<std::uint32_t> numbers;
};

CellSurfaces surfaces_near(std::span<const Surface> surfaces, std::span<const std::uint32_t> candidates,
                           const Box2& cell) {
  CellSurfaces near;
  for (const std::uint32_t i : candidates) {
    Surface trimmed = ground::trimmed_to(surfaces[i], cell.widened(kCellReach_m));
    if (trimmed.rings.empty()) continue;
    near.surfaces.push_back(std::move(trimmed));
    near.numbers.push_back(i);
  }
  return near;
}

// The surfaces whose boxes touch each cell.
std::vector<std::vector<std::uint32_t>> candidates_of(std::span<const Surface> surfaces, std::span<const Box2> cells) {
  std::vector<std::vector<std::uint32_t>> candidates(cells.size());
  for (std::uint32_t i = 0; i < surfaces.size(); ++i) {
    Box2 box;
    for (const Ring& ring : surfaces[i].rings)
      for (const Vec2 p : ring) box.grow(p);
    for (std::size_t c = 0; c < cells.size(); ++c)
      if (box.touches(cells[c].widened(kCellReach_m))) candidates[c].push_back(i);
  }
  return candidates;
}

// Brightness drawn for a surface, within its material's variation.
materials::Tint tint_of(const Surface& surface, materials::Material material, std::uint64_t seed) {
  const double darker = values_of(material).variation * Draw(seed, stable_id(surface.id), "ground tint").unit(0);
  const auto level = static_cast<std::uint8_t>(255 * (1 - darker) + 0.5);
  return {level, level, level, 255};
}

}  // namespace

std::vector<Box2> cells_of(const Box2& tile) {
  std::vector<Box2> cells;
  for (double x = tile.min.x; x < tile.max.x; x += map::kCell_m)
    for (double y = tile.min.y; y < tile.max.y; y += map::kCell_m)
      cells.push_back({{x, y}, {x + map::kCell_m, y + map::kCell_m}});
  return cells;
}

std::vector<ground::GroundMesh> expand_cells(const scene::Chunk& chunk, std::span<const Surface> surfaces,
                                             const Box2& tile, double tolerance_m, int threads, Report& report) {
  struct Slot {
    ground::GroundMesh ground;
    Report report;
  };
  const std::vector<Box2> cells = cells_of(tile);
  const auto candidates = candidates_of(surfaces, cells);
  std::vector<Slot> slots = for_each_slot<Slot>(cells.size(), threads, [&](std::size_t c) {
    Slot slot;
    const CellSurfaces near = surfaces_near(surfaces, candidates[c], cells[c]);
    slot.ground = ground::expand_cell(near.surfaces, chunk.heights, cells[c], tolerance_m, slot.report);
    for (std::uint32_t& surface : slot.ground.face_surface)
      if (surface != kNoSurface) surface = near.numbers[surface];
    return slot;
  });
  std::vector<ground::GroundMesh> grounds;
  for (Slot& slot : slots) {
    report.append(slot.report);
    grounds.push_back(std::move(slot.ground));
  }
  return grounds;
}

std::vector<materials::DressedMesh> dress(const ground::GroundMesh& ground, std::span<const Surface> surfaces,
                                          std::uint64_t seed) {
  // faces by surface, each surface a mesh over its own vertices
  std::vector<std::uint32_t> order(ground.face_surface.size());
  for (std::uint32_t f = 0; f < order.size(); ++f) order[f] = f;
  std::stable_sort(order.begin(), order.end(),
                   [&](auto f, auto g) { return ground.face_surface[f] < ground.face_surface[g]; });
  std::vector<std::uint32_t> place(ground.mesh.positions.size()), whose(ground.mesh.positions.size(), kNoSurface - 1);
  std::vector<materials::DressedMesh> dressed;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::uint32_t number = ground.face_surface[order[i]];
    if (i == 0 || ground.face_surface[order[i - 1]] != number) {
      materials::DressedMesh& mesh = dressed.emplace_back();
      const map::SurfaceClass surface = number == kNoSurface ? map::SurfaceClass::kUnknown : surfaces[number].surface;
      mesh.material = values_of(surface).material;
      if (number != kNoSurface)
        mesh.tint = tint_of(surfaces[number], mesh.material, seed), mesh.feature = surfaces[number].id.osm;
    }
    Mesh& mesh = dressed.back().mesh;
    Triangle triangle = ground.mesh.triangles[order[i]];
    for (std::uint32_t& v : triangle) {
      if (whose[v] != number) {
        whose[v] = number;
        place[v] = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.push_back(ground.mesh.positions[v]);
        mesh.normals.push_back(ground.mesh.normals[v]);
      }
      v = place[v];
    }
    mesh.triangles.push_back(triangle);
  }
  return dressed;
}

}  // namespace citykiln::bake
