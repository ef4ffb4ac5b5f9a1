// Equations: Weber, Penn, "Creation and Rendering of Realistic Trees", SIGGRAPH 1995, sections 4.1 to 4.9.
#include "lsystems/weber_penn.h"

#include <algorithm>
#include <cmath>

#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/mathematics.h"
#include "compiler/geometry/trig.h"
#include "lsystems/rewriting/turtle_frame.h"

namespace citykiln::lsystems {
namespace {

constexpr double kThinnest_m = 1e-4;

// The most steps of stems, also of those that are pruned away: some seconds.
constexpr std::uint64_t kMostWork = 20'000'000;

Vec2 turn_of(double angle_deg) { return direction_of(angle_deg / 360); }

// The angle of a heading to the vertical.
double declination_deg(const TurtleFrame& frame) { return arccosine_deg(frame.heading.z); }

// The frame rotated about the vertical.
void rotate_about_z(TurtleFrame& frame, double angle_deg) {
  const Vec2 turn = turn_of(angle_deg);
  const auto rotated = [&](Vec3 v) { return Vec3{v.x * turn.x - v.y * turn.y, v.x * turn.y + v.y * turn.x, v.z}; };
  frame.heading = rotated(frame.heading), frame.left = rotated(frame.left), frame.up = rotated(frame.up);
}

// A stem before it grows.
struct Stem {
  int level = 0;
  double length_m = 0, radius_m = 0;
  double offset_m = 0;         // of its foot along the parent
  double parent_length_m = 0;  // 0: it has no parent
  double max_length = 1;       // its Length ± LengthV
  double base_m = 0;           // the part without substems
  std::int32_t parent = kNoParent, order = 0;
};

// The state of one axis of a stem; clones copy it.
struct Axis {
  TurtleFrame frame;
  Vec3 along{0, 0, 1};      // the first heading, about which a helix turns
  int segment = 0;          // the next one
  double share = 1;         // of the stem's substems
  double next_substem = 0;  // substems that are due, from -0.5 on
  double roll_deg = 0;      // of the last substem
  double unbend_deg = 0;    // per segment, after a split
  std::int32_t last = kNoParent, order = 0;
};

// The paper's ShapeRatio(shape, ratio), for a shape of 0 to 8.
double shape_ratio(const TreeParameters& tree, int shape, double ratio) {
  ratio = std::clamp(ratio, 0.0, 1.0);
  switch (shape) {
    case 0:  // conical
      return 0.2 + 0.8 * ratio;
    case 1:  // spherical
      return 0.2 + 0.8 * sine(180 * ratio);
    case 2:  // hemispherical
      return 0.2 + 0.8 * sine(90 * ratio);
    case 3:  // cylindrical
      return 1;
    case 4:  // tapered cylindrical
      return 0.5 + 0.5 * ratio;
    case 5:  // flame
      return ratio <= 0.7 ? ratio / 0.7 : (1 - ratio) / 0.3;
    case 6:  // inverse conical
      return 1 - 0.8 * ratio;
    case 7:  // tend flame
      return ratio <= 0.7 ? 0.5 + 0.5 * ratio / 0.7 : 0.5 + 0.5 * (1 - ratio) / 0.3;
    default: {  // the envelope of pruning
      const double low = 1 - tree.prune_width_peak;
      if (ratio < low) return power(ratio / low, tree.prune_power_high);
      return tree.prune_width_peak > 0 ? power((1 - ratio) / tree.prune_width_peak, tree.prune_power_low) : 1;
    }
  }
}

class Growing {
 public:
  Growing(const TreeParameters& tree, std::uint64_t seed)
      : tree_(tree), draw_(seed, StableId{}, "tree"), scale_m_(tree.scale * tree.z_scale) {}

  GrownTree grown() {
    const StemParameters& level = tree_.level[0];
    Stem trunk{.max_length = std::max(varied(level.length, level.length_v), 0.01)};
    trunk.length_m = trunk.max_length * scale_m_;
    trunk.radius_m = trunk.length_m * tree_.ratio * std::max(varied(tree_.trunk_scale, tree_.trunk_scale_v), 0.01);
    trunk.base_m = std::min(tree_.base_size * scale_m_, 0.95 * trunk.length_m);
    grow_stem(trunk, {});
    return std::move(out_);
  }

 private:
  const StemParameters& level_of(int level) const { return tree_.level[static_cast<std::size_t>(std::min(level, 3))]; }
  double unit() { return draw_.unit(drawn_++); }
  double varied(double value, double variation) { return value + variation * (2 * unit() - 1); }
  bool is_last(const Stem& stem) const { return stem.level + 1 >= static_cast<int>(tree_.levels); }

