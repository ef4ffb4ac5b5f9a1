#include "compiler/bake/fire_ground.h"

#include <algorithm>
#include <optional>

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

}  // namespace

std::vector<Box2> cells_of(const Box2& tile) {
  std::vector<Box2> cells;
  for (double x = tile.min.x; x < tile.max.x; x += map::kCell_m)
    for (double y = tile.min.y; y < tile.max.y; y += map::kCell_m)
      cells.push_back({{x, y}, {x + map::kCell_m, y + map::kCell_m}});
  return cells;
}

std::vector<ground::GroundMesh> expand_cells(const ground::Carving& carving, std::span<const Surface> surfaces,
                                             const Box2& tile, double tolerance_m, int threads, Report& report) {
  std::vector<CellLevel> cells;
  for (const Box2& cell : cells_of(tile)) cells.push_back({cell, tolerance_m, ground::all_sides(tolerance_m)});
  return expand_cells(carving, surfaces, cells, threads, report);
}

std::vector<ground::GroundMesh> expand_cells(const ground::Carving& carving, std::span<const Surface> surfaces,
                                             std::span<const CellLevel> cells, int threads, Report& report) {
  struct Slot {
    ground::GroundMesh ground;
    Report report;
  };
  std::vector<Box2> boxes;
  for (const CellLevel& level : cells) boxes.push_back(level.cell);
  const auto candidates = candidates_of(surfaces, boxes);
  std::vector<Slot> slots = for_each_slot<Slot>(cells.size(), threads, [&](std::size_t c) {
    Slot slot;
    const auto& [cell, tolerance_m, sides_m] = cells[c];
    const CellSurfaces near = surfaces_near(surfaces, candidates[c], cell);
    slot.ground = ground::expand_cell(near.surfaces, carving, cell, tolerance_m, sides_m, slot.report);
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

std::vector<ground::Reference> reference_cells(const ground::Carving& carving, std::span<const Surface> surfaces,
                                               const Box2& tile, int threads) {
  const std::vector<Box2> cells = cells_of(tile);
  const auto candidates = candidates_of(surfaces, cells);
  auto slots = for_each_slot<std::optional<ground::Reference>>(cells.size(), threads, [&](std::size_t c) {
    const CellSurfaces near = surfaces_near(surfaces, candidates[c], cells[c]);
    return std::optional(ground::reference_of_cell(near.surfaces, carving, cells[c]));
  });
  std::vector<ground::Reference> references;
  for (auto& slot : slots) references.push_back(std::move(*slot));
  return references;
}

}  // namespace citykiln::bake
