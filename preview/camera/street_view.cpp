#include "preview/camera/street_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "preview/scene/world.h"

namespace citykiln::preview {
namespace {

// Eye height of a person on a step.
constexpr double kEye_m = 2.4;
constexpr double kFov_deg = 60;

constexpr int kPlaces = 64, kDirections = 24;

// Smallest distance between candidates.
constexpr double kApart_m = 12;

// Candidates: middles of street triangles, the nearest to the core first, at least kApart_m apart.
std::vector<Vec3> places_near(std::span<const bake::BakedTile> tiles, Vec3 core) {
  std::vector<std::pair<double, Vec3>> middles;
  for (const bake::BakedTile& tile : tiles)
    for (const bake::Primitive& primitive : tile.primitives) {
      if (!is_street(primitive.material)) continue;
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
    const bool is_new = std::ranges::none_of(places, [at = middle](Vec3 p) { return length(p - at) < kApart_m; });
    if (is_new) places.push_back(middle);
    if (static_cast<int>(places.size()) == kPlaces) break;
  }
  return places;
}

// Casts rays in the plane's frame.
struct ViewProbe {
  const World& world;

  // Length of free sight, at most `limit`.
  double sight_m(Vec3 from, Vec3 direction, double limit) const {
    const auto hit = world.first_hit(from - world.origin(), direction);
    return hit ? std::min(hit->distance_m, limit) : limit;
  }
  // Whether the ray ends on a wall nearer than this.
  bool meets_wall(Vec3 from, Vec3 direction, double near) const {
    const auto hit = world.first_hit(from - world.origin(), direction);
    return hit && hit->distance_m < near && is_built(hit->material);
  }
};

Vec3 level(int direction) {
  const double angle = 2 * std::numbers::pi * direction / kDirections;
  return {std::cos(angle), std::sin(angle), 0};
}

// The score of a view: length along the street, walls on both sides, and space between them.
double worth(const ViewProbe& look, Vec3 eye, int direction) {
  constexpr double kFarEnough_m = 150, kNearEnough_m = 60, kTooNear_m = 15, kWide_m = 9;
  const double ahead = look.sight_m(eye, level(direction), kFarEnough_m);
  if (ahead < kTooNear_m) return 0;
  double room = kWide_m;
  for (const int aside : {-6, -4, 4, 6}) room = std::min(room, look.sight_m(eye, level(direction + aside), kWide_m));
  int walls = 0;
  for (const int aside : {-4, -3, -2, -1, 1, 2, 3, 4})
    walls += look.meets_wall(eye, unit(level(direction + aside) + Vec3{0, 0, 0.12}), kNearEnough_m) ? 1 : 0;
  // squared, so that alleys, which show two walls only, score low
  return ahead * (1 + walls) * room * room;
}

}  // namespace

Camera street_view(std::span<const bake::BakedTile> tiles, const SceneGrid& grid) {
  const Vec3 core = grid.core_point();
  const World world(tiles, core);
  const ViewProbe look{world};
  Camera best{core + Vec3{0, 0, kEye_m}, core + Vec3{0, 40, kEye_m}, kFov_deg};
  double most = 0;
  for (const Vec3& place : places_near(tiles, core)) {
    const Vec3 eye = place + Vec3{0, 0, kEye_m};
    // not under a bridge, a roof or a tree
    if (look.sight_m(eye, {0, 0, 1}, 100) < 100) continue;
    for (int direction = 0; direction < kDirections; ++direction) {
      const double value = worth(look, eye, direction);
      if (value > most) most = value, best = {eye, eye + level(direction) * 40 + Vec3{0, 0, 2}, kFov_deg};
    }
  }
  return best;
}

}  // namespace citykiln::preview
