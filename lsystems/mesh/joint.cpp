#include "lsystems/mesh/joint.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "lsystems/mesh/joint_stencils.h"

namespace citykiln::lsystems {
namespace {

// Distance between a ring and the box's edge in radii of the ring; less makes a crease, more a dent.
constexpr double kCollar = 0.7;
// Least sine of angles between stems: at smaller ones the joint is as long as room_m allows.
constexpr double kLeastSine = 0.15;

// The distance from the node at which two stems no longer overlap.
double separation(const Stem& a, const Stem& b) {
  const double half_sine = length(a.direction - b.direction) / 2;
  return (a.radius + b.radius) * 0.55 / std::max(half_sine, kLeastSine);
}

// Where a side stem's axis leaves the tube: height along the box's axis, distance along its own.
struct Leaving {
  double height = 0, distance = 0;
};

Leaving leaving(const Stem& stem, Vec3 axis, double radius) {
  const double cosine = dot(stem.direction, axis);
  const double sine = std::max(std::sqrt(std::max(0.0, 1 - cosine * cosine)), kLeastSine);
  return {radius * cosine / sine, radius / sine};
}

struct Heights {
  double low = 0, high = 0;  // of the box above the node
  double lower_ring = 0, upper_ring = 0;
};

Heights heights_of(const Stem& parent, const Stem& upper, std::span<const Stem> sides, Vec3 axis) {
  const double radius = std::max(parent.radius, upper.radius);
  double low = 1e300, high = -1e300, part = 0;
  for (const Stem& side : sides) {
    const double middle = leaving(side, axis, radius).height;
    const double half = std::min(side.radius, radius) * kCornerScale * std::sqrt(0.5);
    low = std::min(low, middle - half);
    high = std::max(high, middle + half);
    part = std::max(part, separation(side, upper));
  }
  Heights heights;
  heights.upper_ring = std::min(std::max(part, high + kCollar * upper.radius), upper.room_m);
  heights.lower_ring = std::clamp(low - kCollar * parent.radius, -parent.room_m, 0.0);
  // the box stays between its rings even without room
  const double span = heights.upper_ring - heights.lower_ring;
  heights.low = std::clamp(low, heights.lower_ring + span * 0.2, heights.lower_ring + span * 0.5);
  heights.high = std::clamp(high, heights.lower_ring + span * 0.6, heights.lower_ring + span * 0.85);
  return heights;
}

Ring ring_of(const Stem& stem, Vec3 node, double distance, Vec3 first) {
  Ring ring;
  ring.at = node + stem.direction * distance;
  ring.axis = stem.direction;
  ring.x = perpendicular_to(stem.direction, first);
  ring.radius = std::max(0.0, stem.radius - stem.slope * distance);
  ring.slope = stem.slope;
  return ring;
}

double side_distance(const Stem& stem, const Stem& upper, std::span<const Stem> sides, Vec3 axis, double radius) {
  double distance = std::max(leaving(stem, axis, radius).distance + kCollar * stem.radius, separation(stem, upper));
  for (const Stem& other : sides)
    if (other.id != stem.id) distance = std::max(distance, separation(stem, other));
  return std::min(distance, stem.room_m);
}

// Directions of the box: its axis, and those towards its sides.
struct Compass {
  Vec3 axis, x, y;
  Vec3 towards(int side) const { return (side & 1 ? y : x) * (side & 2 ? -1.0 : 1.0); }
};

// Assigns each stem to the free side nearest to its direction.
std::array<const Stem*, 4> sides_taken(std::span<const Stem> sides, const Compass& compass) {
  std::array<const Stem*, 4> taken{};
  for (const Stem& stem : sides) {
    int best = -1;
    for (int k = 0; k < 4; ++k)
      if (taken[k] == nullptr &&
          (best < 0 || dot(stem.direction, compass.towards(k)) > dot(stem.direction, compass.towards(best)) + 1e-9))
        best = k;
    taken[best] = &stem;
  }
  return taken;
}

// The direction of the first point on a side stem's ring, towards the lower corner of its side.
Vec3 first_of_side(Vec3 direction, const Compass& compass, int side) {
  const Vec3 along = compass.axis - direction * dot(direction, compass.axis);
  const Vec3 up = length(along) > 1e-6 ? unit(along) : compass.towards(side) * -dot(direction, compass.axis);
  return (cross(up, direction) + up) * -1.0;
}

double extent_of(const Joint& joint) {
  Vec3 middle;
  for (const Vec3 corner : joint.box) middle = middle + corner * 0.125;
  double extent_m = 0;
  for (const Vec3 corner : joint.box) extent_m = std::max(extent_m, length(corner - middle));
  for (std::size_t i = 0; i < joint.stems; ++i) {
    const Ring& ring = joint.rings[i];
    extent_m = std::max(extent_m, length(ring.at - middle) + ring.radius * kCornerScale);
  }
  return extent_m;
}

}  // namespace

Joint place_joint(Vec3 node, const Stem& parent, const Stem& upper, std::span<const Stem> sides) {
  assert(!sides.empty() && sides.size() <= kMostSideStems);
  const Vec3 both = parent.direction + upper.direction;
  const Vec3 axis = length(both) > 1e-3 ? unit(both) : parent.direction;
  const Vec3 x = perpendicular_to(axis, sides[0].direction);
  const Compass compass{axis, x, cross(axis, x)};
  const Heights heights = heights_of(parent, upper, sides, axis);
  const Vec3 corner = (compass.x - compass.y) * std::sqrt(0.5);
  Joint joint;
  joint.rings[0] = ring_of(parent, node, heights.lower_ring, corner);
  joint.rings[1] = ring_of(upper, node, heights.upper_ring, corner);
  joint.ids = {parent.id, upper.id};
  for (int k = 0; k < 4; ++k) {
    const Vec3 out = (compass.towards(k) - compass.towards((k + 1) % 4)) * std::sqrt(0.5) * kCornerScale;
    joint.box[k] = node + axis * heights.low + out * parent.radius;
    joint.box[4 + k] = node + axis * heights.high + out * std::max(upper.radius, parent.radius * 0.8);
  }
  const std::array<const Stem*, 4> taken = sides_taken(sides, compass);
  for (int k = 0; k < 4; ++k) {
    if (taken[k] == nullptr) continue;
    const Stem& stem = *taken[k];
    const double distance = side_distance(stem, upper, sides, axis, std::max(parent.radius, upper.radius));
    joint.open |= 1U << k;
    joint.ids[joint.stems] = stem.id;
    joint.rings[joint.stems++] = ring_of(stem, node, distance, first_of_side(stem.direction, compass, k));
  }
  joint.extent_m = extent_of(joint);
  return joint;
}

}  // namespace citykiln::lsystems
