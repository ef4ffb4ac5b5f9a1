// How a turtle turns. Only + - * / and the square root, so the same bits on every CPU.
#pragma once

#include "lsystems/skeleton.h"

namespace citykiln::lsystems {

/// Each turns two of the three directions; the third stays bit for bit. `turn` is {cosine, sine}.
inline void turn_left(TurtleFrame& frame, Vec2 turn) {
  const Vec3 heading = frame.heading;
  frame.heading = heading * turn.x + frame.left * turn.y;
  frame.left = frame.left * turn.x - heading * turn.y;
}
inline void pitch_down(TurtleFrame& frame, Vec2 turn) {
  const Vec3 heading = frame.heading;
  frame.heading = heading * turn.x - frame.up * turn.y;
  frame.up = frame.up * turn.x + heading * turn.y;
}
inline void roll_left(TurtleFrame& frame, Vec2 turn) {
  const Vec3 left = frame.left;
  frame.left = left * turn.x - frame.up * turn.y;
  frame.up = frame.up * turn.x + left * turn.y;
}

/// Rolls until left is level; a vertical heading stays as it is.
void level(TurtleFrame& frame);

/// Turns the heading towards `pull` by elasticity · |heading × pull| radians, at most half a turn.
void bend(TurtleFrame& frame, Vec3 pull, double elasticity);

/// Puts directions square again that many turns have worn.
void orthonormalise(TurtleFrame& frame);

}  // namespace citykiln::lsystems
