#include "compiler/bake/ground_cells.h"

#include <algorithm>
#include <optional>

#include "compiler/contract/for_each_slot.h"
#include "compiler/ground/plan.h"
#include "compiler/map/locate.h"

namespace citykiln::bake {
namespace {

using ground::kNoLandCover;
using ground::LandCoverPolygon;

// What lies farther than this from a cell cannot touch it; a whole number keeps trimming independent of rounding.
constexpr double kCellReach_m = 1;

// The rings near a cell, and which surface of the tile each of the cell's surfaces is.
struct CellSurfaces {
  std::vector<LandCoverPolygon> surfaces;
  std::vector<std::uint32_t> numbers;
};

CellSurfaces surfaces_near(std::span<const LandCoverPolygon> surfaces, std::span<const std::uint32_t> candidates,
                           const Box2& cell) {
  CellSurfaces near;
  for (const std::uint32_t i : candidates) {
    LandCoverPolygon trimmed = ground::trimmed_to(surfaces[i], cell.widened(kCellReach_m));
    if (trimmed.rings.empty()) continue;
    near.surfaces.push_back(std::move(trimmed));
    near.numbers.push_back(i);
  }
  return near;
}

// The surfaces whose boxes touch each cell.
using Candidates = std::vector<std::vector<std::uint32_t>>;

Candidates candidates_of(std::span<const LandCoverPolygon> surfaces, std::span<const Box2> cells) {
  Candidates candidates(cells.size());
  for (std::uint32_t i = 0; i < surfaces.size(); ++i) {
    Box2 box;
    for (const Ring& ring : surfaces[i].rings)
      for (const Vec2 p : ring) box.grow(p);
    for (std::size_t c = 0; c < cells.size(); ++c)
      if (box.touches(cells[c].widened(kCellReach_m))) candidates[c].push_back(i);
  }
  return candidates;
}

struct GeneratedCell {
  ground::GroundMesh ground;
  Report report;
};

// What one level of a cell is made of, and which level before it, or itself, knows the cell for it.
struct LevelInCell {
  CellSurfaces near;
  std::size_t source_level;
};

std::vector<LevelInCell> cell_levels(std::span<const GroundLevel> levels, std::span<const Candidates> candidates,
                                     std::size_t c, const Box2& cell) {
  std::vector<LevelInCell> made;
  for (std::size_t level = 0; level < levels.size(); ++level) {
    made.push_back({surfaces_near(levels[level].surfaces, candidates[level][c], cell), level});
    for (std::size_t before = 0; before < level && made.back().source_level == level; ++before)
      if (&levels[before].graded == &levels[level].graded && made[before].near.surfaces == made.back().near.surfaces)
        made.back().source_level = made[before].source_level;
  }
  return made;
}

// The levels that one of them knows the cell for.
void generate_known(std::span<const GroundLevel> levels, std::span<const LevelInCell> made, std::size_t source_level,
                    const Box2& cell, std::vector<GeneratedCell>& expanded) {
  const ground::GradedTerrain& graded = levels[source_level].graded;
  const ground::PreparedCell known = ground::prepare_cell(made[source_level].near.surfaces, graded, cell);
  ground::GradedNormals normals(graded);
  for (std::size_t level = source_level; level < levels.size(); ++level) {
    if (made[level].source_level != source_level) continue;
    GeneratedCell& here = expanded[level];
    here.ground = ground::generate_cell(known, normals, levels[level].tolerance_m, here.report);
    for (std::uint32_t& surface : here.ground.face_cover)
      if (surface != kNoLandCover) surface = made[level].near.numbers[surface];
  }
}

std::vector<GeneratedCell> generate_ladder(std::span<const GroundLevel> levels, std::span<const Candidates> candidates,
                                           std::size_t c, const Box2& cell) {
  const std::vector<LevelInCell> made = cell_levels(levels, candidates, c, cell);
  std::vector<GeneratedCell> expanded(levels.size());
  for (std::size_t level = 0; level < levels.size(); ++level)
    if (made[level].source_level == level) generate_known(levels, made, level, cell, expanded);
  return expanded;
}

}  // namespace

std::vector<Box2> cells_of(const Box2& tile) {
  std::vector<Box2> cells;
  for (double x = tile.min.x; x < tile.max.x; x += map::kCell_m)
    for (double y = tile.min.y; y < tile.max.y; y += map::kCell_m)
      cells.push_back({{x, y}, {x + map::kCell_m, y + map::kCell_m}});
  return cells;
}

std::vector<std::vector<ground::GroundMesh>> generate_cells(std::span<const GroundLevel> levels, const Box2& tile,
                                                            int threads, std::span<Report> reports) {
  const std::vector<Box2> cells = cells_of(tile);
  std::vector<Candidates> candidates;
  for (const GroundLevel& level : levels) candidates.push_back(candidates_of(level.surfaces, cells));
  auto slots = for_each_slot<std::vector<GeneratedCell>>(
      cells.size(), threads, [&](std::size_t c) { return generate_ladder(levels, candidates, c, cells[c]); });
  std::vector<std::vector<ground::GroundMesh>> grounds(levels.size());
  for (std::vector<GeneratedCell>& slot : slots)
    for (std::size_t level = 0; level < levels.size(); ++level) {
      reports[level].append(slot[level].report);
      grounds[level].push_back(std::move(slot[level].ground));
    }
  return grounds;
}

std::vector<ground::GroundMesh> generate_cells(const ground::GradedTerrain& graded,
                                               std::span<const LandCoverPolygon> surfaces, const Box2& tile,
                                               double tolerance_m, int threads, Report& report) {
  const GroundLevel level{graded, surfaces, tolerance_m};
  return std::move(generate_cells(std::span(&level, 1), tile, threads, std::span(&report, 1)).front());
}

std::vector<ground::GroundMesh> generate_cells(const ground::GradedTerrain& graded,
                                               std::span<const LandCoverPolygon> surfaces,
                                               std::span<const CellLevel> cells, int threads, Report& report) {
  std::vector<Box2> boxes;
  for (const CellLevel& level : cells) boxes.push_back(level.cell);
  const auto candidates = candidates_of(surfaces, boxes);
  std::vector<GeneratedCell> slots = for_each_slot<GeneratedCell>(cells.size(), threads, [&](std::size_t c) {
    GeneratedCell slot;
    const auto& [cell, tolerance_m, sides_m] = cells[c];
    const CellSurfaces near = surfaces_near(surfaces, candidates[c], cell);
    ground::GradedNormals normals(graded);
    const ground::PreparedCell known = ground::prepare_cell(near.surfaces, graded, cell);
    slot.ground = ground::generate_cell(known, normals, tolerance_m, sides_m, slot.report);
    for (std::uint32_t& surface : slot.ground.face_cover)
      if (surface != kNoLandCover) surface = near.numbers[surface];
    return slot;
  });
  std::vector<ground::GroundMesh> grounds;
  for (GeneratedCell& slot : slots) {
    report.append(slot.report);
    grounds.push_back(std::move(slot.ground));
  }
  return grounds;
}

std::vector<ground::Reference> reference_cells(const ground::GradedTerrain& graded,
                                               std::span<const LandCoverPolygon> surfaces, const Box2& tile,
                                               int threads) {
  const std::vector<Box2> cells = cells_of(tile);
  const auto candidates = candidates_of(surfaces, cells);
  auto slots = for_each_slot<std::optional<ground::Reference>>(cells.size(), threads, [&](std::size_t c) {
    const CellSurfaces near = surfaces_near(surfaces, candidates[c], cells[c]);
    return std::optional(ground::reference_of_cell(near.surfaces, graded, cells[c]));
  });
  std::vector<ground::Reference> references;
  for (auto& slot : slots) references.push_back(std::move(*slot));
  return references;
}

}  // namespace citykiln::bake
