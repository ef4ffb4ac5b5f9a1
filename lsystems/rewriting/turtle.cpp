// Prusinkiewicz, Lindenmayer, "The Algorithmic Beauty of Plants", 1990, sections 1.5, 1.6.4, 2.1 and 5.1. Where the
// book's rotation matrices and text differ, this follows the text: + turns left.
#include "lsystems/rewriting/turtle.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "compiler/geometry/trig.h"
#include "lsystems/rewriting/rewrite.h"
#include "lsystems/rewriting/turtle_frame.h"

namespace citykiln::lsystems {
namespace {

constexpr double kThinner = 0.70710678118654752440;  // two branches of equal width have their parent's cross-section

// The state that [ pushes and ] pops.
struct State {
  TurtleFrame frame;
  double width = 0;
  std::int32_t colour = 0;
  std::int32_t parent = kNoParent;
  bool branched = false;  // [ was read since the parent was drawn
  bool moved = false;     // f moved since then
  int turns = 0;          // since the last orthonormalise()
  Vec3 tropism;
  double elasticity = 0;
};

struct OpenPolygon {
  std::size_t first = 0;  // into Turtle::corners
  std::int32_t parent = kNoParent, order = 0, colour = 0;
};

// Cosine and sine of the last angle.
struct Turns {
  double angle_deg = 0;
  Vec2 turn{1, 0};

  Vec2 of(double angle) {
    if (angle != angle_deg) {
      angle_deg = angle;
      turn = direction_of(angle / 360);
    }
    return turn;
  }
};

struct Turtle {
  explicit Turtle(const LSystem& of, const Environment* asked = nullptr) : system(of), environment(asked) {}

  const LSystem& system;
  const Environment* environment;  // null except in answers_to()
  Skeleton out;
  std::vector<double> answers;
  State now;
  std::vector<State> stack;
  std::vector<OpenPolygon> polygons;
  std::vector<Vec3> corners;  // of open polygons, innermost last
  Turns turns;

  std::int32_t order() const {
    if (now.parent == kNoParent) return 0;
    return out.segments[now.parent].order + (now.branched ? 1 : 0);
  }
  double radius() const { return now.width * system.width_unit / 2; }

  void warning(const std::string& message) { add_warning(out.warnings, {}, message.c_str()); }

  void turn(void (*how)(TurtleFrame&, Vec2), double angle_deg) {
    how(now.frame, turns.of(angle_deg));
    // often enough that rounding stays below 1e-13
    if (++now.turns % 64 == 0) orthonormalise(now.frame);
  }

  void draw(double length) {
    const auto index = static_cast<std::int32_t>(out.segments.size());
    const bool goes_on = now.parent != kNoParent && !now.branched && !now.moved;
    const double start = goes_on ? out.segments[now.parent].end_radius : radius();
    out.segments.push_back({.start = now.frame,
                            .length = length,
                            .start_radius = start,
                            .end_radius = radius(),
                            .colour = now.colour,
                            .parent = now.parent,
                            .order = order()});
    now.parent = index;
    now.branched = now.moved = false;
  }

  void forward(double length, bool draws, bool marks) {
    if (draws && polygons.empty()) draw(length);
    now.moved |= !draws;
    now.frame.at = now.frame.at + now.frame.heading * length;
    if (marks && !polygons.empty()) corners.push_back(now.frame.at);
    if (draws && polygons.empty()) bend(now.frame, now.tropism, now.elasticity);
  }

  void pop() {
    if (stack.empty()) return;
    now = stack.back();
    stack.pop_back();
  }

  void push() {
    stack.push_back(now);
    now.branched = true;
  }

  void open_polygon() {
    if (polygons.size() >= kBranchLimit) return warning("polygons nest too deeply: a '{' is skipped");
    polygons.push_back({corners.size(), now.parent, order(), now.colour});
  }

  void mark() {
    if (polygons.empty()) return warning("a '.' outside polygons is skipped");
    corners.push_back(now.frame.at);
  }

