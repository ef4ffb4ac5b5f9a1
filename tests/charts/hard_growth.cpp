// Turtles of many turns, and L-systems that grow without end.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "lsystems/reading/read_lsystem.h"
#include "lsystems/rewriting/turtle.h"
#include "tests/charts/hard_cases.h"

namespace citykiln::charts {
namespace {

using lsystems::TurtleFrame;

/// A rotation as a matrix of columns, in single precision, as graphics libraries multiply them.
struct SingleMatrix {
  std::array<std::array<float, 3>, 3> columns{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

  /// Turns column a towards column b.
  void turn(int a, int b, double angle) {
    const auto c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
    for (int i = 0; i < 3; ++i) {
      const float x = columns[a][i], y = columns[b][i];
      columns[a][i] = x * c + y * s, columns[b][i] = y * c - x * s;
    }
  }
};

/// The angles of a unit of the string +(yaw)&(pitch)F, in radians.
struct Turns {
  double yaw, pitch;
};

// The turtle's end by single-precision matrices. Columns are heading, left, up.
Vec3 textbook_end(const Turns& turns, int count) {
  SingleMatrix frame;
  std::array<float, 3> at{};
  for (int i = 0; i < count; ++i) {
    frame.turn(0, 1, turns.yaw), frame.turn(0, 2, -turns.pitch);
    for (int k = 0; k < 3; ++k) at[k] += frame.columns[0][k];
  }
  return {at[0], at[1], at[2]};
}

// The end after equal rotations by the closed form: the axis and angle of one, and the sum of a geometric series. In
// the frame of the start: x along the heading, y left, z up.
Vec3 exact_end(const Turns& turns, int count) {
  const double cy = std::cos(turns.yaw), sy = std::sin(turns.yaw), cp = std::cos(turns.pitch),
               sp = std::sin(turns.pitch);
  // columns: heading, left, up after one unit
  const Vec3 heading{cy * cp, sy * cp, -sp}, left{-sy, cy, 0}, up{cy * sp, sy * sp, cp};
  const Vec3 twice_sine{left.z - up.y, up.x - heading.z, heading.y - left.x};
  const double angle = std::atan2(length(twice_sine), heading.x + left.y + up.z - 1);
  const Vec3 axis = unit(twice_sine), start{1, 0, 0};
  const Vec3 along = axis * dot(axis, start), across = start - along, beside = cross(axis, start);
  const double n = count, ratio = std::sin(n * angle / 2) / std::sin(angle / 2), middle = (n + 1) * angle / 2;
  return along * n + across * (ratio * std::cos(middle)) + beside * (ratio * std::sin(middle));
}

Vec3 in_start_frame(Vec3 p) {
  const TurtleFrame start;
  return {dot(p, start.heading), dot(p, start.left), dot(p, start.up)};
}

// The end of the turtle's only stem; empty if the string was not derived.
std::optional<Vec3> walked_end(const std::string& text, std::size_t segments) {
  const Result<lsystems::LSystem> system = lsystems::read_lsystem(text, "case");
  if (!system) return std::nullopt;
  const lsystems::Plant plant = lsystems::grow(*system);
  if (plant.skeleton.segments.size() != segments) return std::nullopt;
  return in_start_frame(plant.skeleton.segments.back().end().at);
}

}  // namespace

Judged judge_turtle(HardDraw& draw) {
  const int doublings = draw.whole(0, 999) == 0 ? 20 : draw.whole(0, 11);
  const int count = 1 << doublings;
  // degrees with three decimals, as the text has them
  const double yaw_deg = std::round(draw.of_any_size(0.01, 90) * 1000) / 1000,
               pitch_deg = std::round(draw.of_any_size(0.01, 90) * 1000) / 1000;
  const std::string text =
      fmt::format("n: {}\naxiom: X\nX -> XX\ninterpretation:\nX -> +({})&({})F(1)\n", doublings, yaw_deg, pitch_deg);
  const Turns turns{yaw_deg * 3.14159265358979323846 / 180, pitch_deg * 3.14159265358979323846 / 180};
  const Vec3 wanted = exact_end(turns, count);
  const std::optional<Vec3> ours = walked_end(text, static_cast<std::size_t>(count));
  return {length(textbook_end(turns, count) - wanted) <= 1e-6 * count, ours && length(*ours - wanted) <= 1e-6 * count};
}

namespace {

constexpr double kMostModules = 2147483648.0;
constexpr std::uint64_t kFewSymbols = 10'000;

// A(l) becomes buds: after n steps, their number and the finite lengths, as a loop without limits would have them.
bool is_textbook_growth_right(int buds, int steps, double factor, double pole, double start) {
  double modules = 1, l = start;
  for (int i = 0; i < steps; ++i) {
    modules *= buds, l = l * factor / (l - pole);
    if (modules > kMostModules || !std::isfinite(l)) return false;
  }
  return true;
}

bool is_balanced(const lsystems::LSystem& system, const lsystems::ModuleString& string) {
  int depth = 0;
  for (const lsystems::Kind kind : string.kinds) {
    depth += (kind == system.push) - (kind == system.pop);
    if (depth < 0) return false;
  }
  return depth == 0 && std::ranges::all_of(string.values, [](double v) { return std::isfinite(v); });
}

bool is_finite_skeleton(const lsystems::Skeleton& skeleton) {
  return std::ranges::all_of(skeleton.segments, [](const lsystems::Segment& segment) {
    return std::isfinite(segment.length) && std::isfinite(length(segment.start.at)) &&
           std::abs(dot(segment.start.heading, segment.start.left)) < 1e-9;
  });
}

}  // namespace

Judged judge_growth(HardDraw& draw) {
  const int buds = draw.whole(1, 4), steps = draw.whole(1, 60);
  const double factor = draw.whole(1, 4) * 0.5, start = draw.whole(1, 4);
  // the first length is the pole itself in half of the cases
  const double pole = draw.whole(0, 1) == 0 ? start : draw.between(0, 4);
  std::string successor = "F(l)";
  for (int i = 0; i < buds; ++i) successor += fmt::format("[+(25)A(l*{}/(l-{}))]", factor, pole);
  const std::string text = fmt::format("n: {}\naxiom: A({})\nA(l) -> {}\n", steps, start, successor);
  const Result<lsystems::LSystem> system = lsystems::read_lsystem(text, "case");
  if (!system) return {};
  lsystems::DeriveOptions options;
  options.limits.symbols = kFewSymbols;
  const lsystems::Plant plant = lsystems::grow(*system, options);
  return {is_textbook_growth_right(buds, steps, factor, pole, start),
          plant.derivation.string.kinds.size() <= kFewSymbols && is_balanced(*system, plant.derivation.string) &&
              is_finite_skeleton(plant.skeleton)};
}

}  // namespace citykiln::charts
