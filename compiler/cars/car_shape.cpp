#include "compiler/cars/car_shape.h"

#include <algorithm>

#include "compiler/cars/car_mesh.h"

namespace citykiln::cars {
namespace {

using Profile = std::vector<Vec2>;  // along, value

#define CAR_SHAPE(body, sill, wheel, front, rear, nose, from, cowl, to, rear_from, rear_to, tail, belt, rear_belt, \
                  lean, corner, clad, ...)                                                                         \
  if (form.value == body) {                                                                                        \
    static constexpr double kWindows[] = __VA_ARGS__;                                                              \
    return CarShape{body, sill,   wheel,     front,    rear,         nose,         from,                           \
                    cowl, to,     rear_from, rear_to,  tail,         belt,         rear_belt,                      \
                    lean, corner, clad,      kWindows, form.width_m, form.depth_m, form.height_m};                 \
  }

}  // namespace

std::optional<CarShape> shape_of(const things::Form& form) {
  if (form.kind != kCar && form.kind != kCarParts) return std::nullopt;
#include "compiler/cars/car_shapes.inc"
  return std::nullopt;
}
#undef CAR_SHAPE

namespace {

// The value of a profile, whose places along rise.
double value_at(const Profile& profile, double along_m) {
  const auto after = std::ranges::find_if(profile, [&](Vec2 p) { return p.x >= along_m; });
  if (after == profile.begin()) return profile.front().y;
  if (after == profile.end()) return profile.back().y;
  const Vec2 a = *(after - 1), b = *after;
  return a.y + (b.y - a.y) * (along_m - a.x) / (b.x - a.x);
}

// The cab of a lorry ends before its load.
double body_end_m(const CarShape& shape) { return shape.body == "lorry" ? shape.rear_to_m + 0.02 : shape.length_m; }
double roof_m(const CarShape& shape) { return shape.body == "lorry" ? 2.3125 : shape.height_m; }

// The outline of the middle, from the bonnet over the roof to the tail.
Profile top_of(const CarShape& s) {
  const double roof = roof_m(s), roof_long = s.rear_from_m - s.screen_to_m,
               screen_long = s.screen_to_m - s.screen_from_m;
  const double back_long = s.rear_to_m - s.rear_from_m, rise = s.cowl_m - s.nose_m;
  return {{0, s.nose_m},
          {0.12 * s.screen_from_m + 0.02, s.nose_m + 0.25 * rise},
          {0.5 * s.screen_from_m + 0.025, s.nose_m + 0.66 * rise},
          {s.screen_from_m, s.cowl_m},
          {s.screen_from_m + 0.5 * screen_long, s.cowl_m + 0.54 * (roof - 0.06 - s.cowl_m)},
          {s.screen_to_m, roof - 0.06},
          {s.screen_to_m + 0.2 * roof_long, roof - 0.015},
          {s.screen_to_m + 0.45 * roof_long, roof},
          {s.screen_to_m + 0.8 * roof_long, roof - 0.022},
          {s.rear_from_m, roof - 0.065},
          {s.rear_from_m + 0.5 * back_long, s.tail_m + 0.53 * (roof - 0.065 - s.tail_m)},
          {s.rear_to_m, s.tail_m},
          {body_end_m(s), s.tail_m - 0.03}};
}

Profile half_width_of(const CarShape& s) {
  const double half = s.width_m / 2, end = body_end_m(s), c = s.corner_m;
  return {
      {0, half - 0.8 * c}, {0.22 * c, half - 0.42 * c},     {0.75 * c, half - 0.14 * c},       {2.2 * c, half},
      {end - 2 * c, half}, {end - 0.6 * c, half - 0.1 * c}, {end - 0.18 * c, half - 0.32 * c}, {end, half - 0.62 * c}};
}

Profile belt_of(const CarShape& s) { return {{s.screen_from_m, s.belt_m}, {s.rear_from_m, s.rear_belt_m}}; }

void add_places(const Profile& profile, std::vector<double>& places) {
  for (const Vec2 p : profile) places.push_back(p.x);
}

void sort_unique(std::vector<double>& places) {
  constexpr double kSame_m = 0.004;
  std::ranges::sort(places);
  places.erase(std::unique(places.begin(), places.end(), [](double a, double b) { return b - a < kSame_m; }),
               places.end());
}

// How far a point of an end lies behind it: bodies are round in plan there, and lean back above the bumper.
double behind_m(const CarShape& s, Vec3 p, double half_width_m, double from_end_m, double lean_m) {
  const double fade = std::max(0.0, 1 - from_end_m / (2.5 * s.corner_m));
  const double out = p.x / half_width_m, bumper = s.sill_m + 0.25, high = std::max(0.0, p.z - bumper) / 0.5;
  const double low = std::max(0.0, bumper - 0.12 - p.z) / 0.2;
  return fade * (0.35 * s.corner_m * out * out + lean_m * std::min(1.0, high * high) + 0.03 * low);
}

}  // namespace

