#include "preview/camera/street_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

namespace citykiln::preview {
namespace {

using materials::Material;

// The aspect ratio for which the thirds of the picture hold.
constexpr double kWide = 16.0 / 9;

// A lens of 24 mm on a frame of 36 by 24 mm, for pictures of 16 by 9.
constexpr double kStreetFov_deg = 46;

// The rise of the view over 40 m: a little more of the facades than of the road.
constexpr double kLookUp_m = 3;

constexpr double kStreetApart_m = 10;
constexpr int kAsphaltPlaces = 900, kPavedPlaces = 400, kOtherPlaces = kAsphaltPlaces + kPavedPlaces;

// Distances ahead at which walls to both sides are looked for.
constexpr std::array kStations_m = {4.0, 8.0, 13.0, 19.0, 26.0, 34.0, 44.0, 56.0};
constexpr double kFarSide_m = 18;

// Walls are looked for above cars, fences and hedges, and above shop windows.
constexpr std::array kWallHeights_m = {3.5, 6.5};

constexpr double kFarEnough_m = 150, kLeastAhead_m = 18;

constexpr int kBearings = 72;

Vec3 bearing(int number) {
  const double angle = 2 * std::numbers::pi * number / kBearings;
  return {std::cos(angle), std::sin(angle), 0};
}

Vec3 left_of(Vec3 direction) { return {-direction.y, direction.x, 0}; }

// The middle of a wall that a side ray met.
struct Wall {
  double far_m;
  OsmId building;
  bool is_sunlit;
};

// Surfaces without a map element count by their material.
bool is_frontage(const ViewScene& scene, const Hit& hit) {
  return is_built(hit.material) && (hit.feature == OsmId{} || scene.grid.has_building(hit.feature));
}

std::optional<Wall> wall_at(const ViewScene& scene, Vec3 from, Vec3 side) {
  const World& world = scene.look.world;
  for (const double above_m : kWallHeights_m) {
    const Vec3 start = from + Vec3{0, 0, above_m - kEye_m};
    const auto hit = scene.look.first_beyond_plants(start, side);
    if (!hit || hit->distance_m > kFarSide_m || !is_frontage(scene, *hit)) continue;
    const Vec3 before = start + side * (hit->distance_m - 0.3);
    const bool is_sunlit = scene.to_sun && !world.is_blocked(before - world.origin(), *scene.to_sun);
    return Wall{hit->distance_m, hit->feature, is_sunlit};
  }
  return std::nullopt;
}

// The buildings along a street, seen from a place in a direction.
struct Frontage {
  double ahead_m = 0;
  double both = 0, either = 0;  // shares of the stations that have walls on both sides, and on one
  double near = 0;              // share of the first four stations that have a wall
  double even = 0;              // share of the stations on streets beside which the ground is as high
  double walked = 0;            // share of the stations on streets that have a pavement on a side
  std::size_t buildings = 0;
  int on_street = 0, walls = 0, sunlit_left = 0, sunlit_right = 0;
  double width_m = 2 * kFarSide_m, left_m = kFarSide_m, right_m = kFarSide_m;  // the least

