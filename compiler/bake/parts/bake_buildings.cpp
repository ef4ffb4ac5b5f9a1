#include "compiler/bake/parts/bake_buildings.h"

#include <array>
#include <cassert>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "compiler/bake/image_uvs.h"
#include "compiler/buildings/blocks/certified_blocks.h"
#include "compiler/contract/detail_tolerances.h"
#include "compiler/contract/system/for_each_slot.h"

namespace citykiln::bake {
namespace {

using buildings::Block;

BuildingMeshes shapes_of(const Baking& baking, const buildings::Rulebook& rulebook, int threads) {
  const std::vector<buildings::Building>& all = baking.chunk.buildings;
  const buildings::SceneContext context{.seed = baking.header.seed,
                                        .night = scene::night_of(baking.header),
                                        .is_for_blocks = true,
                                        .lit_share = baking.header.shown.lit_windows};
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

// Adds blocks to the tile, and their errors to its error. The walls and the roofs of a block have the material with
// the largest area on its buildings, and its mean colour. A block of one building has that building's feature, other
// blocks have none. Buildings of blocks that are left out are dropped, kBelowTolerance; others are counted as merged.
// @param level     A level of a whole tile, with its ground. Tiles for a viewpoint have no blocks.
// @param rulebook  The parsed rules of building styles.
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
  baking.tile.object_error_m = std::max(baking.tile.object_error_m, certified.error_m);
  report.account("bake", "building") = account;
}

// Generates buildings at several tolerances, in parallel; reports[i] gets the diagnoses of tolerance i in the order of
// buildings. Buildings that `holds` denies get no meshes.
std::vector<BuildingMeshes> generate_buildings(const scene::Header& header, const scene::Chunk& chunk,
                                               const PrototypeCache& shared, std::span<const double> tolerances_m,
                                               int threads, std::span<Report> reports,
                                               const std::function<bool(const buildings::Building&)>& holds) {
  assert(reports.size() == tolerances_m.size());
  const std::vector<buildings::Building>& all = chunk.buildings;
  const buildings::SceneContext context{.seed = header.seed,
                                        .night = scene::night_of(header),
                                        .pictures = &shared.element_pictures(),
                                        .lit_share = header.shown.lit_windows};
  std::vector<std::vector<Report>> diagnosed(all.size(), std::vector<Report>(tolerances_m.size()));
  std::vector<BuildingMeshes> by_building = for_each_slot<BuildingMeshes>(all.size(), threads, [&](std::size_t i) {
    if (!holds(all[i])) return BuildingMeshes(tolerances_m.size());
    return buildings::generate(all[i], shared.rulebook(), context, tolerances_m, diagnosed[i]);
  });
  std::vector<BuildingMeshes> by_level(tolerances_m.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t l = 0; l < tolerances_m.size(); ++l) {
      by_level[l].push_back(std::move(by_building[i][l]));
      reports[l].append(diagnosed[i][l]);
    }
  return by_level;
}

// Packs the facade textures into the tile's atlas, and adds the faces that show them to the buildings' meshes. Uvs are
// put on the image's grid (image_uvs.h) before their picture is: where that lies then does not decide how they round.
void put_on_atlas(Baking& baking, BuildingMeshes& buildings) {
  std::vector<impostor::SharedPicture> pictures;
  for (buildings::GeneratedBuilding& building : buildings)
    for (const buildings::TexturedFace& face : building.textured_faces) pictures.push_back(face.picture);
  const std::uint64_t budget = baking.part ? impostor::kMaxViewAtlasTexels : impostor::kMaxAtlasTexels;
  const double texel_m =
      has_detail(Detail::kFacadeElements, baking.tolerance_m) ? buildings::kElementTexel_m : baking.tolerance_m;
  impostor::AtlasLayout layout = impostor::lay_out_atlas(pictures, texel_m, budget);
  std::size_t picture = 0;
  for (buildings::GeneratedBuilding& building : buildings)
    for (buildings::TexturedFace& face : building.textured_faces) {
      for (Vec2& uv : face.mesh.uvs) uv = snapped_uv(uv, layout.atlas.colour) + layout.at_m[picture];
      building.meshes.push_back(std::move(face.mesh));
      ++picture;
    }
  baking.tile.facade_atlas = std::move(layout.atlas);
}

}  // namespace

void generate_textured_buildings(const scene::Header& header, const scene::Chunk& chunk, const PrototypeCache& shared,
                                 std::span<TileLevel> levels, int threads) {
  std::vector<TileLevel*> textured;
  std::vector<double> tolerances_m;
  for (TileLevel& level : levels)
    if (has_detail(Detail::kFacadeTextures, level.tolerance_m))
      textured.push_back(&level), tolerances_m.push_back(level.tolerance_m);
  if (textured.empty()) return;
  std::vector<Report> reports(textured.size());
  std::vector<BuildingMeshes> meshes =
      generate_buildings(header, chunk, shared, tolerances_m, threads, reports, [](const auto&) { return true; });
  for (std::size_t i = 0; i < textured.size(); ++i)
    textured[i]->buildings = std::move(meshes[i]), textured[i]->building_report = std::move(reports[i]);
}

void bake_buildings(Baking& baking, TileLevel& level, const PrototypeCache& shared, int threads, Report& report) {
  if (!baking.part && has_detail(Detail::kBlocks, baking.tolerance_m)) {
    bake_blocks(baking, level, shared.rulebook(), threads, report);
    return;
  }
  const std::vector<buildings::Building>& all = baking.chunk.buildings;
  if (!level.buildings)
    level.buildings =
        std::move(generate_buildings(baking.header, baking.chunk, shared, std::span(&baking.tolerance_m, 1), threads,
                                     std::span(&level.building_report, 1),
                                     [&](const auto& b) { return baking.holds(bounds_of(b)); })
                      .front());
  report.append(level.building_report);
  put_on_atlas(baking, *level.buildings);
  bake_each(
      baking, Layer::kBuildings, all, "building", report, [](const auto& b) { return bounds_of(b); },
      [&](const auto& b) { return std::move((*level.buildings)[static_cast<std::size_t>(&b - all.data())]); });
}

}  // namespace citykiln::bake
