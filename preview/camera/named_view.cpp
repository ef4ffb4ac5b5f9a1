// Views from outside have a fixed direction, and their distance is computed so that their subject fills the picture.
// Views inside the scene are chosen among candidate places.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "preview/camera/camera.h"
#include "preview/camera/place_views.h"
#include "preview/camera/street_view.h"
#include "preview/camera/view_names.h"

namespace citykiln::preview {
namespace {

// The aspect ratio for which the view fits; wider pictures show more at the sides.
constexpr double kAspect = 16.0 / 9;

// The share of the scene's columns that may lie outside each side of the picture, so that a lone mast does not make
// everything else small. Little enough that the corners of the extent are inside.
constexpr double kOutside = 0.0005;

// The share of the picture that the scene fills.
constexpr double kMargin = 0.94;

// The share of what is built that may lie outside each side of the picture: single houses far from all others.
constexpr double kOutlying = 0.03;

struct View {
  const char* name;
  Vec3 towards_eye;  ///< From the scene.
  double fov_deg;
  bool is_of_built_part = false;  ///< False: the whole scene fits into the picture.
};

constexpr View kOutsideViews[] = {{"overview", {0.52, -0.85, 0.5}, 35, true},
                                  {"top", {0, 0, 1}, 35},
                                  {"north", {0, 1, 0.5}, 35},
                                  {"south", {0, -1, 0.5}, 35},
                                  {"east", {1, 0, 0.5}, 35},
                                  {"west", {-1, 0, 0.5}, 35}};

// A point that a picture shows, and how much it counts.
struct Weighted {
  Vec3 at;
  double weight;
};

// The points that a picture shows, and the share of them that may lie outside each side.
struct Subject {
  std::vector<Weighted> points;
  double outside;
};

Subject whole_of(const SceneGrid& grid) {
  Subject all{.points = {}, .outside = kOutside};
  for (const Vec3& at : grid.points()) all.points.push_back({at, 1});
  return all;
}

// Returns what is built, or the whole scene if that is next to nothing.
Subject built_part_of(const SceneGrid& grid) {
  constexpr std::size_t kLeast = 8;
  Subject built{.points = {}, .outside = kOutlying};
  for (const auto& [at, built_m2] : grid.built_points()) built.points.push_back({at, built_m2});
  return built.points.size() < kLeast ? whole_of(grid) : built;
}

// The value that all but a share of the weights do not exceed.
double largest_inside(std::vector<std::pair<double, double>>& weighted_values, double outside) {
  std::ranges::sort(weighted_values, std::ranges::greater{});
  double all = 0;
  for (const auto& [value, weight] : weighted_values) all += weight;
  double left = all * outside;
  for (const auto& [value, weight] : weighted_values)
    if (left -= weight; left < 0) return value;
  return weighted_values.back().first;
}

// Two opposite planes of the frustum, moved until they touch the points: the position of the eye across the view, and
// its largest position along it.
struct Wedge {
  double across, along;
};

Wedge wedge_about(const Subject& subject, Vec3 across, Vec3 forward, double half_slope) {
  std::vector<std::pair<double, double>> plus, minus;
  for (const auto& [p, weight] : subject.points) {
    plus.emplace_back(dot(p, across) - half_slope * dot(p, forward), weight);
    minus.emplace_back(-dot(p, across) - half_slope * dot(p, forward), weight);
  }
  const double a = largest_inside(plus, subject.outside), b = largest_inside(minus, subject.outside);
  return {(a - b) / 2, -(a + b) / (2 * half_slope)};
}

Camera outside_view(const SceneGrid& grid, const View& view) {
  const Vec3 forward = unit(view.towards_eye) * -1,
             pole = view.towards_eye.x == 0 && view.towards_eye.y == 0 ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
  const Vec3 right = unit(cross(forward, pole)), up = cross(right, forward);
  const double slope = std::tan(view.fov_deg * std::numbers::pi / 360) * kMargin;
  const Subject subject = view.is_of_built_part ? built_part_of(grid) : whole_of(grid);
  const Wedge sideways = wedge_about(subject, right, forward, slope * kAspect),
              upright = wedge_about(subject, up, forward, slope);
  const double along = std::min(sideways.along, upright.along);
  Vec3 eye = right * sideways.across + up * upright.across + forward * along;
  // above all land that rises between the eye and what is built
  eye = eye - forward * (std::max(0.0, grid.top_m() + 30 - eye.z) / -forward.z);
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

// The distance from the core within which most of what is built lies.
double built_radius_m(const SceneGrid& grid, Vec3 core) {
  constexpr double kMost = 0.7;
  std::vector<std::pair<double, double>> distances;
  for (const auto& [at, built_m2] : grid.built_points())
    distances.emplace_back(distance(in_plan(at), in_plan(core)), built_m2);
  return distances.empty() ? 0 : largest_inside(distances, 1 - kMost);
}

// How much of a picture is filled by what is built, and by land; less where the scene ends below the horizon. -1: the
// eye is too near to something, or below it.
double worth_of_filling(const ViewScene& scene, const Camera& camera) {
  constexpr double kTooNear = 0.4, kLand = 0.35, kVoid = 1;
  constexpr int kColumns = 8, kRows = 6;
  const World& world = scene.look.world;
  if (!scene.look.is_under_the_sky(camera.eye)) return -1;
  const Vec3 forward = unit(camera.look_at - camera.eye), right = unit(cross(forward, {0, 0, 1}));
  const double slope = std::tan(camera.vertical_fov_deg * std::numbers::pi / 360);
  double worth = 0;
  for (int i = 0; i < kColumns; ++i)
    for (int j = 0; j < kRows; ++j) {
      const double x = (2 * (i + 0.5) / kColumns - 1) * slope * kAspect, y = (2 * (j + 0.5) / kRows - 1) * slope;
      const Vec3 ray = unit(forward + right * x + cross(right, forward) * y);
      const auto hit = world.first_hit(camera.eye - world.origin(), ray);
      if (hit && hit->distance_m < kTooNear * length(camera.look_at - camera.eye)) return -1;
      if (hit) worth += is_built(hit->material) ? 1 : kLand;
      if (!hit && ray.z < -0.02) worth -= kVoid;
    }
  return std::max(worth / (kColumns * kRows), 1e-3);
}

// How well the light of the sun shows what a camera sees: best from the side and a little from behind.
double worth_of_sun_for(const std::optional<Vec3>& to_sun, const Camera& camera) {
  if (!to_sun) return 1;
  const Vec3 forward = unit(camera.look_at - camera.eye);
  const double ahead = dot(unit(Vec3{to_sun->x, to_sun->y, 0}), unit(Vec3{forward.x, forward.y, 0}));
  return ahead > 0.5 ? 0.75 : ahead > 0.1 ? 0.9 : ahead < -0.85 ? 0.92 : 1;
}

// A view over the roofs into the densest part, from the side and distance that fill the picture best with what is
// built; from the south-west on ties.
Camera low_view(const ViewScene& scene) {
  constexpr int kSides = 16;
  // some 15 degrees down, as a town is seen from a hill
  constexpr double kNearest_m = 180, kFarthest_m = 560, kRise = 0.27, kStoreys = 2.4, kLowFov_deg = 40;
  const SceneGrid& grid = scene.grid;
  const Vec3 ground = grid.core_point();
  const double tall_m = std::max(0.0, grid.highest_m(in_plan(ground)) - ground.z);
  const double usual_m = std::clamp(1.3 * built_radius_m(grid, ground), kNearest_m, kFarthest_m);
  const Vec3 target = ground + Vec3{0, 0, tall_m / 3};
  std::optional<Camera> best;
  double most = -2;
  for (int side = 0; side < kSides; ++side)
    for (const double share : {1.0, 0.7}) {
      const double angle = (10 + side) * 2 * std::numbers::pi / kSides;  // from the south-west on
      const double away_m = std::max(usual_m * share, kStoreys * tall_m);
      const Vec2 from = in_plan(target) + Vec2{std::cos(angle), std::sin(angle)} * away_m;
      const double height_m = std::max(target.z + kRise * away_m, clear_height_m(grid, from, target));
      const Camera camera{at_height(from, height_m), target, kLowFov_deg};
      // a steep view shows roofs only
      const double steep = (height_m - target.z) / away_m;
      const double worth = worth_of_filling(scene, camera) * worth_of_sun_for(scene.to_sun, camera) *
                           std::min(1.0, 0.45 / std::max(steep, 0.01));
      if (worth > most * 1.02 + 1e-9 || !best) most = worth, best = camera;
    }
  return *best;
}

// Views of places that not every scene has.
struct PlaceView {
  const char* name;
  std::optional<Camera> (*find)(const ViewScene& scene);
  const char* lack;
};

constexpr PlaceView kPlaceViews[] = {
    {"square", square_view, "there is no open paved place in this scene"},
    {"water", water_view, "there is no open water in this scene"},
    {"river", water_view, "there is no open water in this scene"},
    {"park", park_view, "there is no lawn with trees in this scene"},
    {"hilltop", hilltop_view, "there is no hill in this scene from which its middle can be seen"},
    {"roofs", roofs_view, "nothing is built in this scene"},
    {"skyline", skyline_view, "nothing tall is built in this scene"}};

}  // namespace

std::string view_names(const char* separator) {
  std::string names = std::string("street") + separator + "low";
  for (const View& view : kOutsideViews) names += std::string(separator) + view.name;
  for (const PlaceView& view : kPlaceViews) names += std::string(separator) + view.name;
  return names;
}

Result<Camera> named_view(std::span<const bake::BakedTile> tiles, const std::string& name, std::optional<Vec3> to_sun) {
  const SceneGrid grid(tiles);
  for (const View& view : kOutsideViews)
    if (name == view.name) return outside_view(grid, view);
  const auto place = std::ranges::find(kPlaceViews, name, &PlaceView::name);
  if (name != "street" && name != "low" && place == std::end(kPlaceViews))
    return Error{"--view " + name, "expected one of " + view_names(", ")};
  const World world(tiles, grid.core_point());
  const ViewScene scene{tiles, grid, ViewProbe{world}, to_sun};
  if (name == "street") return street_view(scene);
  if (name == "low") return low_view(scene);
  const std::optional<Camera> camera = place->find(scene);
  return camera ? Result(*camera) : Error{"--view " + name, place->lack};
}

}  // namespace citykiln::preview
