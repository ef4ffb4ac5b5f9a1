#include "preview/camera/street_view.h"

#include <algorithm>

#include "preview/camera/view_probe.h"

namespace citykiln::preview {
namespace {

// Eye height of a person on a step.
constexpr double kEye_m = 2.4;
constexpr double kFov_deg = 60;

constexpr int kPlaces = 64;

// Smallest distance between candidates.
constexpr double kApart_m = 12;

// The score of a view: length along the street, walls on both sides, and space between them.
double worth(const ViewProbe& look, Vec3 eye, int direction) {
  constexpr double kFarEnough_m = 150, kNearEnough_m = 60, kTooNear_m = 15, kWide_m = 9;
  const double ahead = look.walk_m(eye, horizontal(direction), kFarEnough_m);
  if (ahead < kTooNear_m) return 0;
  double room = kWide_m;
  for (const int aside : {-6, -4, 4, 6})
    room = std::min(room, look.sight_m(eye, horizontal(direction + aside), kWide_m));
  int walls = 0;
  for (const int aside : {-4, -3, -2, -1, 1, 2, 3, 4})
    walls += look.meets_building(eye, unit(horizontal(direction + aside) + Vec3{0, 0, 0.12}), kNearEnough_m) ? 1 : 0;
  // squared, so that alleys, which show two walls only, score low
  return ahead * (1 + walls) * room * room;
}

}  // namespace

Camera street_view(std::span<const bake::BakedTile> tiles, const SceneGrid& grid) {
  constexpr double kElbowRoom_m = 1;
  const Vec3 core = grid.core_point();
  const World world(tiles, core);
  const ViewProbe look{world};
  Camera best{core + Vec3{0, 0, kEye_m}, core + Vec3{0, 40, kEye_m}, kFov_deg};
  double most = 0;
  for (const Vec3& place : places_near(tiles, core, is_street, kApart_m, kPlaces)) {
    const Vec3 eye = place + Vec3{0, 0, kEye_m};
    // not under a bridge, a roof or a tree, and not close to a wall
    if (look.sight_m(eye, {0, 0, 1}, 100) < 100 || look.room_m(eye, kElbowRoom_m) < kElbowRoom_m) continue;
    for (int direction = 0; direction < kDirections; ++direction) {
      const double value = worth(look, eye, direction);
      if (value > most) most = value, best = {eye, eye + horizontal(direction) * 40 + Vec3{0, 0, 2}, kFov_deg};
    }
  }
  return best;
}

}  // namespace citykiln::preview
