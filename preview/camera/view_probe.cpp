#include "preview/camera/view_probe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "preview/camera/camera_rays.h"
#include "preview/camera/scene_grid.h"

namespace citykiln::preview {
namespace {

using materials::Material;

// Adds places of a triangle: its middle, or the middles of the n² equal parts that it is cut into if its sides are
// longer than the places are apart.
template <typename Add>
void add_places(const std::array<Vec3, 3>& corners, double apart_m, Add add) {
  constexpr double kMostParts = 12;
  const Vec3 a = corners[0], u = corners[1] - a, v = corners[2] - a;
  const double longest = std::max({length(u), length(v), length(u - v)});
  const double wanted = std::ceil(longest / (2 * apart_m));
  const int n = wanted >= 1 && wanted <= kMostParts ? static_cast<int>(wanted) : wanted > kMostParts ? 12 : 1;
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) add(a + u * ((i + 1.0 / 3) / n) + v * ((j + 1.0 / 3) / n));
}

}  // namespace

bool is_plant(Material material) {
  switch (material) {
    case Material::kBark:
    case Material::kFurrowedBark:
    case Material::kSmoothBark:
    case Material::kPaperBark:
    case Material::kPlatedBark:
    case Material::kFlakedBark:
    case Material::kRingedBark:
    case Material::kBroadLeaf:
    case Material::kNeedleLeaf:
    case Material::kHedge:
      return true;
    default:
      return false;
  }
}

bool is_ground(Material material) {
  const bool is_land = material <= Material::kConcrete && !is_water(material);
  const bool is_sports =
      material >= Material::kArtificialTurf && material <= Material::kDryGrass && !is_water(material);
  return is_land || is_sports || material == Material::kPaint;
}

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

bool ViewProbe::is_under_the_sky(Vec3 from) const { return !world.is_blocked(from - world.origin(), {0, 0, 1}); }

std::optional<Vec3> ViewProbe::place_above_ground(Vec2 at, double above_m, double from_m) const {
  const auto hit = world.first_hit(at_height(at, from_m) - world.origin(), {0, 0, -1});
  if (!hit || !is_ground(hit->material)) return std::nullopt;
  const Vec3 place = at_height(at, from_m - hit->distance_m + above_m);
  return is_under_the_sky(place) ? std::optional(place) : std::nullopt;
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
                              const std::function<bool(const bake::Primitive&)>& counts, double apart_m, int count) {
  std::vector<std::pair<double, Vec3>> found;
  const auto add = [&](Vec3 place) {
    const double far = distance(in_plan(place), in_plan(core));
    if (std::isfinite(far) && std::isfinite(place.z)) found.emplace_back(far, place);
  };
  for (const bake::BakedTile& tile : tiles)
    for (const bake::Primitive& primitive : tile.primitives) {
      if (!counts(primitive)) continue;
      const auto at = [&](std::uint32_t i) { return tile.origin + bake::widened(primitive.positions[i]); };
      for (const auto& t : primitive.triangles) add_places({at(t[0]), at(t[1]), at(t[2])}, apart_m, add);
    }
  std::ranges::sort(found);
  std::vector<Vec3> places;
  for (const auto& [far, place] : found) {
    const bool is_new = std::ranges::none_of(places, [&, at = place](Vec3 p) { return length(p - at) < apart_m; });
    if (is_new) places.push_back(place);
    if (static_cast<int>(places.size()) == count) break;
  }
  return places;
}

}  // namespace citykiln::preview
