#include "preview/scene/mesh_scene.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace citykiln::preview {

MeshScene::MeshScene(RTCDevice device, const std::vector<bake::Primitive>& primitives, const MipTexture* marking_atlas,
                     std::vector<const MaterialTexture*> materials, std::shared_ptr<const CutoutTexture> cutout)
    : primitives_(&primitives),
      materials_(std::move(materials)),
      cutout_(std::move(cutout)),
      scene_(rtcNewScene(device)) {
  assert(materials_.size() == primitives.size());
  constexpr double kFar = std::numeric_limits<double>::infinity();
  low_ = {kFar, kFar, kFar}, high_ = {-kFar, -kFar, -kFar};
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    if (primitives[i].triangles.empty()) continue;
    parts_.push_back(mesh_part_of(primitives[i], {}, marking_atlas, materials_[i], nullptr, cutout_.get()));
    for (const bake::Float3& p : primitives[i].positions) {
      low_ = {std::min<double>(low_.x, p[0]), std::min<double>(low_.y, p[1]), std::min<double>(low_.z, p[2])};
      high_ = {std::max<double>(high_.x, p[0]), std::max<double>(high_.y, p[1]), std::max<double>(high_.z, p[2])};
    }
  }
  for (const MeshPart& part : parts_) attach(device, scene_, part);
  rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
  rtcCommitScene(scene_);
}

MeshScene::~MeshScene() { rtcReleaseScene(scene_); }

bool MeshScene::is_of(const bake::InstancedMesh& mesh, const MipTexture* marking_atlas,
                      std::span<const MaterialTexture* const> materials) const {
  const auto is_on_it = [&](const MeshPart& part) {
    return part.primitive->colour_source != materials::ColourSource::kByMarkingAtlas ||
           part.marking_atlas == marking_atlas;
  };
  // many meshes have the same large picture, so it is compared last
  if (*primitives_ != mesh.primitives || !std::ranges::equal(materials_, materials)) return false;
  if (!std::ranges::all_of(parts_, is_on_it)) return false;
  const bool has_cutout = !mesh.cutout->colour.texels.empty();
  if (has_cutout != (cutout_ != nullptr)) return false;
  return !has_cutout || &cutout_->cutout() == &*mesh.cutout || cutout_->cutout() == *mesh.cutout;
}

std::size_t MeshScene::bytes() const {
  std::size_t bytes = 0;
  for (const MeshPart& part : parts_) bytes += part.corners.capacity() * sizeof(bake::Float3);
  return bytes;
}

}  // namespace citykiln::preview
