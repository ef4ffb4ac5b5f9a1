#include "preview/camera/view_probe.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "preview/camera/camera_rays.h"
#include "preview/camera/scene_grid.h"

namespace citykiln::preview {

Vec3 horizontal(int direction) {
  const double angle = 2 * std::numbers::pi * direction / kDirections;
  return {std::cos(angle), std::sin(angle), 0};
}

double ViewProbe::sight_m(Vec3 from, Vec3 direction, double limit) const {
  const auto hit = world.first_hit(from - world.origin(), direction);
  return hit ? std::min(hit->distance_m, limit) : limit;
}

bool ViewProbe::meets_building(Vec3 from, Vec3 direction, double near) const {
  const auto hit = world.first_hit(from - world.origin(), direction);
  return hit && hit->distance_m < near && is_built(hit->material);
}

double ViewProbe::room_m(Vec3 from, double limit) const {
  double room = limit;
  for (int direction = 0; direction < kDirections; ++direction)
    room = std::min(room, sight_m(from, horizontal(direction), limit));
  return room;
}

double ViewProbe::walk_m(Vec3 eye, Vec3 direction, double limit) const {
  // a parapet on rising ground is as high as the knee of a person who looks level
  constexpr double kParapet_m = 1.2, kAside = 0.06;
  const Vec3 aside = cross(direction, {0, 0, 1}) * kAside;
  double sight = limit;
  for (const double lower_m : {0.0, kParapet_m})
    for (const double side : {-1.0, 0.0, 1.0})
      sight = std::min(sight, sight_m(eye - Vec3{0, 0, lower_m}, unit(direction + aside * side), limit));
  return sight;
}

double farthest_in_picture_m(const World& world, const Camera& camera) {
  constexpr int kSide = 9;
  // a pinhole at rest draws nothing
  const CameraRays rays({camera.eye, camera.look_at, camera.vertical_fov_deg}, kSide, kSide);
  const PixelSamples chances(0, 0, 0, grid_of(1, 1, 1));
  PathDraw draw(chances, 0);
  double farthest = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const CameraRay ray = rays.through(x + 0.5, y + 0.5, draw);
      const auto hit = world.first_hit(ray.from - world.origin(), ray.direction);
      if (!hit) return std::numeric_limits<double>::infinity();
      farthest = std::max(farthest, hit->distance_m);
    }
  return farthest;
}

std::vector<Vec3> places_near(std::span<const bake::BakedTile> tiles, Vec3 core,
                              const std::function<bool(materials::Material)>& counts, double apart_m, int count) {
  std::vector<std::pair<double, Vec3>> middles;
  for (const bake::BakedTile& tile : tiles)
    for (const bake::Primitive& primitive : tile.primitives) {
      if (!counts(primitive.material)) continue;
      for (const auto& t : primitive.triangles) {
        Vec3 sum;
        for (const std::uint32_t i : t) sum = sum + bake::widened(primitive.positions[i]);
        const Vec3 middle = tile.origin + sum * (1.0 / 3);
        const double far = distance(in_plan(middle), in_plan(core));
        if (std::isfinite(far) && std::isfinite(middle.z)) middles.emplace_back(far, middle);
      }
    }
  std::ranges::sort(middles);
  std::vector<Vec3> places;
  for (const auto& [far, middle] : middles) {
    const bool is_new = std::ranges::none_of(places, [&, at = middle](Vec3 p) { return length(p - at) < apart_m; });
    if (is_new) places.push_back(middle);
    if (static_cast<int>(places.size()) == count) break;
  }
  return places;
}

}  // namespace citykiln::preview