  int sunlit() const { return sunlit_left + sunlit_right; }
};

// True if the ground below a place is a street: not a yard, a lawn or a path in it.
bool is_on_street(const ViewScene& scene, Vec3 from) {
  const auto hit = scene.look.first_beyond_plants(from + Vec3{0, 0, 8}, {0, 0, -1});
  return hit && (is_street(hit->material) || hit->material == Material::kConcrete || hit->material == Material::kPaint);
}

// True if the ground at both sides of a place on a street is as high as below it: no bank of a road on a slope.
bool is_even_across(const ViewScene& scene, Vec3 from, Vec3 direction) {
  constexpr double kEven_m = 0.75;
  const auto below_m = [&](Vec3 p) {
    const auto hit = scene.look.first_beyond_plants(p + Vec3{0, 0, 8}, {0, 0, -1});
    return hit ? hit->distance_m : 0;
  };
  const double here_m = below_m(from);
  return std::ranges::none_of(std::array{-7.5, -4.0, 4.0, 7.5}, [&](double aside_m) {
    const double there_m = below_m(from + left_of(direction) * aside_m);
    // what is much nearer is a wall, a tree or a car
    return std::abs(there_m - here_m) > kEven_m && there_m > here_m - 6;
  });
}

// True if a pavement lies beside a place of a street.
bool has_pavement(const ViewScene& scene, Vec3 from, Vec3 direction) {
  return std::ranges::any_of(std::array{-9.0, -7.0, -5.0, -3.5, 3.5, 5.0, 7.0, 9.0}, [&](double aside_m) {
    const auto hit = scene.look.first_beyond_plants(from + left_of(direction) * aside_m, {0, 0, -1});
    return hit && (hit->material == Material::kPaving || hit->material == Material::kKerbStone);
  });
}

Frontage frontage_along(const ViewScene& scene, Vec3 eye, Vec3 direction, double ahead_m) {
  Frontage found{.ahead_m = ahead_m};
  std::set<OsmId> buildings;
  for (const double station_m : kStations_m) {
    if (station_m > ahead_m - 1) break;
    const Vec3 from = eye + direction * station_m;
    if (!is_on_street(scene, from)) continue;
    found.even += is_even_across(scene, from, direction) ? 1 : 0, found.on_street += 1;
    found.walked += has_pavement(scene, from, direction) ? 1 : 0;
    const auto left = wall_at(scene, from, left_of(direction)), right = wall_at(scene, from, left_of(direction) * -1);
    found.both += left && right ? 1.0 / kStations_m.size() : 0;
    found.either += left || right ? 1.0 / kStations_m.size() : 0;
    found.near += (left || right) && station_m <= kStations_m[3] ? 0.25 : 0;
    if (left) ++found.walls, found.left_m = std::min(found.left_m, left->far_m), buildings.insert(left->building);
    if (right) ++found.walls, found.right_m = std::min(found.right_m, right->far_m), buildings.insert(right->building);
    found.sunlit_left += left && left->is_sunlit ? 1 : 0, found.sunlit_right += right && right->is_sunlit ? 1 : 0;
    if (left && right) found.width_m = std::min(found.width_m, left->far_m + right->far_m);
  }
  found.buildings = buildings.size();
  found.even = found.on_street == 0 ? 0 : found.even / found.on_street;
  found.walked = found.on_street == 0 ? 0 : found.walked / found.on_street;
  return found;
}

// True if the ground at both sides of a place is paved for cars, as on a car park.
bool is_wide_area(const ViewScene& scene, Vec3 eye, Vec3 direction) {
  constexpr double kAside_m = 11;
  const World& world = scene.look.world;
  const auto is_paved = [&](double side) {
    const auto hit = world.first_hit(eye + left_of(direction) * (side * kAside_m) - world.origin(), {0, 0, -1});
    return hit && (is_street(hit->material) || hit->material == Material::kGravel);
  };
  return is_paved(-1) && is_paved(1);
}

double worth_of_light(const ViewScene& scene, const Frontage& found, Vec3 direction) {
  if (!scene.to_sun || found.walls == 0) return 1;
  constexpr double kEnoughLit = 0.4, kGlare = 0.8;
  const double lit = static_cast<double>(found.sunlit()) / found.walls;
  const Vec3 sun = unit({scene.to_sun->x, scene.to_sun->y, 0});
  return (0.35 + 0.65 * std::min(lit / kEnoughLit, 1.0)) * (dot(sun, direction) > kGlare ? 0.6 : 1.0);
}

double worth_of(const ViewScene& scene, const Frontage& found, Vec3 direction) {
  constexpr double kAlley_m = 6, kLane_m = 9, kBroad_m = 30, kLongEnough_m = 70;
  const double width = found.width_m < kAlley_m   ? 0.15
                       : found.width_m < kLane_m  ? 0.5
                       : found.width_m > kBroad_m ? 0.6
                                                  : 1;
  const double many = 0.4 + 0.6 * std::min(static_cast<double>(found.buildings) / 8, 1.0);
  const double length = std::sqrt(std::min(found.ahead_m / kLongEnough_m, 1.0));
  // walls near the eye fill most of the picture
  const double near = 0.3 + 0.7 * found.near, even = 0.2 + 0.8 * found.even, walked = 0.5 + 0.5 * found.walked;
  return (found.both + 0.2 * found.either + 0.02) * near * even * walked * width * many * length *
         worth_of_light(scene, found, direction);
}

// The directions in which one sees farthest, at most 4: those that see farther than their neighbours.
std::vector<std::pair<double, int>> ways_ahead(const ViewProbe& look, Vec3 eye) {
  std::array<double, kBearings> sights{};
  for (int i = 0; i < kBearings; ++i) sights[static_cast<std::size_t>(i)] = look.sight_m(eye, bearing(i), kFarEnough_m);
  const auto at = [&](int i) { return sights[static_cast<std::size_t>((i + kBearings) % kBearings)]; };
  std::vector<std::pair<double, int>> ways;
  for (int i = 0; i < kBearings; ++i)
    if (at(i) >= kLeastAhead_m && at(i) >= at(i - 1) && at(i) > at(i + 1)) ways.emplace_back(-at(i), i);
  std::ranges::sort(ways);
  if (ways.size() > 4) ways.resize(4);
  return ways;
}

// Returns the camera of a street: turned to the sunlit side, and from the side of the road opposite to it if there is
// room. Empty: something is in front of it.
std::optional<Camera> composed(const ViewScene& scene, Vec3 eye, Vec3 direction, const Frontage& found) {
  const bool is_right =
      scene.to_sun && found.sunlit() > 0 ? found.sunlit_right >= found.sunlit_left : found.left_m <= found.right_m;
  const int side = is_right ? 1 : -1;
  const double room_m = is_right ? found.left_m : found.right_m;
  for (const double share : {0.45, 0.25, 0.0}) {
    const Vec3 aside = left_of(direction) * (side * std::min(share * room_m, 5.0));
    const auto place = scene.look.place_above_ground(in_plan(eye + aside), kEye_m, scene.grid.top_m() + 10);
    if (!place) continue;
    const Camera axis{*place, *place + direction * 40 + Vec3{0, 0, kLookUp_m}, kStreetFov_deg};
    const Camera camera = found.both > 0 ? turned_by_a_third(axis, side) : axis;
    if (is_free_in_front(scene.look, camera)) return camera;
  }
  return std::nullopt;
}

// The places nearest to the core on what `counts` takes.
template <typename Counts>
std::vector<Vec3> places_on(const ViewScene& scene, Counts counts, int most_places) {
  return places_near(scene.tiles, scene.grid.core_point(), counts, kStreetApart_m, most_places);
}

// The worth of a picture's content: many things in it, and no wall that fills it. At most 1.
double worth_of_content(const PictureContent& content) {
  constexpr double kVaried_bits = 3.3;
  const double varied = std::min(content.variety_bits / kVaried_bits, 1.0);
  return varied * varied * varied * (1 - 0.8 * std::min(content.close_walls / 0.35, 1.0));
}

// Returns the best view along streets from places on them; empty: there is none.
std::optional<Camera> view_along(const ViewScene& scene, std::span<const Vec3> places) {
  std::optional<Camera> best;
  double most = 0;
  const double top_m = scene.grid.top_m() + 10;
  for (const Vec3& on : places) {
    const auto eye = scene.look.place_above_ground(in_plan(on), kEye_m, top_m);
    // not on a roof that covers the street
    if (!eye || std::abs(eye->z - kEye_m - on.z) > 3) continue;
    for (const auto& [far, number] : ways_ahead(scene.look, *eye)) {
      const double ahead_m = scene.look.walk_m(*eye, bearing(number), kFarEnough_m);
      if (ahead_m < kLeastAhead_m) continue;
      const Frontage found = frontage_along(scene, *eye, bearing(number), ahead_m);
      const double wide = is_wide_area(scene, *eye, bearing(number)) ? 0.3 : 1;
      const double value = worth_of(scene, found, bearing(number)) * wide;
      if (value <= most || (wide < 1 && found.both < 0.25)) continue;
      const auto camera = composed(scene, *eye, bearing(number), found);
      const double worth = camera ? value * worth_of_content(content_of(scene.look.world, *camera)) : 0;
      if (worth > most) most = worth, best = camera;
    }
  }
  return best;
}

// Paved places also lie on squares and platforms, which can be all there is near the core.
std::vector<Vec3> places_on_streets(const ViewScene& scene) {
  const auto is_paved = [](const bake::Primitive& p) { return p.material == Material::kPaving; };
  const auto is_asphalt = [&](const bake::Primitive& p) { return is_street(p.material) && !is_paved(p); };
  std::vector<Vec3> places = places_on(scene, is_asphalt, kAsphaltPlaces);
  const std::vector<Vec3> paved = places_on(scene, is_paved, kPavedPlaces);
  places.insert(places.end(), paved.begin(), paved.end());
  return places;
}

// Returns the view over open land with the most of what stands on it between 8 and 120 m away; empty: there is none.
std::optional<Camera> view_over_land(const ViewScene& scene) {
  constexpr double kNear_m = 8, kFar_m = 120;
  const auto is_land = [](const bake::Primitive& p) {
    return p.layer == bake::Layer::kGround && is_ground(p.material);
  };
  std::optional<Camera> best;
  int most = 0;
  for (const Vec3& on : places_on(scene, is_land, kOtherPlaces)) {
    const auto eye = scene.look.place_above_ground(in_plan(on), kEye_m, scene.grid.top_m() + 10);
    if (!eye || scene.look.room_m(*eye, 3) < 3) continue;
    for (int direction = 0; direction < kDirections; ++direction) {
      const Camera camera{*eye, *eye + horizontal(direction) * 40 + Vec3{0, 0, kLookUp_m}, kStreetFov_deg};
      int count = 0;
      for (int aside = -2; aside <= 2; ++aside)
        for (const double up : {0.03, 0.12, 0.22}) {
          const double far_m = scene.look.sight_m(*eye, unit(horizontal(direction + aside) + Vec3{0, 0, up}), kFar_m);
          count += far_m > kNear_m && far_m < kFar_m ? 1 : 0;
        }
      if (count > most && is_free_in_front(scene.look, camera)) most = count, best = camera;
    }
  }
  return best;
}

// Returns the view from above the topmost surface at the core, in the direction in which one sees farthest.
Camera view_above_core(const ViewScene& scene) {
  const Vec3 core = scene.grid.core_point();
  const double from_m = scene.grid.top_m() + 10;
  const double down_m = scene.look.sight_m(at_height(in_plan(core), from_m), {0, 0, -1}, from_m - core.z);
  const Vec3 eye = at_height(in_plan(core), from_m - down_m + kEye_m);
  int best = 0;
  for (int i = 1; i < kDirections; ++i)
    if (scene.look.sight_m(eye, horizontal(i), kFarEnough_m) > scene.look.sight_m(eye, horizontal(best), kFarEnough_m))
      best = i;
  return {eye, eye + horizontal(best) * 40 + Vec3{0, 0, 2}, kStreetFov_deg};
}

}  // namespace

bool is_free_in_front(const ViewProbe& look, const Camera& camera) {
  constexpr double kAround_m = 2, kMiddle_m = 7;
  for (const double lower_m : {0.0, 0.5, 1.1})
    if (look.room_m(camera.eye - Vec3{0, 0, lower_m}, kAround_m) < kAround_m) return false;
  const Vec3 forward = unit(camera.look_at - camera.eye), right = unit(cross(forward, {0, 0, 1}));
  for (int aside = -4; aside <= 4; ++aside)
    for (const double up : {-0.16, -0.06, 0.04, 0.14, 0.26})
      if (look.sight_m(camera.eye, unit(forward + right * (aside * 0.11) + Vec3{0, 0, up}), kMiddle_m) < kMiddle_m)
        return false;
  return true;
}

Camera turned_by_a_third(const Camera& camera, int side) {
  const double half_width = std::tan(camera.vertical_fov_deg * std::numbers::pi / 360) * kWide;
  const double angle = -side * std::atan(half_width / 3);
  const Vec3 to = camera.look_at - camera.eye;
  const Vec3 turned{to.x * std::cos(angle) - to.y * std::sin(angle), to.x * std::sin(angle) + to.y * std::cos(angle),
                    to.z};
  Camera other = camera;
  other.look_at = camera.eye + turned;
  return other;
}

Camera street_view(const ViewScene& scene) {
  const auto is_path = [](const bake::Primitive& p) {
    return p.layer == bake::Layer::kRoads && (p.material == Material::kGravel || p.material == Material::kEarth);
  };
  if (const auto camera = view_along(scene, places_on_streets(scene))) return *camera;
  if (const auto camera = view_along(scene, places_on(scene, is_path, kOtherPlaces))) return *camera;
  if (const auto camera = view_over_land(scene)) return *camera;
  return view_above_core(scene);
}

}  // namespace citykiln::preview
