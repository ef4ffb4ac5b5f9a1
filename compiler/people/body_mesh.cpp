#include "compiler/people/body_mesh.h"

#include <algorithm>
#include <array>
#include <vector>

#include "compiler/geometry/snap.h"
#include "compiler/people/loft.h"

namespace citykiln::people {
namespace {

using materials::Tint;

// Lengths are those of a person of this height; all is scaled.
constexpr double kModel_m = 1.75;
// Errors of the three levels for a person of 1 m, and the least tolerances at which they are shown: at the usual one of
// 0.5 m a person still has two legs.
constexpr std::array<double, 3> kErrors = {0, 0.2, 0.21}, kShownFrom = {0, 0.2, 0.35};

// The joints of one side. The upper body of a pose is moved by `lift`.
struct LegJoints {
  Vec3 hip, knee, ankle, toes;  // toes: the direction of the foot, length 1
};
struct ArmJoints {
  Vec3 shoulder, elbow, wrist;
};
struct Skeleton {
  std::array<LegJoints, 2> legs;  // at x > 0, the left one of who faces -y, then the other
  std::array<ArmJoints, 2> arms;
  Vec3 lift{};
};

// Half widths and depths of a trunk, from the hips to the neck.
struct Trunk {
  double hips, hips_deep, waist, waist_deep, chest, chest_deep, shoulders, arms_at;
};

Trunk trunk_of(const Look& look) {
  Trunk trunk{.hips = 0.165,
              .hips_deep = 0.118,
              .waist = 0.15,
              .waist_deep = 0.112,
              .chest = 0.185,
              .chest_deep = 0.128,
              .shoulders = 0.185,
              .arms_at = 0.193};
  if (look.figure == Figure::kWoman)
    trunk = {.hips = 0.172,
             .hips_deep = 0.122,
             .waist = 0.126,
             .waist_deep = 0.098,
             .chest = 0.16,
             .chest_deep = 0.128,
             .shoulders = 0.155,
             .arms_at = 0.166};
  if (look.figure == Figure::kChild)
    trunk = {.hips = 0.165,
             .hips_deep = 0.125,
             .waist = 0.152,
             .waist_deep = 0.118,
             .chest = 0.168,
             .chest_deep = 0.122,
             .shoulders = 0.155,
             .arms_at = 0.17};
  const double wide = look.season == Season::kCold ? 1.12 : look.season == Season::kMild ? 1.05 : 1;
  for (double* m : {&trunk.hips, &trunk.hips_deep, &trunk.waist, &trunk.waist_deep, &trunk.chest, &trunk.chest_deep})
    *m *= wide;
  trunk.arms_at += 0.1 * (wide - 1);
  return trunk;
}

LegJoints leg(double x, double knee_y, double knee_z, Vec3 ankle, Vec3 toes) {
  return {{0.09 * x, 0, 0.9},
          {0.097 * x, knee_y, knee_z},
          {ankle.x * x, ankle.y, ankle.z},
          unit(Vec3{toes.x * x, toes.y, toes.z})};
}

LegJoints straight_leg(double x) { return leg(x, -0.012, 0.49, {0.1, 0.025, 0.085}, {0.22, -1, 0}); }
LegJoints eased_leg(double x) { return leg(x, -0.09, 0.5, {0.15, -0.05, 0.085}, {0.4, -1, 0}); }

ArmJoints arm(double x, double at_m, Vec3 elbow, Vec3 wrist) {
  return {{at_m * x, 0, 1.385}, {(at_m + elbow.x) * x, elbow.y, elbow.z}, {(at_m + wrist.x) * x, wrist.y, wrist.z}};
}

ArmJoints hanging_arm(double x, double at_m) { return arm(x, at_m, {0.045, 0.02, 1.12}, {0.04, -0.05, 0.87}); }

Skeleton walking(double at_m) {
  return {
      {leg(1, -0.19, 0.515, {0.07, -0.3, 0.11}, {0.06, -1, 0.2}),
       leg(-1, 0.055, 0.475, {0.075, 0.33, 0.185}, {0.06, -0.75, -0.75})},
      {arm(1, at_m, {0.05, 0.14, 1.14}, {0.045, 0.17, 0.89}), arm(-1, at_m, {0.05, -0.06, 1.12}, {0.0, -0.24, 0.95})},
      {0, -0.015, -0.025}};
}

Skeleton sitting(double at_m) {
  const auto seated = [](double x) {
    LegJoints joints = leg(x, -0.43, 0.5, {0.12, -0.4, 0.085}, {0.15, -1, 0});
    joints.hip = {0.09 * x, 0, 0.53};
    return joints;
  };
  const double lap_z = 0.63 + 0.37;
  return {{seated(1), seated(-1)},
          {arm(1, at_m, {0.06, -0.04, 1.13}, {-0.05, -0.27, lap_z}),
           arm(-1, at_m, {0.06, -0.04, 1.13}, {-0.07, -0.25, lap_z})},
          {0, 0, -0.37}};
}

Skeleton skeleton_of(const Look& look, double at_m) {
  Skeleton standing{{straight_leg(1), eased_leg(-1)}, {hanging_arm(1, at_m), hanging_arm(-1, at_m)}};
  switch (look.pose) {
    case Pose::kWalk:
      return walking(at_m);
    case Pose::kSit:
      return sitting(at_m);
    case Pose::kPhone:
      standing.arms[1] = arm(-1, at_m, {0.03, -0.03, 1.13}, {-0.09, -0.24, 1.24});
      return standing;
    case Pose::kPockets:
      for (const int i : {0, 1}) standing.arms[i] = arm(i == 0 ? 1 : -1, at_m, {0.085, 0.07, 1.15}, {0.0, -0.07, 0.95});
      return standing;
    default:
      return standing;
  }
}

bool has_bare_legs(const Look& look) { return look.season == Season::kWarm && look.legs != LegWear::kTrousers; }
bool has_skirt(const Look& look) { return look.legs == LegWear::kSkirt || look.legs == LegWear::kDress; }

// Makes the parts of a body of kModel_m.
struct BodyMaker {
  const Look& look;
  Trunk trunk = trunk_of(look);
  Skeleton bones = skeleton_of(look, trunk.arms_at);
  materials::MaterialMesh mesh{.mesh = {}, .material = materials::Material::kPaint, .feature = {}};

