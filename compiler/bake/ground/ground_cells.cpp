#include "compiler/bake/ground/ground_cells.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "compiler/contract/system/for_each_slot.h"
#include "compiler/ground/plan.h"
#include "compiler/map/locate.h"

namespace citykiln::bake {
namespace {

using ground::kNoLandCover;
using ground::LandCoverPolygon;

// Surfaces are trimmed so far beyond a cell; a whole number keeps trimming independent of rounding.
constexpr double kCellHalo_m = 1;

// The surfaces near a cell, trimmed, and their indices among the tile's.
struct CellSurfaces {
  std::vector<LandCoverPolygon> surfaces;
  std::vector<std::uint32_t> numbers;
};

CellSurfaces surfaces_near(std::span<const LandCoverPolygon> surfaces, std::span<const std::uint32_t> candidates,
                           const Box2& cell) {
  CellSurfaces near;
  for (const std::uint32_t i : candidates) {
    LandCoverPolygon trimmed = ground::trimmed_to(surfaces[i], cell.widened(kCellHalo_m));
    if (trimmed.rings.empty()) continue;
    near.surfaces.push_back(std::move(trimmed));
    near.numbers.push_back(i);
  }
  return near;
}

// The indices of the surfaces whose boxes touch each cell.
using Candidates = std::vector<std::vector<std::uint32_t>>;

Candidates candidates_of(std::span<const LandCoverPolygon> surfaces, std::span<const Box2> cells) {
  Candidates candidates(cells.size());
  for (std::uint32_t i = 0; i < surfaces.size(); ++i) {
    Box2 box;
    for (const Ring& ring : surfaces[i].rings)
      for (const Vec2 p : ring) box.grow(p);
    for (std::size_t c = 0; c < cells.size(); ++c)
      if (box.touches(cells[c].widened(kCellHalo_m))) candidates[c].push_back(i);
  }
  return candidates;
}

struct GeneratedCell {
  ground::GroundMesh ground;
  Report report;
  std::shared_ptr<const ground::Reference> reference{};  // if it is kept
};

GeneratedCell generate(const ground::PreparedCell& prepared, ground::GradedNormals& normals, const CellLevel& level,
                       const CellSurfaces& near) {
  GeneratedCell cell;
  cell.ground = ground::generate_cell(prepared, normals, level.tolerance_m, level.sides_m, cell.report);
  for (std::uint32_t& surface : cell.ground.face_cover)
    if (surface != kNoLandCover) surface = near.numbers[surface];
  return cell;
}

// The surfaces of one level near a cell, and the first level with the same surfaces and graded terrain.
struct LevelInCell {
  CellSurfaces near;
  std::size_t source_level;
};

std::vector<LevelInCell> levels_in_cell(std::span<const GroundLevel> levels, std::span<const Candidates> candidates,
                                        std::size_t c, const Box2& cell) {
  std::vector<LevelInCell> all;
  for (std::size_t level = 0; level < levels.size(); ++level) {
    all.push_back({surfaces_near(levels[level].surfaces, candidates[level][c], cell), level});
    for (std::size_t before = 0; before < level && all.back().source_level == level; ++before)
      if (&levels[before].graded == &levels[level].graded && all[before].near.surfaces == all.back().near.surfaces)
        all.back().source_level = all[before].source_level;
  }
  return all;
}

void keep_reference(ground::Reference&& reference, std::size_t source, std::span<const LevelInCell> in_cell,
                    std::span<GeneratedCell> generated) {
  const auto kept = std::make_shared<const ground::Reference>(std::move(reference));
  for (std::size_t level = source; level < generated.size(); ++level)
    if (in_cell[level].source_level == source) generated[level].reference = kept;
}

// Generates a cell at all levels; those with one source level share what it prepares.
std::vector<GeneratedCell> generate_levels(std::span<const GroundLevel> levels, std::span<const LevelInCell> in_cell,
                                           const Box2& cell, bool keeps_references) {
  std::vector<GeneratedCell> generated(levels.size());
  for (std::size_t source = 0; source < levels.size(); ++source) {
    if (in_cell[source].source_level != source) continue;
    const ground::GradedTerrain& graded = levels[source].graded;
    ground::PreparedCell prepared = ground::prepare_cell(in_cell[source].near.surfaces, graded, cell);
    ground::GradedNormals normals(graded);
    for (std::size_t level = source; level < levels.size(); ++level)
      if (const double t = levels[level].tolerance_m; in_cell[level].source_level == source)
        generated[level] = generate(prepared, normals, {cell, t, ground::all_sides(t)}, in_cell[level].near);
    if (keeps_references) keep_reference(std::move(prepared.reference), source, in_cell, generated);
  }
  return generated;
}

}  // namespace

std::vector<Box2> cells_of(const Box2& tile) {
  assert(std::floor(tile.width() / map::kCell_m) * map::kCell_m == tile.width());
  std::vector<Box2> cells;
  for (double x = tile.min.x; x < tile.max.x; x += map::kCell_m)
    for (double y = tile.min.y; y < tile.max.y; y += map::kCell_m)
      cells.push_back({{x, y}, {x + map::kCell_m, y + map::kCell_m}});
  return cells;
}

std::vector<std::vector<ground::GroundMesh>> generate_cells(std::span<const GroundLevel> levels, const Box2& tile,
                                                            int threads, std::span<Report> reports,
                                                            std::span<CellReferences> references) {
  assert(reports.size() == levels.size() && (references.empty() || references.size() == levels.size()));
  const std::vector<Box2> cells = cells_of(tile);
  std::vector<Candidates> candidates;
  for (const GroundLevel& level : levels) candidates.push_back(candidates_of(level.surfaces, cells));
  auto slots = for_each_slot<std::vector<GeneratedCell>>(cells.size(), threads, [&](std::size_t c) {
    return generate_levels(levels, levels_in_cell(levels, candidates, c, cells[c]), cells[c], !references.empty());
  });
  std::vector<std::vector<ground::GroundMesh>> grounds(levels.size());
  for (std::vector<GeneratedCell>& slot : slots)
    for (std::size_t level = 0; level < levels.size(); ++level) {
      reports[level].append(slot[level].report);
      grounds[level].push_back(std::move(slot[level].ground));
      if (!references.empty()) references[level].push_back(std::move(slot[level].reference));
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
    const CellSurfaces near = surfaces_near(surfaces, candidates[c], boxes[c]);
    ground::GradedNormals normals(graded);
    return generate(ground::prepare_cell(near.surfaces, graded, boxes[c]), normals, cells[c], near);
  });
  std::vector<ground::GroundMesh> grounds;
  for (GeneratedCell& slot : slots) {
    report.append(slot.report);
    grounds.push_back(std::move(slot.ground));
  }
  return grounds;
}

}  // namespace citykiln::bake
