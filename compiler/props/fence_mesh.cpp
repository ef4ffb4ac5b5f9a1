#include "compiler/props/fence_mesh.h"

#include <algorithm>
#include <cmath>
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

// Linear, 255 = 1; the material is almost white. Dark paints are more frequent.
constexpr materials::Tint kPaints[] = {{26, 27, 29, 255}, {26, 27, 29, 255},  {22, 38, 26, 255},
                                       {92, 64, 42, 255}, {120, 92, 66, 255}, {225, 224, 218, 255}};

double on_texture(double px) {
  const double texel_m = materials::texture_side_m(Material::kRailing) / 256;
  return std::floor(px * texel_m / materials::kTextureCoordinateStep_m + 0.5) * materials::kTextureCoordinateStep_m;
}

// Adds the lower and the upper corner of the sheet at a point of its axis.
void add_corners(materials::MaterialMesh& sheet, Vec3 at, double along_m, double height_m) {
  const double u =
      std::floor(along_m / materials::kTextureCoordinateStep_m + 0.5) * materials::kTextureCoordinateStep_m;
  sheet.mesh.positions.push_back(snapped(at_height(in_plan(at), at.z - kFenceFoot_m)));
  sheet.mesh.positions.push_back(snapped(at_height(in_plan(at), at.z + height_m)));
  sheet.uvs.push_back({u, on_texture(materials::kRailingLow_px)});
  sheet.uvs.push_back({u, on_texture(materials::kRailingHigh_px)});
}

}  // namespace

bool is_barred(const Barrier& barrier, double tolerance_m) {
  return barrier.kind == map::BarrierKind::kFence && 
         (barrier.height_m <= kMaxRailingFence_m || barrier.height_m >= kLeastWorksFence_m) &&
         materials::has_texture(Material::kRailing, tolerance_m);
}

materials::Tint fence_paint(ObjectId id) {
  return kPaints[RandomSequence(0, stable_id(id), "fence").below(std::size(kPaints), 0)];
}

GeneratedProp fence_mesh(const Barrier& fence, const ground::GradedTerrain& ground, double tolerance_m) {
  if (fence.height_m <= tolerance_m) return {{}, fence.height_m};
  const double bend_m = std::min(kSheetBendShare * tolerance_m, kMostSheetBend_m);
  const std::vector<Vec3> line = without_small_bends(drape_line(fence.axis, ground), bend_m);
  if (line.size() < 2) return {};
  materials::MaterialMesh sheet{{}, Material::kRailing, fence_paint(fence.id), fence.id.osm};
  double along_m = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i > 0) along_m += distance(in_plan(line[i - 1]), in_plan(line[i]));
    add_corners(sheet, line[i], along_m, fence.height_m);
  }
  const auto last = static_cast<std::uint32_t>(sheet.mesh.positions.size() - 2);
  for (std::uint32_t at = 0; at < last; at += 2) add_quad(sheet.mesh, at, at + 2, at + 3, at + 1);
  return {{std::move(sheet)}, bend_m};
}

}  // namespace citykiln::props