  Ring3 trunk_ring(double z, double wide, double deep, double y = 0) const {
    return level_ring(bones.lift + Vec3{0, y, z}, wide, deep);
  }

  void add_leg(const LegJoints& joints) {
    const bool is_bare = has_bare_legs(look);
    const double loose = is_bare ? 1 : 1.12, thigh = has_skirt(look) ? 0.074 : 0.088;
    const auto between = [](Vec3 a, Vec3 b, double share) { return a + (b - a) * share; };
    const std::array<Joint, 4> lower = {{{joints.ankle, 0.043 * loose},
                                         {between(joints.knee, joints.ankle, 0.3), 0.06 * loose},
                                         {joints.knee, 0.059 * loose},
                                         {joints.hip, thigh}}};
    add_limb(lower, 6, 1.06, is_bare ? look.skin : look.bottom, mesh);
    if (look.legs == LegWear::kShorts && is_bare)
      add_limb(std::array<Joint, 2>{{{between(joints.hip, joints.knee, 0.72), 0.086}, {joints.hip, 0.095}}}, 6, 1.06,
               look.bottom, mesh);
    add_shoe(joints);
  }

  void add_shoe(const LegJoints& joints) {
    const Vec3 toes = joints.toes, up = unit(Vec3{0, 0, 1} - toes * toes.z), across = cross(toes, up);
    const auto ring = [&](double ahead, double half_width, double low, double high) {
      const Vec3 at = joints.ankle + toes * ahead + up * ((low + high) / 2);
      return Ring3{at, across * -half_width, up * ((high - low) / 2)};
    };
    std::array<Ring3, 3> rings = {
        {ring(-0.065, 0.034, -0.084, 0.004), ring(0.08, 0.047, -0.086, -0.012), ring(0.2, 0.028, -0.08, -0.05)}};
    // the ankle is 8 cm above the sole; rings turn about the toes
    for (Ring3& turned : rings)
      if (dot(cross(turned.u, turned.v), toes) < 0) turned.u = turned.u * -1.0;
    add_loft(rings, 5, look.shoes, mesh);
  }