  bool has_room() {
    const std::size_t parts = out_.skeleton.segments.size() + out_.skeleton.instances.size();
    if (parts >= kMostPlantParts || ++work_ > kMostWork) out_.stopped = true;
    return !out_.stopped;
  }

  void grow_stem(const Stem& stem, const TurtleFrame& frame) {
    Axis axis{.frame = frame, .along = frame.heading, .next_substem = -0.5, .last = stem.parent, .order = stem.order};
    start_helix(stem, axis);
    grow_axis(stem, axis, substems_of(stem));
  }

  // The number of substems, or of leaf cards, of a stem.
  double substems_of(const Stem& stem) const {
    if (is_last(stem)) return cards_of(stem);
    const double most = level_of(stem.level + 1).branches;
    if (stem.level == 0) return most;
    if (stem.level == 1) {
      const double share = stem.length_m / stem.parent_length_m / std::max(stem.max_length, 1e-6);
      return std::floor(most * (0.2 + 0.8 * std::min(share, 1.0)) + 0.5);
    }
    return std::floor(most * (1 - 0.5 * std::min(stem.offset_m / stem.parent_length_m, 1.0)) + 0.5);
  }

  double cards_of(const Stem& stem) const {
    const double at = stem.parent_length_m > 0 ? stem.offset_m / stem.parent_length_m : 1;
    const double leaves = tree_.leaves * shape_ratio(tree_, 4, at);
    return leaves > 0 ? std::max(std::floor(leaves / tree_.leaves_per_card + 0.5), 1.0) : 0;
  }

  // The remaining segments of an axis, and the clones that leave it.
  void grow_axis(const Stem& stem, Axis& axis, double substems) {
    const StemParameters& level = level_of(stem.level);
    const int segments = static_cast<int>(level.curve_res);
    while (axis.segment < segments && has_room()) {
      add_segment(stem, axis);
      add_substems(stem, axis, substems);
      axis.frame.at = axis.frame.at + axis.frame.heading * (stem.length_m / segments);
      if (++axis.segment == segments) return;
      split_axis(stem, axis, substems);
      curve(stem, axis);
    }
  }

  double radius_at(const Stem& stem, double z) const {
    const double taper = level_of(stem.level).taper, along_m = (1 - z) * stem.length_m;
    const double unit_taper = taper < 1 ? taper : (taper < 2 ? 2 - taper : 0);
    const double straight = stem.radius_m * (1 - unit_taper * z);
    if (taper < 1) return std::max(straight, kThinnest_m);
    // the end of the stem is a hemisphere, or a row of them
    const double depth = taper < 2 || along_m < straight ? 1 : taper - 2;
    const double off =
        taper < 2
            ? along_m
            : std::abs(along_m - 2 * straight * std::floor(along_m / (2 * std::max(straight, kThinnest_m)) + 0.5));
    if (taper < 2 && off >= straight) return std::max(straight, kThinnest_m);
    const double square = straight * straight - (off - straight) * (off - straight);
    return std::max((1 - depth) * straight + depth * std::sqrt(std::max(square, 0.0)), kThinnest_m);
  }

  void add_segment(const Stem& stem, Axis& axis) {
    const double segments = level_of(stem.level).curve_res;
    const auto index = static_cast<std::int32_t>(out_.skeleton.segments.size());
    out_.skeleton.segments.push_back({.start = axis.frame,
                                      .length = stem.length_m / segments,
                                      .start_radius = radius_at(stem, axis.segment / segments),
                                      .end_radius = radius_at(stem, (axis.segment + 1) / segments),
                                      .colour = 0,
                                      .parent = axis.last,
                                      .order = axis.order});
    axis.last = index;
  }

  // The substems, or leaves, that are due on the segment that was added last.
  void add_substems(const Stem& stem, Axis& axis, double substems) {
    const double segment_m = stem.length_m / level_of(stem.level).curve_res, from_m = axis.segment * segment_m;
    const double bearing_m = stem.length_m - stem.base_m, start_m = std::max(from_m, stem.base_m);
    const double per_m = bearing_m > 0 ? axis.share * substems / bearing_m : 0;
    if (from_m + segment_m <= start_m || !(per_m > 0)) return;
    const double due = axis.next_substem + per_m * (from_m + segment_m - start_m);
    // so near to a whole number that it is rounding
    constexpr double kNear = 1e-9;
    for (double k = std::floor(axis.next_substem + kNear) + 1; k <= due + kNear && has_room(); ++k)
      add_substem(stem, axis, start_m + (k - axis.next_substem) / per_m);
    axis.next_substem = due;
  }

