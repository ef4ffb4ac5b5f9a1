#include "compiler/buildings/blocks/certified_blocks.h"

#include <algorithm>
#include <cassert>

#include "compiler/contract/tolerance.h"
#include "compiler/simplify/distance_bound.h"

namespace citykiln::buildings {
namespace {

using simplify::Corners;
using simplify::TriangleTree;

// Shapes use at most this share of the tolerance, and are no coarser than kCoarsestDefault_m.
constexpr double kShapeShare = 0.25;

// Shares of the tolerance: the precision of bounds, and the least distance that is measured.
constexpr double kPrecision = 0x1p-4, kLeast = 0.25;

void add(std::vector<Corners>& all, const Mesh& mesh) {
  const std::vector<Corners> more = simplify::corners_of(mesh);
  all.insert(all.end(), more.begin(), more.end());
}

std::vector<Corners> shape_triangles(const GeneratedBuilding& building) {
  std::vector<Corners> all;
  for (const materials::MaterialMesh& part : building.meshes) add(all, part.mesh);
  return all;
}

std::vector<Corners> shape_triangles(const Block& block) {
  std::vector<Corners> all;
  add(all, block.roof), add(all, block.walls);
  return all;
}

void append(std::vector<Corners>& all, const std::vector<Corners>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

// The shapes of all buildings, which all rounds use.
struct Shapes {
  std::vector<std::vector<Corners>> of_building;
  TriangleTree all;
  double error_m = 0;

  explicit Shapes(const BlockSources& sources) : all(joined(sources)) {
    for (const GeneratedBuilding& shape : sources.shapes) error_m = std::max(error_m, shape.error_m);
  }

 private:
  std::vector<Corners> joined(const BlockSources& sources) {
    std::vector<Corners> together;
    for (const GeneratedBuilding& shape : sources.shapes)
      append(together, of_building.emplace_back(shape_triangles(shape)));
    return together;
  }
};

// The bound of one block: both ways, for all of its buildings.
double bound_m(const Block& block, const Shapes& shapes, const TriangleTree& level, simplify::BoundOptions options) {
  for (const std::uint32_t i : block.members) {
    options.least_m = std::max(options.least_m, distance_bound_m(shapes.of_building[i], level, options));
    if (options.least_m > options.most_m) return options.least_m;
  }
  return distance_bound_m(shape_triangles(block), shapes.all, options);
}

TriangleTree level_of(const std::vector<Block>& blocks, std::span<const BlockRole> roles, const Shapes& shapes,
                      std::span<const Corners> ground) {
  std::vector<Corners> level(ground.begin(), ground.end());
  for (const Block& block : blocks) append(level, shape_triangles(block));
  for (std::size_t i = 0; i < roles.size(); ++i)
    if (roles[i] == BlockRole::kAbsent) append(level, shapes.of_building[i]);
  return TriangleTree(std::move(level));
}

BlockRole next_role(BlockRole role) { return role == BlockRole::kMerged ? BlockRole::kAlone : BlockRole::kAbsent; }

}  // namespace

double block_source_tolerance_m(double tolerance_m) { return std::min(kShapeShare * tolerance_m, kCoarsestDefault_m); }

CertifiedBlocks certified_blocks(const BlockSources& sources, double tolerance_m) {
  assert(sources.buildings.size() == sources.shapes.size());
  const Shapes shapes(sources);
  const simplify::BoundOptions options{
      .precision_m = kPrecision * tolerance_m, .least_m = kLeast * tolerance_m, .most_m = tolerance_m - shapes.error_m};
  std::vector<BlockRole> roles(sources.buildings.size(), BlockRole::kMerged);
  while (true) {
    CertifiedBlocks result{merge_buildings(sources.buildings, roles, tolerance_m), {}, shapes.error_m};
    const TriangleTree level = level_of(result.blocks, roles, shapes, sources.ground);
    bool are_all_near = true;
    for (const Block& block : result.blocks) {
      const double away_m = bound_m(block, shapes, level, options);
      result.error_m = std::max(result.error_m, away_m + shapes.error_m);
      if (away_m <= options.most_m) continue;
      are_all_near = false;
      for (const std::uint32_t i : block.members) roles[i] = next_role(roles[i]);
    }
    if (!are_all_near) continue;
    for (std::uint32_t i = 0; i < roles.size(); ++i)
      if (roles[i] == BlockRole::kAbsent) result.kept.push_back(i);
    return result;
  }
}

}  // namespace citykiln::buildings
