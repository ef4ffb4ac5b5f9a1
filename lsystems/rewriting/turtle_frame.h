// Rotations of the turtle. They use only + - * / and the square root, so results have the same bits on every CPU.
#pragma once

#include "lsystems/rewriting/skeleton.h"

namespace citykiln::lsystems {

/// Rotates the heading towards `left`, about `up`.
/// @param turn  {cosine, sine} of the angle.
inline void turn_left(TurtleFrame& frame, Vec2 turn) {
  const Vec3 heading = frame.heading;
  frame.heading = heading * turn.x + frame.left * turn.y;
  frame.left = frame.left * turn.x - heading * turn.y;
}
/// Rotates the heading away from `up`, about `left`.
/// @param turn  {cosine, sine} of the angle.
inline void pitch_down(TurtleFrame& frame, Vec2 turn) {
  const Vec3 heading = frame.heading;
  frame.heading = heading * turn.x - frame.up * turn.y;
  frame.up = frame.up * turn.x + heading * turn.y;
}
/// Rotates `up` towards `left`, about the heading.
/// @param turn  {cosine, sine} of the angle.
inline void roll_left(TurtleFrame& frame, Vec2 turn) {
  const Vec3 left = frame.left;
  frame.left = left * turn.x - frame.up * turn.y;
  frame.up = frame.up * turn.x + left * turn.y;
}

/// Rolls until left is horizontal; does nothing if the heading is vertical.
void level(TurtleFrame& frame);

/// Applies tropism: turns the heading towards `pull` by elasticity · |heading × pull| radians, at most half a turn.
void bend(TurtleFrame& frame, Vec3 pull, double elasticity);

/// Restores orthonormal directions after rounding of many rotations.
void orthonormalise(TurtleFrame& frame);

}  // namespace citykiln::lsystems