  // The frame of a substem, rolled about the parent's axis and turned down from it.
  TurtleFrame substem_frame(const Stem& stem, Axis& axis, double offset_m) {
    const StemParameters& level = level_of(stem.level + 1);
    const double step_deg = varied(std::abs(level.rotate), level.rotate_v);
    side_ = -side_;
    axis.roll_deg = level.rotate >= 0 ? axis.roll_deg + step_deg : side_ * step_deg;
    TurtleFrame frame = axis.frame;
    frame.at = frame.at + frame.heading * (offset_m - axis.segment * stem.length_m / level_of(stem.level).curve_res);
    roll_left(frame, turn_of(axis.roll_deg));
    pitch_down(frame, turn_of(down_angle_deg(stem, level, offset_m)));
    orthonormalise(frame);
    return frame;
  }

  double down_angle_deg(const Stem& stem, const StemParameters& level, double offset_m) {
    if (level.down_angle_v >= 0) return varied(level.down_angle, level.down_angle_v);
    const double up = (stem.length_m - offset_m) / std::max(stem.length_m - stem.base_m, 1e-9);
    // the variation is a function of the height
    return level.down_angle + level.down_angle_v * (1 - 2 * shape_ratio(tree_, 0, up));
  }

  void add_substem(const Stem& stem, Axis& axis, double offset_m) {
    const TurtleFrame frame = substem_frame(stem, axis, offset_m);
    if (is_last(stem)) return add_leaf(axis, frame);
    const StemParameters& level = level_of(stem.level + 1);
    Stem child{.level = stem.level + 1,
               .offset_m = offset_m,
               .parent_length_m = stem.length_m,
               .max_length = std::max(varied(level.length, level.length_v), 0.0),
               .parent = axis.last,
               .order = axis.order + 1};
    const double up = (stem.length_m - offset_m) / std::max(stem.length_m - stem.base_m, 1e-9);
    child.length_m = stem.level == 0
                         ? stem.length_m * child.max_length * shape_ratio(tree_, static_cast<int>(tree_.shape), up)
                         : child.max_length * std::max(stem.length_m - 0.6 * offset_m, 0.0);
    child.length_m = pruned_length_m(child, frame);
    if (!(child.length_m > 1e-3)) return;
    const double thin = power(child.length_m / stem.length_m, tree_.ratio_power);
    child.radius_m = std::max(std::min(stem.radius_m * thin, radius_at(stem, offset_m / stem.length_m)), kThinnest_m);
    grow_stem(child, frame);
  }

  // A card with the area of its leaves; a spray shows leaves on two fifths of its card.
  void add_leaf(const Axis& axis, const TurtleFrame& frame) {
    constexpr double kLeafFill = 1.5;
    const double size_m =
        tree_.leaf_scale *
        std::sqrt(std::max(kLeafFill * tree_.leaf_area * tree_.leaves_per_card * tree_.leaf_scale_x, 0.01));
    out_.skeleton.instances.push_back({.kind = 0,
                                       .frame = frame,
                                       .size = size_m,
                                       .colour = static_cast<std::int32_t>(3 * unit()),
                                       .parent = axis.last,
                                       .order = axis.order + 1});
  }

  // With a negative CurveV a stem is a helix: its heading is tilted from the axis about which it turns.
  void start_helix(const Stem& stem, Axis& axis) {
    const StemParameters& level = level_of(stem.level);
    if (level.curve_v < 0) pitch_down(axis.frame, turn_of(-level.curve_v));
  }

  void curve(const Stem& stem, Axis& axis) {
    const StemParameters& level = level_of(stem.level);
    const double segments = level.curve_res;
    if (level.curve_v < 0) {
      turn_helix(axis, 360 / segments);
    } else {
      const bool is_upper = 2 * axis.segment >= segments;
      const double curve_deg =
          level.curve_back == 0 ? level.curve / segments : 2 * (is_upper ? level.curve_back : level.curve) / segments;
      pitch_down(axis.frame, turn_of(varied(curve_deg + axis.unbend_deg, level.curve_v / segments)));
    }
    attract_up(stem, axis);
    orthonormalise(axis.frame);
  }

  static void turn_helix(Axis& axis, double angle_deg) {
    const Vec2 turn = turn_of(angle_deg);
    const auto about = [&](Vec3 v) {
      return v * turn.x + cross(axis.along, v) * turn.y + axis.along * (dot(axis.along, v) * (1 - turn.x));
    };
    axis.frame.heading = about(axis.frame.heading), axis.frame.left = about(axis.frame.left);
    axis.frame.up = about(axis.frame.up);
  }

