#include "compiler/bake/bake_buildings.h"

#include <cassert>
#include <functional>
#include <utility>

#include "compiler/bake/bake_blocks.h"
#include "compiler/bake/image_uvs.h"
#include "compiler/contract/detail_tolerances.h"
#include "compiler/contract/for_each_slot.h"

namespace citykiln::bake {
namespace {

// Generates buildings at several tolerances, in parallel; reports[i] gets the diagnoses of tolerance i in the order of
// buildings. Buildings that `holds` denies get no meshes.
std::vector<BuildingMeshes> generate_buildings(const scene::Header& header, const scene::Chunk& chunk,
                                               const buildings::Rulebook& rulebook,
                                               std::span<const double> tolerances_m, int threads,
                                               std::span<Report> reports,
                                               const std::function<bool(const buildings::Building&)>& holds) {
  assert(reports.size() == tolerances_m.size());
  const std::vector<buildings::Building>& all = chunk.buildings;
  const buildings::SceneContext context{header.seed, scene::night_of(header)};
  std::vector<std::vector<Report>> diagnosed(all.size(), std::vector<Report>(tolerances_m.size()));
  std::vector<BuildingMeshes> by_building = for_each_slot<BuildingMeshes>(all.size(), threads, [&](std::size_t i) {
    if (!holds(all[i])) return BuildingMeshes(tolerances_m.size());
    return buildings::generate(all[i], rulebook, context, tolerances_m, diagnosed[i]);
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
  std::vector<impostor::Picture> pictures;
  for (buildings::GeneratedBuilding& building : buildings)
    for (buildings::TexturedFace& face : building.textured_faces) pictures.push_back(std::move(face.picture));
  const std::uint64_t budget = baking.part ? impostor::kMaxViewAtlasTexels : impostor::kMaxAtlasTexels;
  impostor::AtlasLayout layout = impostor::lay_out_atlas(pictures, baking.tolerance_m, budget);
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

void generate_textured_buildings(const scene::Header& header, const scene::Chunk& chunk,
                                 const buildings::Rulebook& rulebook, std::span<TileLevel> levels, int threads) {
  std::vector<TileLevel*> textured;
  std::vector<double> tolerances_m;
  for (TileLevel& level : levels)
    if (has_detail(Detail::kFacadeTextures, level.tolerance_m))
      textured.push_back(&level), tolerances_m.push_back(level.tolerance_m);
  if (textured.empty()) return;
  std::vector<Report> reports(textured.size());
  std::vector<BuildingMeshes> meshes =
      generate_buildings(header, chunk, rulebook, tolerances_m, threads, reports, [](const auto&) { return true; });
  for (std::size_t i = 0; i < textured.size(); ++i)
    textured[i]->buildings = std::move(meshes[i]), textured[i]->building_report = std::move(reports[i]);
}

void bake_buildings(Baking& baking, TileLevel& level, const buildings::Rulebook& rulebook, int threads,
                    Report& report) {
  if (!baking.part && has_detail(Detail::kBlocks, baking.tolerance_m)) {
    bake_blocks(baking, level, rulebook, threads, report);
    return;
  }
  const std::vector<buildings::Building>& all = baking.chunk.buildings;
  if (!level.buildings)
    level.buildings =
        std::move(generate_buildings(baking.header, baking.chunk, rulebook, std::span(&baking.tolerance_m, 1), threads,
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
