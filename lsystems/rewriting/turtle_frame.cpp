#include "lsystems/rewriting/turtle_frame.h"

#include <algorithm>

#include "compiler/geometry/trig.h"

namespace citykiln::lsystems {
namespace {

// Sine of the angle to the vertical below which the heading has no horizontal left.
constexpr double kVertical = 1e-9;

// Rodrigues' rotation of v about a unit axis.
Vec3 rotated(Vec3 v, Vec3 axis, Vec2 turn) {
  return v * turn.x + cross(axis, v) * turn.y + axis * (dot(axis, v) * (1 - turn.x));
}

}  // namespace

void level(TurtleFrame& frame) {
  const Vec3 left = cross({0, 0, 1}, frame.heading);
  if (length(left) < kVertical) return;
  frame.left = unit(left);
  frame.up = cross(frame.heading, frame.left);
}

void orthonormalise(TurtleFrame& frame) {
  frame.heading = unit(frame.heading);
  frame.left = unit(frame.left - frame.heading * dot(frame.heading, frame.left));
  frame.up = cross(frame.heading, frame.left);
}

void bend(TurtleFrame& frame, Vec3 pull, double elasticity) {
  const Vec3 axis = cross(frame.heading, pull);
  const double moment = length(axis);
  if (!(moment > 0)) return;
  const double turns = std::clamp(elasticity * moment / (2 * kPi), -0.5, 0.5);
  const Vec2 turn = direction_of(turns);
  const Vec3 about = axis * (1 / moment);
  frame.heading = rotated(frame.heading, about, turn);
  frame.left = rotated(frame.left, about, turn);
  orthonormalise(frame);
}

}  // namespace citykiln::lsystems
