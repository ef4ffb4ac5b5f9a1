#include "preview/camera/view_probe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
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

// Calls back with what the rays through the middles of a picture's pixels meet first, if anything.
void for_each_ray(const World& world, const Camera& camera, int width, int height,
                  const std::function<void(const std::optional<Hit>&)>& on_ray) {
  // a pinhole at rest draws nothing
  const CameraRays rays({camera.eye, camera.look_at, camera.vertical_fov_deg}, width, height);
  const PixelSamples chances(0, 0, 0, grid_of(1, 1, 1));
  PathDraw draw(chances, 0);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const CameraRay ray = rays.through(x + 0.5, y + 0.5, draw);
      on_ray(world.first_hit(ray.from - world.origin(), ray.direction));
    }
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

std::optional<Hit> ViewProbe::first_beyond_plants(Vec3 from, Vec3 direction) const {
  double passed_m = 0;
  for (int i = 0; i < 256; ++i) {
    auto hit = world.first_hit(from + direction * passed_m - world.origin(), direction);
    if (!hit) return std::nullopt;
    passed_m += hit->distance_m;
    hit->distance_m = passed_m;
    if (!is_plant(hit->material)) return hit;
    passed_m += 0.001;
  }
  return std::nullopt;
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
  constexpr double kBelowCrown_m = 1;
  const auto ground = first_beyond_plants(at_height(at, from_m), {0, 0, -1});
  if (!ground || !is_ground(ground->material)) return std::nullopt;
  const Vec3 place = at_height(at, from_m - ground->distance_m + above_m);
  const bool is_in_crown = sight_m(place, {0, 0, 1}, kBelowCrown_m) < kBelowCrown_m;
  if (is_in_crown || first_beyond_plants(place, {0, 0, 1})) return std::nullopt;
  return place;
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
  double farthest = 0;
  for_each_ray(world, camera, 9, 9, [&](const std::optional<Hit>& hit) {
    farthest = std::max(farthest, hit ? hit->distance_m : std::numeric_limits<double>::infinity());
  });
  return farthest;
}

PictureContent content_of(const World& world, const Camera& camera) {
  constexpr int kWide = 32, kHigh = 18;
  constexpr double kClose_m = 7;
  PictureContent content;
  std::map<std::optional<Material>, int> rays;
  for_each_ray(world, camera, kWide, kHigh, [&](const std::optional<Hit>& hit) {
    ++rays[hit ? std::optional(hit->material) : std::nullopt];
    if (hit && hit->distance_m < kClose_m && is_built(hit->material)) content.close_walls += 1.0 / (kWide * kHigh);
  });
  for (const auto& [material, count] : rays) {
    const double share = static_cast<double>(count) / (kWide * kHigh);
    content.variety_bits -= share * std::log2(share);
  }
  return content;
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
