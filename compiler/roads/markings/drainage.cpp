#include "compiler/roads/markings/drainage.h"

#include <algorithm>
#include <array>

#include "compiler/map/land_cover_class.h"
#include "compiler/materials/material.h"
#include "compiler/roads/markings/marking_rules.h"

namespace citykiln::roads {
namespace {

using materials::Material;
using Texel = materials::TextureImage::Texel;

constexpr Texel kIron = {58, 56, 54}, kSlot = {24, 23, 22}, kSett = {122, 119, 114}, kJoint = {86, 83, 79},
                kChannel = {158, 154, 146}, kChannelJoint = {116, 112, 105};

struct Gutter {
  double width_m, joint_every_m, joint_m;
  Texel colour, joint;
};
constexpr Gutter kSetts = {.width_m = 0.3, .joint_every_m = 0.25, .joint_m = 0.03, .colour = kSett, .joint = kJoint};
constexpr Gutter kConcrete = {
    .width_m = 0.45, .joint_every_m = 1, .joint_m = 0.04, .colour = kChannel, .joint = kChannelJoint};

const Gutter& gutter_of(const MarkingLayout& layout) {
  const bool is_setts = layout.practice == MarkingPractice::kVienna && layout.side == map::DrivingSide::kRight;
  return is_setts ? kSetts : kConcrete;
}

bool has_drainage(const MarkingLayout& layout) {
  constexpr double kLeastWidth_m = 1.5;
  const Material material = map::values_of(layout.surface).material;
  return layout.panel_m == 0 && !layout.lanes.empty() && !layout.lanes.front().is_raised &&
         (material == Material::kAsphalt || material == Material::kOldAsphalt) && width_m(layout) >= kLeastWidth_m;
}

void add_gutter(double left_m, double right_m, double length_m, const Gutter& gutter, Marks& marks) {
  marks.push_back({rectangle({left_m, 0}, {right_m, length_m}), gutter.colour});
  for (double v_m = gutter.joint_every_m / 2; v_m < length_m; v_m += gutter.joint_every_m)
    marks.push_back({rectangle({left_m, v_m - gutter.joint_m / 2}, {right_m, v_m + gutter.joint_m / 2}), gutter.joint});
}

// An iron grate with its slots along the road, in the middle of the layout.
void add_gully(double left_m, double right_m, Marks& marks) {
  constexpr double kHalfLength_m = 0.25, kHalfSlot_m = 0.2, kSlot_m = 0.03;
  constexpr int kSlots = 4;
  const double middle_m = kLayoutLength_m / 2, step_m = (right_m - left_m) / (kSlots + 1);
  marks.push_back({rectangle({left_m, middle_m - kHalfLength_m}, {right_m, middle_m + kHalfLength_m}), kIron});
  for (int i = 1; i <= kSlots; ++i) {
    const double u_m = left_m + i * step_m;
    marks.push_back(
        {rectangle({u_m - kSlot_m / 2, middle_m - kHalfSlot_m}, {u_m + kSlot_m / 2, middle_m + kHalfSlot_m}), kSlot});
  }
}

Ring twelve_gon(Vec2 middle, double radius_m) {
  constexpr double kCos30 = 0.8660254037844386;
  constexpr std::array<Vec2, 3> kQuarter = {{{1, 0}, {kCos30, 0.5}, {0.5, kCos30}}};
  Ring ring;
  for (Vec2 turn = {1, 0}; ring.size() < 4 * kQuarter.size(); turn = left_of(turn))
    for (const Vec2 corner : kQuarter) ring.push_back(middle + (turn * corner.x + left_of(turn) * corner.y) * radius_m);
  return ring;
}

void add_cover(Vec2 middle, Marks& marks) {
  constexpr double kRadius_m = 0.3, kFrame_m = 0.06;
  marks.push_back({twelve_gon(middle, kRadius_m + kFrame_m), kJoint});
  marks.push_back({twelve_gon(middle, kRadius_m), kIron});
}

// The covers of a strip before its junction: one in the middle of a lane, a second one beside an axis between lanes.
void add_covers(const MarkingLayout& layout, Marks& marks) {
  constexpr double kFirst_m = 2.5, kSecond_m = 8, kBeside_m = 0.7;
  const std::vector<double> sides_m = lane_sides_m(layout);
  for (std::size_t i = 0; i < layout.lanes.size(); ++i) {
    if (!is_driven(layout.lanes[i]) || layout.lanes[i].width_m < 2 * kBeside_m) continue;
    add_cover({(sides_m[i] + sides_m[i + 1]) / 2, kFirst_m}, marks);
    return add_cover({sides_m[i + 1] - kBeside_m, kSecond_m}, marks);
  }
}

}  // namespace

Marks drainage_of(const MarkingLayout& layout) {
  if (!has_drainage(layout) || !(layout.has_kerb_left || layout.has_kerb_right)) return {};
  if (layout.stretch == StretchKind::kStart)
    return turned_round(drainage_of(turned_round(layout)), width_m(layout), length_m(layout));
  const Gutter& gutter = gutter_of(layout);
  const double whole_m = width_m(layout), length_m = roads::length_m(layout);
  const bool has_gullies = length_m == kLayoutLength_m;
  Marks marks;
  const auto add_side = [&](double left_m, double right_m) {
    add_gutter(left_m, right_m, length_m, gutter, marks);
    if (has_gullies) add_gully(left_m, right_m, marks);
  };
  if (layout.has_kerb_left) add_side(0, gutter.width_m);
  if (layout.has_kerb_right) add_side(whole_m - gutter.width_m, whole_m);
  if (layout.stretch == StretchKind::kEnd) add_covers(layout, marks);
  return marks;
}

}  // namespace citykiln::roads