  // Stems from level 2 on turn towards the light, or hang; no farther than straight up or down.
  void attract_up(const Stem& stem, Axis& axis) const {
    if (stem.level < 2 || tree_.attraction_up == 0) return;
    const double declination = declination_deg(axis.frame) * kPi / 180;
    const double rise = length(in_plan(axis.frame.heading));
    const bool is_up = tree_.attraction_up > 0;
    const double left = is_up ? declination : kPi - declination;
    const double turn = std::abs(tree_.attraction_up) * declination * rise / level_of(stem.level).curve_res;
    if (rise > 1e-6) bend(axis.frame, {0, 0, is_up ? 1.0 : -1.0}, std::min(turn, left) / rise);
  }

  // The number of clones at the end of a segment; fractions are carried from stem to stem (error diffusion).
  int clones_after(const Stem& stem, const Axis& axis) {
    if (stem.level == 0 && axis.segment == 1 && tree_.base_splits > 0) return static_cast<int>(tree_.base_splits);
    const double splits = level_of(stem.level).seg_splits;
    double& carried = carried_[static_cast<std::size_t>(stem.level)];
    const double whole = std::floor(splits + carried + 0.5);
    carried += splits - whole;
    return static_cast<int>(std::max(whole, 0.0));
  }

  void split_axis(const Stem& stem, Axis& axis, double substems) {
    const int clones = clones_after(stem, axis);
    if (clones == 0) return;
    const StemParameters& level = level_of(stem.level);
    axis.share /= clones + 1;
    const bool is_base = stem.level == 0 && axis.segment == 1;
    const double first_roll_deg = 360 * unit();
    for (int i = 0; i < clones && has_room(); ++i) {
      Axis clone = axis;
      clone.order = axis.order + 1;
      // a clone begins in the middle between two substems
      clone.next_substem -= static_cast<double>(i + 1) / (clones + 1);
      lean(level, clone);
      rotate_about_z(clone.frame, is_base ? first_roll_deg + 360.0 * (i + 1) / (clones + 1) : spread_deg(clone));
      curve(stem, clone);
      grow_axis(stem, clone, substems);
    }
    lean(level, axis);
    if (is_base) rotate_about_z(axis.frame, first_roll_deg);
  }

  // Turns an axis away from its heading by the split's angle, and lets it come back over its remaining segments.
  void lean(const StemParameters& level, Axis& axis) {
    const double angle_deg =
        std::max(varied(level.split_angle, level.split_angle_v) - declination_deg(axis.frame), 0.0);
    pitch_down(axis.frame, turn_of(angle_deg));
    axis.unbend_deg -= angle_deg / std::max(level.curve_res - axis.segment, 1.0);
  }

  double spread_deg(const Axis& clone) {
    const double square = unit() * unit();
    const double angle_deg = 20 + 0.75 * (30 + std::abs(declination_deg(clone.frame) - 90)) * square;
    return unit() < 0.5 ? -angle_deg : angle_deg;
  }

  bool is_in_envelope(Vec3 p) const {
    const double up = (scale_m_ - p.z) / std::max(scale_m_ * (1 - tree_.base_size), 1e-9);
    if (up < 0 || up > 1) return false;
    return length(in_plan(p)) / scale_m_ < tree_.prune_width * shape_ratio(tree_, 8, up);
  }

  // True if the axis of a stem of this length, without clones, stays in the envelope.
  bool fits(Stem stem, double length_m, const TurtleFrame& frame) {
    stem.length_m = length_m;
    const std::uint32_t drawn = drawn_;
    Axis axis{.frame = frame, .along = frame.heading};
    start_helix(stem, axis);
    const double segments = level_of(stem.level).curve_res;
    bool is_in = true;
    for (axis.segment = 0; axis.segment < segments && is_in;) {
      axis.frame.at = axis.frame.at + axis.frame.heading * (length_m / segments);
      is_in = is_in_envelope(axis.frame.at);
      ++work_;
      ++axis.segment;
      curve(stem, axis);
    }
    drawn_ = drawn;
    return is_in;
  }

  double pruned_length_m(const Stem& stem, const TurtleFrame& frame) {
    constexpr double kShorter = 0.85, kLeastShare = 0.05;
    if (tree_.prune_ratio == 0) return stem.length_m;
    double length_m = stem.length_m;
    while (length_m > kLeastShare * stem.length_m && !fits(stem, length_m, frame)) length_m *= kShorter;
    if (length_m <= kLeastShare * stem.length_m) length_m = 0;
    return std::lerp(stem.length_m, length_m, tree_.prune_ratio);
  }

  const TreeParameters& tree_;
  RandomSequence draw_;
  double scale_m_, side_ = 1;
  std::uint32_t drawn_ = 0;
  std::uint64_t work_ = 0;
  std::array<double, 4> carried_{};
  GrownTree out_;
};

}  // namespace

GrownTree grow_tree(const TreeParameters& tree, std::uint64_t seed) { return Growing(tree, seed).grown(); }

}  // namespace citykiln::lsystems