  void close_polygon() {
    if (polygons.empty()) return warning("a '}' outside polygons is skipped");
    const OpenPolygon polygon = polygons.back();
    polygons.pop_back();
    const auto count = static_cast<std::uint32_t>(corners.size() - polygon.first);
    if (count >= 3) {
      const auto first = static_cast<std::uint32_t>(out.vertices.size());
      out.polygons.push_back(
          {.first = first, .count = count, .colour = polygon.colour, .parent = polygon.parent, .order = polygon.order});
      out.vertices.insert(out.vertices.end(), corners.begin() + static_cast<std::ptrdiff_t>(polygon.first),
                          corners.end());
    } else {
      warning("a polygon of fewer than three vertices is skipped");
    }
    corners.resize(polygon.first);
  }

  void place(Kind kind, double size) {
    out.instances.push_back(
        {.kind = kind, .frame = now.frame, .size = size, .colour = now.colour, .parent = now.parent, .order = order()});
  }

  double environment_value(const std::function<double(Vec3)>& function, double otherwise) const {
    const double answer = function ? function(now.frame.at) : otherwise;
    return std::isfinite(answer) ? answer : 0;
  }

  void answer(TurtleOp op) {
    if (environment == nullptr) return;
    const Vec3 at = now.frame.at;
    if (op == TurtleOp::kQueryPosition) answers.insert(answers.end(), {at.x, at.y, at.z});
    if (op == TurtleOp::kQueryHeight) answers.push_back(environment_value(environment->height_above_ground, at.z));
    if (op == TurtleOp::kQueryShade) answers.push_back(environment_value(environment->shade, 0));
  }

  // Executes one module.
  // @param values  are_sound().
  void act(Kind k, const double* values, int count) {
    const TurtleOp op = system.kinds[k].op;
    const auto value = [&](double otherwise) { return count > 0 ? values[0] : otherwise; };
    switch (op) {
      case TurtleOp::kForward:
        return forward(value(system.step), true, true);
      case TurtleOp::kForwardUnmarked:
        return forward(value(system.step), true, false);
      case TurtleOp::kMove:
        return forward(value(system.step), false, true);
      case TurtleOp::kTurnLeft:
        return turn(turn_left, value(system.angle_deg));
      case TurtleOp::kTurnRight:
        return turn(turn_left, -value(system.angle_deg));
      case TurtleOp::kPitchDown:
        return turn(pitch_down, value(system.angle_deg));
      case TurtleOp::kPitchUp:
        return turn(pitch_down, -value(system.angle_deg));
      case TurtleOp::kRollLeft:
        return turn(roll_left, value(system.angle_deg));
      case TurtleOp::kRollRight:
        return turn(roll_left, -value(system.angle_deg));
      case TurtleOp::kTurnAround:
        return turn(turn_left, value(180));
      case TurtleOp::kLevel:
        return level(now.frame);
      case TurtleOp::kThinner:
        now.width = std::max(0.0, value(now.width * kThinner));
        return;
      case TurtleOp::kThicker:
        now.width = std::max(0.0, value(std::min(now.width / kThinner, kWalkLimit)));
        return;
      case TurtleOp::kNextColour:
      case TurtleOp::kColour:
        now.colour = count > 0 ? static_cast<std::int32_t>(values[0]) : now.colour + 1;
        return;
      case TurtleOp::kPreviousColour:
        now.colour = count > 0 ? static_cast<std::int32_t>(values[0]) : now.colour - 1;
        return;
      case TurtleOp::kPush:
        return push();
      case TurtleOp::kPop:
        return pop();
      case TurtleOp::kOpenPolygon:
        return open_polygon();
      case TurtleOp::kVertex:
        return mark();
      case TurtleOp::kClosePolygon:
        return close_polygon();
      case TurtleOp::kTropism:
        now.tropism = {values[0], values[1], values[2]};
        now.elasticity = values[3];
        return;
      case TurtleOp::kInstance:
      case TurtleOp::kSphere:
      case TurtleOp::kDisc:
        return place(k, value(1));
      case TurtleOp::kQueryPosition:
      case TurtleOp::kQueryHeight:
      case TurtleOp::kQueryShade:
        return answer(op);
      case TurtleOp::kCut:
      case TurtleOp::kNone:
        return;
    }
  }

