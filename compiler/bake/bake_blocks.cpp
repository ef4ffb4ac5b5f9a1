#include "compiler/bake/bake_blocks.h"

#include <array>
#include <cassert>
#include <cmath>
#include <map>
#include <utility>

#include "compiler/buildings/blocks/certified_blocks.h"
#include "compiler/contract/for_each_slot.h"

namespace citykiln::bake {
namespace {

using buildings::Block;

BuildingMeshes shapes_of(const Baking& baking, const buildings::Rulebook& rulebook, int threads) {
  const std::vector<buildings::Building>& all = baking.chunk.buildings;
  const buildings::SceneContext context{
      .seed = baking.header.seed, .night = scene::night_of(baking.header), .is_for_blocks = true};
  const double tolerance_m = buildings::block_source_tolerance_m(baking.tolerance_m);
  return for_each_slot<buildings::GeneratedBuilding>(all.size(), threads, [&](std::size_t i) {
    Report repeated;  // finer levels diagnose the same
    return buildings::generate(all[i], rulebook, context, tolerance_m, repeated);
  });
}

std::vector<simplify::Corners> ground_of(const TileLevel& level) {
  std::vector<simplify::Corners> all;
  for (const ground::GroundMesh& cell : level.cells) {
    const std::vector<simplify::Corners> more = simplify::corners_of(cell.mesh);
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

// The materials of surfaces with their areas, and the mean tint of each.
class Appearance {
 public:
  void add(const MaterialMesh& part, double area_m2) {
    Shown& shown = shown_[part.material];
    shown.area_m2 += area_m2;
    for (std::size_t c = 0; c < 4; ++c) shown.tint[c] += area_m2 * part.tint[c];
  }

  materials::SurfaceMaterial mean() const {
    materials::SurfaceMaterial mean;
    double most_m2 = 0;
    for (const auto& [material, shown] : shown_) {
      if (shown.area_m2 <= most_m2) continue;
      most_m2 = shown.area_m2, mean.material = material;
      for (std::size_t c = 0; c < 4; ++c)
        mean.tint[c] = static_cast<std::uint8_t>(std::floor(shown.tint[c] / shown.area_m2 + 0.5));
    }
    return mean;
  }

 private:
  struct Shown {
    double area_m2 = 0;
    std::array<double, 4> tint{};  // times area
  };
  std::map<materials::Material, Shown> shown_;
};

// Roofs are what faces up more than sideways.
struct BlockAppearance {
  Appearance walls, roofs;

  void add(const buildings::GeneratedBuilding& building) {
    for (const MaterialMesh& part : building.meshes)
      for (const auto& [a, b, c] : part.mesh.triangles) {
        const std::vector<Vec3>& at = part.mesh.positions;
        const Vec3 normal = cross(at[b] - at[a], at[c] - at[a]);
        if (normal.z < 0) continue;  // undersides
        (2 * normal.z * normal.z > dot(normal, normal) ? roofs : walls).add(part, length(normal) / 2);
      }
  }
};

void take(Baking& baking, Mesh&& mesh, const Appearance& appearance, OsmId feature) {
  if (mesh.triangles.empty()) return;
  const materials::SurfaceMaterial mean = appearance.mean();
  std::vector<MaterialMesh> meshes;
  meshes.push_back({std::move(mesh), mean.material, mean.tint, feature});
  baking.take(std::move(meshes), Layer::kBuildings);
}

void take(Baking& baking, Block&& block, const BuildingMeshes& shapes, Account& account, Report& report) {
  const std::vector<buildings::Building>& all = baking.chunk.buildings;
  if (block.roof.triangles.empty()) {
    for (const std::uint32_t i : block.members)
      report.drop(account, Code::kBelowTolerance, all[i].id.osm, all[i].top_m - all[i].bottom_m);
    return;
  }
  ++account.out, account.merged += block.members.size() - 1;
  BlockAppearance appearance;
  for (const std::uint32_t i : block.members) appearance.add(shapes[i]);
  const OsmId feature = block.members.size() == 1 ? all[block.members.front()].id.osm : OsmId{};
  take(baking, std::move(block.roof), appearance.roofs, feature);
  take(baking, std::move(block.walls), appearance.walls, feature);
}

}  // namespace

void bake_blocks(Baking& baking, const TileLevel& level, const buildings::Rulebook& rulebook, int threads,
                 Report& report) {
  assert(baking.part == nullptr);
  BuildingMeshes shapes = shapes_of(baking, rulebook, threads);
  const std::vector<simplify::Corners> ground = ground_of(level);
  buildings::CertifiedBlocks certified =
      buildings::certified_blocks({baking.chunk.buildings, shapes, ground}, baking.tolerance_m);
  Account account;
  account.in = baking.chunk.buildings.size(), account.out = certified.kept.size();
  for (Block& block : certified.blocks) take(baking, std::move(block), shapes, account, report);
  for (const std::uint32_t i : certified.kept) baking.take(std::move(shapes[i].meshes), Layer::kBuildings);
  baking.tile.error_m = std::max(baking.tile.error_m, certified.error_m);
  report.account("bake", "building") = account;
}

}  // namespace citykiln::bake