  void add_hips() {
    if (has_skirt(look)) return add_skirt();
    const Vec3 seat = bones.legs[0].hip + (bones.legs[1].hip - bones.legs[0].hip) * 0.5;
    const double z = seat.z - 0.9;
    const std::array<Ring3, 3> rings = {{level_ring({seat.x, seat.y, z + 0.79}, 0.12, 0.085),
                                         level_ring({seat.x, seat.y, z + 0.87}, trunk.hips, trunk.hips_deep),
                                         level_ring({seat.x, seat.y, z + 1.0}, trunk.waist * 1.03, trunk.waist_deep)}};
    add_loft(rings, 8, look.bottom, mesh);
  }

  void add_skirt() {
    if (look.pose == Pose::kSit) {
      for (const LegJoints& joints : bones.legs)
        add_limb(std::array<Joint, 3>{{{joints.knee + (joints.hip - joints.knee) * 0.06, 0.085},
                                       {joints.knee + (joints.hip - joints.knee) * 0.5, 0.1},
                                       {joints.hip, 0.11}}},
                 7, 1.0, look.bottom, mesh);
      const std::array<Ring3, 2> rings = {
          {trunk_ring(0.8, 0.17, 0.12), trunk_ring(1.02, trunk.waist, trunk.waist_deep)}};
      return add_loft(rings, 9, look.bottom, mesh);
    }
    const double stride = look.pose == Pose::kWalk ? 0.11 : 0.02;
    const std::array<Ring3, 4> rings = {
        {trunk_ring(0.53, 0.215, 0.165 + stride), trunk_ring(0.72, 0.205, 0.15 + stride / 2),
         trunk_ring(0.88, trunk.hips * 1.04, trunk.hips_deep * 1.04), trunk_ring(1.04, trunk.waist, trunk.waist_deep)}};
    add_loft(rings, 8, look.bottom, mesh);
  }

  // From the hem to the neck.
  void add_top() {
    std::vector<Ring3> rings;
    const bool has_coat = look.season == Season::kCold && look.pose != Pose::kSit && look.figure != Figure::kChild;
    if (has_coat)
      rings.push_back(
          trunk_ring(0.64, trunk.hips * 1.15, trunk.hips_deep * 1.3 + (look.pose == Pose::kWalk ? 0.08 : 0.02)));
    const double hem = look.season == Season::kWarm ? 0.93 : 0.85;
    if (!has_coat) rings.push_back(trunk_ring(hem, trunk.hips * 1.04, trunk.hips_deep * 1.05));
    if (has_coat) rings.push_back(trunk_ring(0.86, trunk.hips * 1.06, trunk.hips_deep * 1.1));
    rings.push_back(trunk_ring(1.07, trunk.waist * 1.05, trunk.waist_deep * 1.06));
    rings.push_back(trunk_ring(1.27, trunk.chest, trunk.chest_deep, -0.008));
    rings.push_back(trunk_ring(1.385, trunk.shoulders * 1.06, trunk.chest_deep * 0.86, 0.004));
    rings.push_back(trunk_ring(1.44, trunk.shoulders * 0.74, trunk.chest_deep * 0.62, 0.012));
    rings.push_back(trunk_ring(1.475, 0.072, 0.068, 0.012));
    add_loft(rings, 8, look.top, mesh);
  }

  void add_arm(const ArmJoints& joints) {
    const Vec3 shoulder = joints.shoulder + bones.lift, elbow = joints.elbow + bones.lift,
               wrist = joints.wrist + bones.lift;
    const bool is_bare = look.season == Season::kWarm;
    const double thick = is_bare ? 1 : look.season == Season::kMild ? 1.15 : 1.3;
    const Vec3 middle = elbow + (shoulder - elbow) * 0.4;
    // the sleeve ends in the trunk, below the neck
    const Joint top{shoulder + Vec3{shoulder.x * -0.28, 0.004, 0.045}, 0.03};
    const Joint round{shoulder, 0.056 * thick}, fore{elbow, 0.041 * thick}, end{wrist, 0.029 * thick};
    if (is_bare) {
      add_limb(std::array<Joint, 3>{{end, fore, {middle, 0.043}}}, 5, 1.05, look.skin, mesh);
      add_limb(std::array<Joint, 3>{{{middle, 0.056}, round, top}}, 6, 1.05, look.top, mesh);
    } else {
      add_limb(std::array<Joint, 4>{{end, fore, round, top}}, 6, 1.05, look.top, mesh);
    }
    const Vec3 ahead = unit(wrist - elbow);
    add_limb(std::array<Joint, 3>{{{wrist + ahead * 0.17, 0.016}, {wrist + ahead * 0.09, 0.036}, {wrist, 0.026}}}, 4,
             1.4, look.skin, mesh);
  }