  bool are_sound(const ModuleKind& kind, const double* values) {
    for (int i = 0; i < kind.arity; ++i) {
      if (std::abs(values[i]) <= kWalkLimit) continue;
      warning(fmt::format("'{}' with a number beyond {} is skipped", kind.name, kWalkLimit));
      return false;
    }
    return true;
  }

  // Skips from behind a [ or % to the ] of its branch. Queries on the way are answered with 0.
  std::size_t skip_branch(const ModuleString& string, std::size_t at, std::size_t& value) {
    for (int depth = 0; at < string.kinds.size(); ++at) {
      const ModuleKind& kind = system.kinds[string.kinds[at]];
      if (kind.op == TurtleOp::kPush) ++depth;
      if (kind.op == TurtleOp::kPop && depth-- == 0) break;
      if (environment != nullptr && kind.name[0] == '?') answers.insert(answers.end(), kind.arity, 0.0);
      value += kind.arity;
    }
    return at;
  }

  void walk(const ModuleString& string) {
    now.width = system.width;
    now.tropism = system.tropism;
    now.elasticity = system.elasticity;
    std::size_t value = 0;
    for (std::size_t at = 0; at < string.kinds.size(); ++at) {
      const Kind k = string.kinds[at];
      const ModuleKind& kind = system.kinds[k];
      const double* values = string.values.data() + value;
      value += kind.arity;
      const bool too_deep = kind.op == TurtleOp::kPush && stack.size() >= kBranchLimit;
      if (too_deep) warning("branches nest too deeply: one is skipped");
      if (too_deep || kind.op == TurtleOp::kCut) {
        // the ] of a cut branch is executed, that of a skipped one is not
        at = skip_branch(string, at + 1, value) - (too_deep ? 0 : 1);
      } else if (kind.op != TurtleOp::kNone) {
        const bool asks = kind.name[0] == '?';
        if (asks || are_sound(kind, values)) act(k, values, kind.arity);
      }
    }
    if (!polygons.empty()) warning("a polygon without '}' is skipped");
  }
};

double top_of(const Skeleton& skeleton) {
  double top = 0;
  for (const Segment& segment : skeleton.segments) top = std::max({top, segment.start.at.z, segment.end().at.z});
  for (const Vec3 vertex : skeleton.vertices) top = std::max(top, vertex.z);
  for (const Instance& instance : skeleton.instances) top = std::max(top, instance.frame.at.z);
  return top;
}

void scale(Skeleton& skeleton, double by) {
  for (Segment& segment : skeleton.segments) {
    segment.start.at = segment.start.at * by;
    segment.length *= by;
    segment.start_radius *= by;
    segment.end_radius *= by;
  }
  for (Vec3& vertex : skeleton.vertices) vertex = vertex * by;
  for (Instance& instance : skeleton.instances) {
    instance.frame.at = instance.frame.at * by;
    instance.size *= by;
  }
}

}  // namespace

Skeleton walk(const LSystem& system, const ModuleString& interpreted) {
  Turtle turtle(system);
  turtle.walk(interpreted);
  const double top = system.height > 0 ? top_of(turtle.out) : 0;
  // a flat plant cannot be scaled to a height
  if (top > 1e-6) scale(turtle.out, system.height / top);
  return std::move(turtle.out);
}

std::vector<double> answers_to(const LSystem& system, const ModuleString& interpreted, const Environment& environment) {
  Turtle turtle(system, &environment);
  turtle.walk(interpreted);
  return std::move(turtle.answers);
}

Plant grow(const LSystem& system, const DeriveOptions& options) {
  Plant plant;
  plant.derivation = derive(system, options);
  if (system.interpretation.rules.empty()) {
    plant.skeleton = walk(system, plant.derivation.string);
    return plant;
  }
  Derivation interpreted = interpret(system, plant.derivation.string, options);
  plant.skeleton = walk(system, interpreted.string);
  std::move(interpreted.warnings.begin(), interpreted.warnings.end(), std::back_inserter(plant.derivation.warnings));
  if (!plant.derivation.limit_exceeded) plant.derivation.limit_exceeded = interpreted.limit_exceeded;
  return plant;
}

}  // namespace citykiln::lsystems
