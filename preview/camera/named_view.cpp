// Views from outside have a fixed direction, and their distance is computed so that the scene fills the picture. Views
// inside the scene are chosen among candidate places.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "preview/camera/camera.h"
#include "preview/camera/place_views.h"
#include "preview/camera/scene_grid.h"
#include "preview/camera/view_probe.h"

namespace citykiln::preview {
namespace {

// ---- street view ----------------------------------------------------------------------------------------------------

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

// Returns a camera on a street. Without streets it is at the core. Total. Cost: one World.
//
// Method: 64 places on streets, the nearest to the scene's core that are at least 12 m apart, are each tried in 24
// directions by rays at eye height. The best view is long, and has walls on both sides and free sky.
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

// The aspect ratio for which the view fits; wider pictures show more at the sides.
constexpr double kAspect = 16.0 / 9;

// The share of the scene's columns that may lie outside each side of the picture, so that a lone mast does not make
// everything else small. Little enough that the corners of the extent are inside.
constexpr double kOutside = 0.0005;

// The share of the picture that the scene fills.
constexpr double kMargin = 0.94;

struct View {
  const char* name;
  Vec3 towards_eye;  ///< From the scene.
  double fov_deg;
};

constexpr View kOutsideViews[] = {
    {"overview", {0.52, -0.85, 0.62}, 35}, {"top", {0, 0, 1}, 35},    {"north", {0, 1, 0.5}, 35},
    {"south", {0, -1, 0.5}, 35},           {"east", {1, 0, 0.5}, 35}, {"west", {-1, 0, 0.5}, 35}};

// The largest of the values without the share that may lie outside.
double largest_inside(std::vector<double>& values) {
  const auto nth = values.end() - 1 - static_cast<std::ptrdiff_t>(kOutside * static_cast<double>(values.size()));
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

// Two opposite planes of the frustum, moved until they touch the points: the position of the eye across the view, and
// its largest position along it.
struct Wedge {
  double across, along;
};

Wedge wedge_about(const std::vector<Vec3>& points, Vec3 across, Vec3 forward, double half_slope) {
  std::vector<double> plus, minus;
  for (const Vec3& p : points) {
    plus.push_back(dot(p, across) - half_slope * dot(p, forward));
    minus.push_back(-dot(p, across) - half_slope * dot(p, forward));
  }
  const double a = largest_inside(plus), b = largest_inside(minus);
  return {(a - b) / 2, -(a + b) / (2 * half_slope)};
}

Camera outside_view(const SceneGrid& grid, const View& view) {
  const Vec3 forward = unit(view.towards_eye) * -1,
             pole = view.towards_eye.x == 0 && view.towards_eye.y == 0 ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
  const Vec3 right = unit(cross(forward, pole)), up = cross(right, forward);
  const double slope = std::tan(view.fov_deg * std::numbers::pi / 360) * kMargin;
  const std::vector<Vec3> points = grid.points();
  const Wedge sideways = wedge_about(points, right, forward, slope * kAspect),
              upright = wedge_about(points, up, forward, slope);
  const double along = std::min(sideways.along, upright.along);
  const Vec3 eye = right * sideways.across + up * upright.across + forward * along;
  return {eye, eye + forward * std::max(1.0, dot(grid.core_point() - eye, forward)), view.fov_deg};
}

// The height from which the eye sees a target past the hills in between and over the roofs below it.
double clear_height_m(const SceneGrid& grid, Vec2 from, Vec3 target) {
  constexpr double kOverHills_m = 40, kOverRoofs_m = 30;
  constexpr int kSteps = 16;
  double height = std::max(target.z, grid.highest_m(from) + kOverRoofs_m);
  for (int step = 1; step < kSteps; ++step) {
    const double share = static_cast<double>(step) / kSteps;
    const double hill = grid.lowest_m(from + (in_plan(target) - from) * share) + kOverHills_m * (1 - share);
    height = std::max(height, target.z + (hill - target.z) / (1 - share));
  }
  return height;
}

// A view over the roofs into the densest part, from the side that needs the least height; from the south-west on ties.
Camera low_view(const SceneGrid& grid) {
  constexpr Vec2 kSides[] = {{-0.6, -0.8}, {0.7, -0.7}, {0, -1}, {-1, 0}, {1, 0}, {-0.7, 0.7}, {0.7, 0.7}, {0, 1}};
  // some 15 degrees down, as a town is seen from a hill
  constexpr double kAway_m = 550, kRise = 0.27, kStoreys = 1.6;
  const Vec3 ground = grid.core_point();
  const double tall_m = std::max(0.0, grid.highest_m(in_plan(ground)) - ground.z);
  const double away_m = std::max(kAway_m, kStoreys * tall_m);
  const Vec3 target = ground + Vec3{0, 0, tall_m / 3};
  Camera best{{}, target, 45};
  best.eye.z = std::numeric_limits<double>::infinity();
  for (const Vec2 side : kSides) {
    const Vec2 from = in_plan(target) + unit(side) * away_m;
    const double height = std::max(target.z + kRise * away_m, clear_height_m(grid, from, target));
    // prefer an earlier side unless another needs 20 m less
    if (height < best.eye.z - 20) best.eye = at_height(from, height);
  }
  return best;
}

// Views of places that not every scene has.
struct PlaceView {
  const char* name;
  std::optional<Camera> (*find)(std::span<const bake::BakedTile> tiles, const SceneGrid& grid);
  const char* lack;
};

constexpr PlaceView kPlaceViews[] = {
    {"square", square_view, "there is no open paved place in this scene"},
    {"river", river_view, "there is no open water in this scene"},
    {"hilltop", hilltop_view, "there is no hill in this scene from which its middle can be seen"},
    {"roofs", roofs_view, "nothing is built in this scene"},
    {"skyline", skyline_view, "nothing tall is built in this scene"}};

}  // namespace

Result<Camera> named_view(std::span<const bake::BakedTile> tiles, const std::string& name) {
  const SceneGrid grid(tiles);
  if (name == "street") return street_view(tiles, grid);
  if (name == "low") return low_view(grid);
  std::string known = "street, low";
  for (const View& view : kOutsideViews) {
    if (name == view.name) return outside_view(grid, view);
    known += std::string(", ") + view.name;
  }
  for (const PlaceView& view : kPlaceViews) {
    if (name == view.name) {
      const std::optional<Camera> camera = view.find(tiles, grid);
      return camera ? Result(*camera) : Error{"--view " + name, view.lack};
    }
    known += std::string(", ") + view.name;
  }
  return Error{"--view " + name, "expected one of " + known};
}

}  // namespace citykiln::preview
