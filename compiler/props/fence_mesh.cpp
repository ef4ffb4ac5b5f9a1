#include "compiler/props/fence_mesh.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/snap.h"
#include "compiler/materials/texture.h"
#include "compiler/materials/texture_pattern.h"
#include "compiler/props/drape_line.h"

namespace citykiln::props {
namespace {

using materials::Material;

// The sheet follows the ground to this share of the tolerance, and so closely that no gap is seen below it.
constexpr double kSheetBendShare = 0.25, kMostSheetBend_m = 0.05;
// Depth of the foot below the ground; the bars begin above the lowest texels.
constexpr double kFenceFoot_m = 0.03;

// Tints of materials that are almost white: linear, 255 = 1. Dark paints of bars are more frequent. Boards are grey
// and brown as wood is after some years; the lightest is new.
constexpr materials::Tint kBarPaints[] = {{26, 27, 29, 255}, {26, 27, 29, 255},  {22, 38, 26, 255},
                                          {92, 64, 42, 255}, {120, 92, 66, 255}, {225, 224, 218, 255}};
constexpr materials::Tint kBoardTones[] = {{50, 45, 39, 255}, {57, 54, 49, 255}, {42, 35, 28, 255},
                                           {61, 49, 37, 255}, {38, 35, 32, 255}, {84, 62, 42, 255}};
constexpr materials::Tint kPicketPaints[] = {
    {236, 236, 232, 255}, {236, 236, 232, 255}, {220, 219, 212, 255}, {112, 92, 70, 255}};
constexpr materials::Tint kMeshPaints[] = {
    {190, 194, 196, 255}, {170, 174, 176, 255}, {190, 194, 196, 255}, {28, 58, 36, 255}};

// Where a sheet shows its texture, in metres of the texture.
struct SheetPart {
  double foot_m, top_m;
};

double on_grid(double v_m) {
  return std::floor(v_m / materials::kTextureCoordinateStep_m + 0.5) * materials::kTextureCoordinateStep_m;
}

// Bars are as high as their fence; other textures begin at the top.
SheetPart part_of(const Barrier& fence, Material material) {
  const double side_m = materials::texture_side_m(material);
  if (material == Material::kRailing)
    return {on_grid(materials::kRailingLow_px * side_m / 256), on_grid(materials::kRailingHigh_px * side_m / 256)};
  const double top_m = on_grid(materials::kFenceTop_px * side_m / 512);
  return {on_grid(top_m - fence.height_m - kFenceFoot_m), top_m};
}

// Adds the lower and the upper corner of the sheet at a point of its axis.
void add_corners(materials::MaterialMesh& sheet, Vec3 at, double along_m, double height_m, const SheetPart& part) {
  const double u = on_grid(along_m);
  sheet.mesh.positions.push_back(snapped(at_height(in_plan(at), at.z - kFenceFoot_m)));
  sheet.mesh.positions.push_back(snapped(at_height(in_plan(at), at.z + height_m)));
  sheet.uvs.push_back({u, part.foot_m});
  sheet.uvs.push_back({u, part.top_m});
}

}  // namespace

bool is_sheet(const Barrier& barrier, double tolerance_m) {
  return barrier.kind == map::BarrierKind::kFence && materials::has_texture(Material::kRailing, tolerance_m);
}

map::FenceKind kind_of_fence(const Barrier& fence) {
  if (fence.fence != map::FenceKind::kAny || fence.height_m <= kMaxRailingFence_m) return fence.fence;
  return fence.height_m >= kLeastWorksFence_m ? map::FenceKind::kMesh : map::FenceKind::kBoards;
}

materials::SurfaceMaterial fence_surface(const Barrier& fence) {
  const auto drawn = [&](Material material, std::span<const materials::Tint> paints) {
    const auto count = static_cast<std::uint32_t>(paints.size());
    return materials::SurfaceMaterial{material,
                                      paints[RandomSequence(0, stable_id(fence.id), "fence").below(count, 0)]};
  };
  switch (kind_of_fence(fence)) {
    case map::FenceKind::kBoards:
      return drawn(Material::kPalings, kBoardTones);
    case map::FenceKind::kPickets:
      return drawn(Material::kPickets, kPicketPaints);
    case map::FenceKind::kMesh:
      return drawn(Material::kChainLink, kMeshPaints);
    default:
      return drawn(Material::kRailing, kBarPaints);
  }
}

GeneratedProp fence_mesh(const Barrier& fence, const ground::GradedTerrain& ground, double tolerance_m) {
  if (fence.height_m <= tolerance_m) return {{}, fence.height_m};
  const double bend_m = std::min(kSheetBendShare * tolerance_m, kMostSheetBend_m);
  const std::vector<Vec3> line = without_small_bends(drape_line(fence.axis, ground), bend_m);
  if (line.size() < 2) return {};
  const materials::SurfaceMaterial surface = fence_surface(fence);
  const SheetPart part = part_of(fence, surface.material);
  materials::MaterialMesh sheet{{}, surface.material, surface.tint, fence.id.osm};
  double along_m = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i > 0) along_m += distance(in_plan(line[i - 1]), in_plan(line[i]));
    add_corners(sheet, line[i], along_m, fence.height_m, part);
  }
  const auto last = static_cast<std::uint32_t>(sheet.mesh.positions.size() - 2);
  for (std::uint32_t at = 0; at < last; at += 2) add_quad(sheet.mesh, at, at + 2, at + 3, at + 1);
  return {{std::move(sheet)}, bend_m};
}

}  // namespace citykiln::props