  void add_head() {
    const bool is_child = look.figure == Figure::kChild;
    const double size = is_child ? 1.32 : look.figure == Figure::kWoman ? 1 : 1.04;
    const auto ring = [&](double z, double wide, double deep, double y) {
      return level_ring(bones.lift + Vec3{0, y * size, 1.5 + (z - 1.5) * size - (is_child ? 0.07 : 0)}, wide * size,
                        deep * size);
    };
    const double neck = look.figure == Figure::kWoman ? 0.046 : 0.056;
    add_loft(std::array<Ring3, 2>{{trunk_ring(1.42, neck * 1.15, neck * 1.1, 0.012), ring(1.57, neck, neck, 0.008)}}, 6,
             look.skin, mesh);
    const std::array<Ring3, 6> head = {{ring(1.513, 0.03, 0.036, -0.05), ring(1.545, 0.055, 0.07, -0.022),
                                        ring(1.6, 0.071, 0.092, -0.008), ring(1.66, 0.076, 0.098, 0),
                                        ring(1.715, 0.066, 0.086, 0.004), ring(1.745, 0.036, 0.046, 0.006)}};
    add_loft(head, 8, look.skin, mesh);
    const std::array<Ring3, 2> nose = {{ring(1.592, 0.017, 0.026, -0.098), ring(1.645, 0.008, 0.01, -0.09)}};
    add_loft(nose, 3, look.skin, mesh);
    if (look.has_cap) return add_cap(ring), add_hair_below(ring);
    if (look.hair_cut == HairCut::kBald) return;
    add_hair(ring);
    add_hair_below(ring);
  }

  template <typename RingAt>
  void add_cap(RingAt ring) {
    const std::array<Ring3, 4> rings = {{ring(1.662, 0.083, 0.106, 0.004), ring(1.7, 0.084, 0.107, 0.006),
                                         ring(1.745, 0.062, 0.08, 0.008), ring(1.772, 0.026, 0.032, 0.01)}};
    add_loft(rings, 8, look.cap, mesh);
  }

  // Hair lies about the back of the head; its front is within the face.
  template <typename RingAt>
  void add_hair(RingAt ring) {
    const std::array<Ring3, 5> rings = {{ring(1.575, 0.058, 0.06, 0.048), ring(1.625, 0.082, 0.082, 0.038),
                                         ring(1.685, 0.087, 0.098, 0.022), ring(1.735, 0.071, 0.096, 0.008),
                                         ring(1.764, 0.034, 0.05, 0.006)}};
    add_loft(rings, 8, look.hair, mesh);
  }

  template <typename RingAt>
  void add_hair_below(RingAt ring) {
    if (look.hair_cut == HairCut::kLong)
      add_loft(std::array<Ring3, 3>{{ring(1.42, 0.055, 0.022, 0.098), ring(1.52, 0.082, 0.045, 0.078),
                                     ring(1.65, 0.086, 0.066, 0.052)}},
               7, look.hair, mesh);
    if (look.hair_cut == HairCut::kBun)
      add_loft(std::array<Ring3, 4>{{ring(1.655, 0.02, 0.02, 0.14), ring(1.675, 0.042, 0.038, 0.142),
                                     ring(1.705, 0.04, 0.036, 0.138), ring(1.725, 0.016, 0.016, 0.13)}},
               6, look.hair, mesh);
  }

  void add_bag() {
    const Vec3 wrist = bones.arms[0].wrist + bones.lift;
    const double back = trunk.chest_deep + 0.06;
    switch (look.bag) {
      case Bag::kBackpack:
        return add_loft(
            std::array<Ring3, 4>{{trunk_ring(0.98, 0.13, 0.07, back), trunk_ring(1.06, 0.15, 0.1, back),
                                  trunk_ring(1.3, 0.145, 0.085, back), trunk_ring(1.41, 0.09, 0.05, back - 0.02)}},
            8, look.bag_colour, mesh);
      case Bag::kShoulderBag:
        add_loft(std::array<Ring3, 3>{{trunk_ring_at(-trunk.hips - 0.075, 0.05, 0.8, 0.05, 0.15),
                                       trunk_ring_at(-trunk.hips - 0.07, 0.05, 0.9, 0.055, 0.16),
                                       trunk_ring_at(-trunk.hips - 0.06, 0.05, 1.03, 0.03, 0.13)}},
                 6, look.bag_colour, mesh);
        return add_strap();
      case Bag::kCarrierBag:
        return add_loft(std::array<Ring3, 3>{{level_ring(wrist + Vec3{0.02, 0, -0.47}, 0.06, 0.15),
                                              level_ring(wrist + Vec3{0.02, 0, -0.25}, 0.065, 0.16),
                                              level_ring(wrist + Vec3{0.01, 0, -0.1}, 0.015, 0.04)}},
                        6, look.bag_colour, mesh);
      default:
        return;
    }
  }

