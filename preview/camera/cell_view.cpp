#include "preview/camera/cell_view.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "compiler/geometry/snap.h"
#include "preview/camera/camera_rays.h"

namespace citykiln::preview {
namespace {

// A film with more eyes after its first has neighbouring ones joined.
constexpr std::size_t kMostEyes = 64;

// Boxes of neighbouring eyes.
std::vector<bake::Bounds> boxes_of(std::span<const Vec3> eyes) {
  std::vector<bake::Bounds> boxes;
  const std::size_t each = (eyes.size() + kMostEyes - 1) / kMostEyes;
  for (std::size_t i = 0; i < eyes.size(); i += each) {
    bake::Bounds box{.low_m = eyes[i].z, .high_m = eyes[i].z};
    for (const Vec3 eye : eyes.subspan(i, std::min(each, eyes.size() - i))) {
      box.plan.grow(in_plan(eye));
      box.low_m = std::min(box.low_m, eye.z), box.high_m = std::max(box.high_m, eye.z);
    }
    boxes.push_back(box);
  }
  return boxes;
}

double lowest_m(const scene::Scene& scene) {
  double lowest_m = std::numeric_limits<double>::infinity();
  for (const scene::Chunk& chunk : scene.chunks)
    lowest_m = std::min(lowest_m, bake::bounds_of(chunk.heights, scene::box_of(scene.header, chunk.tile)).low_m);
  return lowest_m;
}

}  // namespace

std::vector<Vec3> eyes_of(std::span<const Camera> cameras) {
  std::vector<Vec3> eyes;
  for (const Camera& camera : cameras) {
    eyes.push_back(camera.eye);
    if (camera.shutter_end) eyes.push_back(camera.shutter_end->eye);
  }
  return eyes;
}

bake::Sight sight_of(const Camera& camera, int width_px, int height_px) {
  // pixels gather light up to one pixel aside
  constexpr int kWider_px = 2;
  const ViewAxes axes = axes_of({camera.eye, camera.look_at});
  const double up = std::tan(camera.vertical_fov_deg * std::numbers::pi / 360) * (height_px + kWider_px) / height_px;
  const double right = up * (width_px + kWider_px) / (height_px + kWider_px);
  const auto side = [&](Vec3 across, double reach) {
    const Vec3 normal = unit(across - axes.forward * reach);
    return bake::Sight::Plane{normal, dot(normal, camera.eye) + camera.lens_radius_m};
  };
  return {.sides = {side(axes.right, right), side(axes.right * -1, right), side(axes.up, up), side(axes.up * -1, up)}};
}

bake::View cell_view(const scene::Scene& scene, std::span<const Camera> cameras, const CellFineness& fineness) {
  assert(!cameras.empty() && fineness.pixel_error > 0 && fineness.unseen_deg >= 0);
  const std::vector<Vec3> eyes = eyes_of(cameras);
  bake::View view{.eye = eyes.front(), .pixel_error = fineness.pixel_error, .finest_m = fineness.finest_m};
  for (const Camera& camera : cameras)
    view.focal_px = std::max(view.focal_px, bake::focal_length_px(fineness.height_px, camera.vertical_fov_deg));
  if (eyes.size() > 1) {
    view.more_eyes = boxes_of(std::span(eyes).subspan(1));
  } else if (fineness.unseen_deg > 0) {
    view.sight = sight_of(cameras.front(), fineness.width_px, fineness.height_px);
    view.sight->unseen_rad = fineness.unseen_deg * std::numbers::pi / 180;
    view.sight->lowest_m = lowest_m(scene);
    if (!sky::is_night(scene.header.sky)) view.sight->to_sun = scene.header.sky.to_sun;
  }
  return view;
}

}  // namespace citykiln::preview
