#include "preview/camera/place_views.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "preview/camera/view_probe.h"

namespace citykiln::preview {
namespace {

using materials::Material;

constexpr double kElbowRoom_m = 2;

// The best of the values seen, and what it belongs to.
struct Best {
  double value = 0;
  std::optional<Camera> camera{};

  void keep_better(double other_value, const Camera& other) {
    if (other_value > value) value = other_value, camera = other;
  }
};

// How many of the directions meet a building at a distance.
int buildings_around(const ViewProbe& look, Vec3 eye, double near_m) {
  int count = 0;
  for (int direction = 0; direction < kDirections; ++direction)
    count += look.meets_building(eye, unit(horizontal(direction) + Vec3{0, 0, 0.1}), near_m) ? 1 : 0;
  return count;
}

// How many rays within 30° to both sides of a direction, a little up and down, meet a building.
int buildings_ahead(const ViewProbe& look, Vec3 eye, int direction, double rise, double far_m) {
  int count = 0;
  for (const int aside : {-2, -1, 0, 1, 2})
    for (const double up : {rise - 0.06, rise, rise + 0.06})
      count += look.meets_building(eye, unit(horizontal(direction + aside) + Vec3{0, 0, up}), far_m) ? 1 : 0;
  return count;
}

// How far one sees over a square: short sights count most, since a street is long one way and narrow the other.
double width_of_square(const ViewProbe& look, Vec3 eye) {
  constexpr double kFar_m = 60;
  double inverse = 0;
  for (int direction = 0; direction < kDirections; ++direction)
    inverse += 1 / std::max(look.sight_m(eye, horizontal(direction), kFar_m), 0.1);
  return kDirections / inverse;
}

// How many of the rays within 30° to both sides of a direction meet materials between two distances.
template <typename Counts>
int hits_ahead(const ViewProbe& look, Vec3 eye, int direction, double rise, double near_m, double far_m,
               Counts counts) {
  int count = 0;
  for (const int aside : {-2, -1, 0, 1, 2})
    for (const double up : {rise - 0.08, rise, rise + 0.12}) {
      const auto hit =
          look.world.first_hit(eye - look.world.origin(), unit(horizontal(direction + aside) + Vec3{0, 0, up}));
      count += hit && hit->distance_m > near_m && hit->distance_m < far_m && counts(hit->material) ? 1 : 0;
    }
  return count;
}

bool is_green(Material material) {
  return material == Material::kGrass || material == Material::kMeadow || material == Material::kForestFloor ||
         material == Material::kScrub || material == Material::kDryGrass;
}

// The share of the ground around a place that is green, or a path or water in it.
double share_of_green(const ViewProbe& look, Vec3 eye) {
  int green = 0, all = 0;
  for (const double far_m : {10.0, 22.0, 36.0})
    for (int direction = 0; direction < kDirections; direction += 3, ++all) {
      const Vec3 above = eye + horizontal(direction) * far_m + Vec3{0, 0, 60};
      const auto hit = look.world.first_hit(above - look.world.origin(), {0, 0, -1});
      green += hit && (is_green(hit->material) || is_plant(hit->material) || is_water(hit->material) ||
                       hit->material == Material::kGravel || hit->material == Material::kEarth)
                   ? 1
                   : 0;
    }
  return static_cast<double>(green) / all;
}

// Less than 1 where the sun stands ahead, or behind the viewer, whose light shows no relief.
double worth_of_sun(const ViewScene& scene, int direction) {
  if (!scene.to_sun) return 1;
  const double ahead = dot(unit(Vec3{scene.to_sun->x, scene.to_sun->y, 0}), horizontal(direction));
  return ahead > 0.5 ? 0.55 : ahead > 0 ? 0.8 : ahead < -0.9 ? 0.85 : 1;
}

double highest_about(const SceneGrid& grid, Vec3 place) {
  double highest = place.z;
  for (const double x : {-40, 0, 40})
    for (const double y : {-40, 0, 40}) highest = std::max(highest, grid.highest_m(in_plan(place) + Vec2{x, y}));
  return highest;
}

}  // namespace

std::optional<Camera> square_view(const ViewScene& scene) {
  constexpr double kNear_m = 80, kLeastWidth_m = 15;
  const SceneGrid& grid = scene.grid;
  const ViewProbe& look = scene.look;
  Best best;
  const double top_m = grid.top_m() + 10;
  const auto is_paved = [](const bake::Primitive& p) { return p.material == Material::kPaving; };
  for (const Vec3& place : places_near(scene.tiles, grid.core_point(), is_paved, 10, 300)) {
    const Vec3 middle = place + Vec3{0, 0, kEye_m};
    const double width_m = width_of_square(look, middle);
    if (width_m < kLeastWidth_m || width_m < best.value / 2 || !look.is_under_the_sky(middle)) continue;
    const double value = width_m * buildings_around(look, middle, kNear_m) / kDirections;
    for (int direction = 0; direction < kDirections; ++direction) {
      // from near the edge, across the middle
      const double back_m = look.walk_m(middle, horizontal(direction) * -1, 40) - kElbowRoom_m - 1;
      const Vec3 from = middle - horizontal(direction) * std::max(0.0, back_m);
      const auto eye = look.place_above_ground(in_plan(from), kEye_m, top_m);
      if (!eye) continue;
      const double ahead_m = look.walk_m(*eye, horizontal(direction), kNear_m);
      const Camera camera{*eye, *eye + horizontal(direction) * 40 + Vec3{0, 0, 4}, 50};
      if (ahead_m < kLeastWidth_m || !is_free_in_front(look, camera)) continue;
      const int buildings = buildings_ahead(look, *eye, direction, 0.1, 2 * kNear_m);
      best.keep_better(value * (1 + buildings) * ahead_m * worth_of_sun(scene, direction), camera);
    }
  }
  return best.camera;
}

std::optional<Camera> water_view(const ViewScene& scene) {
  constexpr double kAbove_m = 3, kFar_m = 400, kLeast_m = 40, kBank_m = 6;
  const SceneGrid& grid = scene.grid;
  const ViewProbe& look = scene.look;
  Best best;
  const auto is_open = [](const bake::Primitive& p) {
    return materials::is_water(p.material) && p.material != Material::kPoolWater;
  };
  for (const Vec3& place : places_near(scene.tiles, grid.core_point(), is_open, 25, 240)) {
    const Vec3 eye = place + Vec3{0, 0, kAbove_m};
    const double room_m = look.room_m(eye, kBank_m);
    if (room_m < kElbowRoom_m || !look.is_under_the_sky(eye)) continue;
    for (int direction = 0; direction < kDirections; ++direction) {
      const double ahead_m = look.walk_m(eye, horizontal(direction), kFar_m);
      if (ahead_m < kLeast_m) continue;
      // far water fills the picture less than a town behind some water
      const double depth = std::sqrt(std::min(ahead_m, 160.0));
      const double value = room_m * room_m * depth * (1 + buildings_ahead(look, eye, direction, 0.06, kFar_m));
      best.keep_better(value * worth_of_sun(scene, direction),
                       {eye, eye + horizontal(direction) * 60 + Vec3{0, 0, 2}, 40});
    }
  }
  return best.camera;
}

std::optional<Camera> park_view(const ViewScene& scene) {
  constexpr double kNear_m = 8, kFar_m = 90, kLeastGreen = 0.6;
  const ViewProbe& look = scene.look;
  Best best;
  const double top_m = scene.grid.top_m() + 10;
  const auto is_lawn = [](const bake::Primitive& p) { return is_green(p.material); };
  for (const Vec3& place : places_near(scene.tiles, scene.grid.core_point(), is_lawn, 14, 400)) {
    const auto eye = look.place_above_ground(in_plan(place), kEye_m, top_m);
    if (!eye) continue;
    const double green = share_of_green(look, *eye);
    if (green < kLeastGreen || look.room_m(*eye, 3) < 3) continue;
    for (int direction = 0; direction < kDirections; ++direction) {
      const Camera camera{*eye, *eye + horizontal(direction) * 40 + Vec3{0, 0, 3}, 46};
      const int plants = hits_ahead(look, *eye, direction, 0.1, kNear_m, kFar_m, is_plant);
      const int buildings = hits_ahead(look, *eye, direction, 0.1, kNear_m, 3 * kFar_m, is_built);
      const double ahead_m = look.walk_m(*eye, horizontal(direction), kFar_m);
      const double value = green * std::min(plants, 9) * (1 + 0.1 * std::min(buildings, 4)) * std::sqrt(ahead_m) *
                           worth_of_sun(scene, direction);
      if (value > best.value && is_free_in_front(look, camera)) best.keep_better(value, camera);
    }
  }
  return best.camera;
}

std::optional<Camera> hilltop_view(const ViewScene& scene) {
  constexpr double kAbove_m = 15, kNearest_m = 150, kFarthest_m = 3000, kLeastHigher_m = 20;
  const SceneGrid& grid = scene.grid;
  const ViewProbe& look = scene.look;
  const Vec3 target = grid.core_point() + Vec3{0, 0, 10};
  Best best;
  for (const Vec3& ground : grid.points()) {
    const double low_m = grid.lowest_m(in_plan(ground));
    const double away_m = distance(in_plan(ground), in_plan(target));
    if (ground.z > low_m || away_m < kNearest_m || away_m > kFarthest_m || low_m < target.z + kLeastHigher_m) continue;
    // the column's lowest ground may be far below its middle
    const Vec3 above{ground.x, ground.y, grid.highest_m(in_plan(ground)) + 100};
    const Vec3 eye = above - Vec3{0, 0, look.sight_m(above, {0, 0, -1}, 1000) - kAbove_m};
    const Vec3 to = unit(target - eye);
    if (look.room_m(eye, kElbowRoom_m) < kElbowRoom_m) continue;
    if (look.sight_m(eye, to, 1e6) < length(target - eye) - 60) continue;
    // steep enough to show the place as a map is seen, and near
    best.keep_better((eye.z - target.z) / std::sqrt(away_m), {eye, target, 45});
  }
  return best.camera;
}

std::optional<Camera> roofs_view(const ViewScene& scene) {
  constexpr double kAbove_m = 8, kFall = -0.2, kFar_m = 300;
  const SceneGrid& grid = scene.grid;
  const ViewProbe& look = scene.look;
  const Vec3 core = grid.core_point();
  const Vec3 eye = at_height(in_plan(core), highest_about(grid, core) + kAbove_m);
  Best best;
  for (int direction = 0; direction < kDirections; ++direction)
    best.keep_better(buildings_ahead(look, eye, direction, kFall, kFar_m),
                     {eye, eye + horizontal(direction) * 100 + Vec3{0, 0, kFall * 100}, 50});
  return best.camera;
}

std::optional<Camera> skyline_view(const ViewScene& scene) {
  constexpr double kAway_m = 1500, kAbove_m = 6, kFov_deg = 22;
  const SceneGrid& grid = scene.grid;
  const ViewProbe& look = scene.look;
  const Vec3 core = grid.core_point();
  const double tall_m = std::max(0.0, highest_about(grid, core) - core.z);
  if (tall_m <= 3) return std::nullopt;
  const double away_m = std::max(kAway_m, 6 * tall_m);
  const Vec3 target = core + Vec3{0, 0, tall_m / 2};
  Best best;
  for (int direction = 0; direction < kDirections; ++direction) {
    const Vec2 from = in_plan(core) + in_plan(horizontal(direction)) * away_m;
    // hills that a column's lowest point does not show
    const Vec3 above = at_height(from, std::max(grid.highest_m(from), target.z) + 100);
    const double ground_m = std::max(above.z - look.sight_m(above, {0, 0, -1}, 1e4), core.z);
    // as low as the way to the target allows
    for (double rise_m = kAbove_m; rise_m < away_m / 3; rise_m *= 1.3) {
      const Vec3 eye = at_height(from, ground_m + rise_m);
      if (look.room_m(eye, kElbowRoom_m) < kElbowRoom_m || !look.is_under_the_sky(eye)) continue;
      const double seen_m = look.sight_m(eye, unit(target - eye), 1e6);
      if (seen_m < length(target - eye) - 200) continue;
      best.keep_better(1 / rise_m, {eye, target, kFov_deg});
      break;
    }
  }
  return best.camera;
}

}  // namespace citykiln::preview
