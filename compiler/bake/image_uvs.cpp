#include "compiler/bake/image_uvs.h"

#include <cmath>
#include <span>

namespace citykiln::bake {
namespace {

using materials::ColourSource;
using materials::TextureImage;

double snapped_to_step(double at_m, double step_m) { return std::floor(at_m / step_m + 0.5) * step_m; }

void snap(std::span<Primitive> primitives, ColourSource colour_source, const TextureImage& image) {
  if (image.texels.empty()) return;
  const double step_m = materials::uv_step_m(image);
  for (Primitive& primitive : primitives) {
    if (primitive.colour_source != colour_source) continue;
    for (Float2& uv : primitive.uvs)
      for (float& c : uv) c = static_cast<float>(snapped_to_step(c, step_m)) + 0.0f;
  }
}

}  // namespace

Vec2 snapped_uv(Vec2 uv, const TextureImage& image) {
  const double step_m = materials::uv_step_m(image);
  return {snapped_to_step(uv.x, step_m), snapped_to_step(uv.y, step_m)};
}

void snap_image_uvs(BakedTile& tile) { snap_image_uvs(tile, tile.marking_atlas); }

void snap_image_uvs(BakedTile& tile, const TextureImage& marking_atlas) {
  const auto snap_all = [&](std::vector<Primitive>& primitives, const TextureImage& cutout) {
    snap(primitives, ColourSource::kByMarkingAtlas, marking_atlas);
    snap(primitives, ColourSource::kByAtlas, tile.facade_atlas.colour);
    snap(primitives, ColourSource::kByCutout, cutout);
  };
  snap_all(tile.primitives, {});
  for (InstancedMesh& instanced : tile.instanced) snap_all(instanced.primitives, instanced.cutout->colour);
}

void snap_image_uvs(std::vector<Primitive>& primitives, const impostor::Cutout& cutout) {
  snap(primitives, ColourSource::kByCutout, cutout.colour);
}

}  // namespace citykiln::bake