  Ring3 trunk_ring_at(double x, double y, double z, double wide, double deep) const {
    return level_ring(bones.lift + Vec3{x, y, z}, wide, deep);
  }

  // From the bag to the shoulder above it.
  void add_strap() {
    const Vec3 low = bones.lift + Vec3{-trunk.hips - 0.05, 0.03, 1.02},
               high = bones.lift + Vec3{-trunk.shoulders * 0.72, 0.01, 1.45};
    add_limb(std::array<Joint, 2>{{{low, 0.013}, {high, 0.02}}}, 4, 3.2, look.bag_colour, mesh);
  }

  void add_all() {
    for (const LegJoints& joints : bones.legs) add_leg(joints);
    add_hips();
    add_top();
    for (const ArmJoints& joints : bones.arms) add_arm(joints);
    add_head();
    add_bag();
  }

  // Legs, a trunk as wide as the arms, and a head, of four sides each.
  void add_coarse_parts() {
    for (const LegJoints& joints : bones.legs) {
      const Vec3 sole = joints.ankle + Vec3{0, -0.04, -0.085};
      add_limb(std::array<Joint, 3>{{{sole, 0.075}, {joints.knee, 0.08}, {joints.hip, 0.11}}}, 4, 1.1, look.bottom,
               mesh);
    }
    const double wide = trunk.arms_at + 0.06;
    add_loft(std::array<Ring3, 3>{{trunk_ring(0.85, wide * 1.1, 0.17), trunk_ring(1.25, wide * 1.25, 0.18),
                                   trunk_ring(1.47, wide * 0.9, 0.1)}},
             4, look.top, mesh);
    add_loft(std::array<Ring3, 2>{{trunk_ring(1.47, 0.08, 0.09), trunk_ring(1.75, 0.085, 0.12)}}, 4, look.hair, mesh);
  }

  void add_outline() {
    const Vec3 hips = (bones.legs[0].hip + bones.legs[1].hip) * 0.5;
    const Vec3 knees = (bones.legs[0].knee + bones.legs[1].knee) * 0.5;
    const Vec3 feet = (bones.legs[0].ankle + bones.legs[1].ankle) * 0.5;
    const std::array<Joint, 3> legs = {{{{feet.x, feet.y, 0}, 0.16}, {knees, 0.17}, {hips, 0.19}}};
    add_limb(std::array<Joint, 2>{{legs[0], legs[2]}}, 3, 1.2, look.bottom, mesh);
    add_loft(std::array<Ring3, 2>{{trunk_ring(0.86, 0.28, 0.2), trunk_ring(1.72, 0.15, 0.13)}}, 3, look.top, mesh);
  }
};

int level_of(double height_m, double tolerance_m) {
  int level = 2;
  while (kShownFrom[static_cast<std::size_t>(level)] * height_m > tolerance_m) --level;
  return level;
}

}  // namespace

BodyMesh body_mesh(const Look& look, double tolerance_m) {
  if (look.height_m <= tolerance_m) return {{.mesh = {}, .feature = {}}, look.height_m};
  const int level = level_of(look.height_m, tolerance_m);
  BodyMaker maker{look};
  if (level == 0)
    maker.add_all();
  else if (level == 1)
    maker.add_coarse_parts();
  else
    maker.add_outline();
  const double scale = look.height_m / kModel_m;
  for (Vec3& p : maker.mesh.mesh.positions) p = snapped(p * scale);
  smooth(maker.mesh.mesh);
  return {std::move(maker.mesh), kErrors[static_cast<std::size_t>(level)] * look.height_m};
}

}  // namespace citykiln::people