bool is_bed(const CarShape& shape, double along_m) {
  return shape.body == "pickup" && along_m > shape.rear_to_m + 0.06 && along_m < shape.length_m - 0.06;
}

Sections::Sections(const CarShape& shape) {
  add_places(top_of(shape), keys_);
  add_places(half_width_of(shape), keys_);
  if (shape.body == "pickup")
    for (const double along_m :
         {shape.rear_to_m + 0.055, shape.rear_to_m + 0.065, shape.length_m - 0.065, shape.length_m - 0.055})
      keys_.push_back(along_m);
  sort_unique(keys_);
  add_places(half_width_of(shape), side_keys_);
  for (const Vec2 p : top_of(shape))
    if (p.x <= shape.screen_from_m || p.x >= shape.rear_from_m) side_keys_.push_back(p.x);
  sort_unique(side_keys_);
  for (const double along_m : keys_) sections_.push_back(key_section(shape, along_m));
}

Section Sections::key_section(const CarShape& s, double along_m) const {
  const double end = body_end_m(s), w = value_at(half_width_of(s), along_m), top = value_at(top_of(s), along_m);
  const double belt = std::min(value_at(belt_of(s), along_m), top - 0.045), wide = s.sill_m + 0.55 * (belt - s.sill_m);
  const double above = top - belt, side = std::max(0.4, w - 0.05 - s.lean * above * 0.86);
  const double edge = side - std::min(0.07, 0.03 + 0.1 * above);
  const bool is_open = is_bed(s, along_m);
  const double floor = is_open ? s.wheel_m * 2 - 0.05 : top;
  Section section{{{w * 0.93, 0, s.sill_m},
                   {w * 0.985, 0, s.sill_m + 0.13},
                   {w, 0, wide},
                   {w * 0.988, 0, belt - 0.09},
                   {w - 0.035, 0, belt},
                   {w - 0.05, 0, belt + std::min(0.025, above * 0.2)},
                   {side, 0, belt + above * (above < 0.2 ? 0.75 : 0.87)},
                   {edge, 0, belt + above * (above < 0.2 ? 0.93 : 0.965)},
                   {is_open ? edge - 0.01 : edge * 0.55, 0, is_open ? floor : top - 0.006},
                   {0, 0, floor}}};
  const double front_lean_m = std::min(0.12, 0.4 * s.corner_m), rear_lean_m = 0.4 * front_lean_m;
  for (Vec3& p : section)
    p.y = along_m + behind_m(s, p, s.width_m / 2, along_m, front_lean_m) -
          behind_m(s, p, s.width_m / 2, end - along_m, rear_lean_m);
  return section;
}

Section Sections::at(double along_m) const {
  const auto after = std::ranges::find_if(keys_, [&](double key) { return key >= along_m; });
  if (after == keys_.end()) return sections_.back();
  const auto i = static_cast<std::size_t>(after - keys_.begin());
  if (i == 0 || *after == along_m) return sections_[i];
  const double share = (along_m - keys_[i - 1]) / (keys_[i] - keys_[i - 1]);
  Section section{};
  for (std::size_t j = 0; j < kSectionPoints; ++j)
    section[j] = sections_[i - 1][j] + (sections_[i][j] - sections_[i - 1][j]) * share;
  return section;
}

}  // namespace citykiln::cars
