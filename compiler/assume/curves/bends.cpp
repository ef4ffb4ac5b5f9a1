#include "compiler/assume/curves/bends.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstddef>
#include <optional>
#include <utility>

#include "compiler/geometry/curved_chord.h"
#include "compiler/geometry/mathematics.h"

namespace citykiln::assume {
namespace {

/// The least radius of a curve at a node, metres: a car turns in it.
constexpr double kLeastRadius_m = 6;
/// The greatest part of a turn that one chord takes.
constexpr double kMostSlope = 0.62;

// An end of a chord at a node: the chord after the point (step 1) or before it (step -1).
struct ChordEnd {
  int network;
  std::int64_t node;
  std::uint32_t line, point;
  int step;
  auto operator<=>(const ChordEnd&) const = default;
};

struct Pair {
  ChordEnd a, b;
};

std::vector<ChordEnd> ends_of_chords(std::span<const CurvableLine> lines) {
  std::vector<ChordEnd> ends;
  for (std::uint32_t l = 0; l < lines.size(); ++l) {
    const CurvableLine& line = lines[l];
    for (std::uint32_t p = 0; p < line.axis.size(); ++p) {
      if (p > 0) ends.push_back({line.network, line.nodes[p], l, p, -1});
      if (p + 1 < line.axis.size()) ends.push_back({line.network, line.nodes[p], l, p, 1});
    }
  }
  std::ranges::sort(ends);
  return ends;
}

std::uint32_t chord_of(const ChordEnd& end) { return end.step > 0 ? end.point : end.point - 1; }

// Turns and slopes at nodes.
struct Nodes {
  std::span<const CurvableLine> lines;

  Vec2 beyond(const ChordEnd& e) const { return lines[e.line].axis[chord_of(e) + (e.step > 0 ? 1 : 0)]; }
  Vec2 at(const ChordEnd& e) const { return lines[e.line].axis[e.point]; }
  const ChordLimits& limits(const ChordEnd& e) const { return lines[e.line].chords[chord_of(e)]; }
  double length_m(const ChordEnd& e) const { return distance(at(e), beyond(e)); }

  // The turn from the chord of `a`, towards the node, to the chord of `b`, away from it; left is positive.
  double turn_deg(const Pair& p) const {
    const Vec2 in = at(p.a) - beyond(p.a), out = beyond(p.b) - at(p.b);
    return arctangent2_deg(cross(in, out), dot(in, out));
  }

  // True where the line of two ends goes through the node.
  static bool is_through(const ChordEnd& a, const ChordEnd& b) {
    return a.line == b.line && a.point == b.point && a.step != b.step;
  }

  bool is_corner(const ChordEnd& e) const {
    const CurvableLine& line = lines[e.line];
    return !line.is_corner.empty() && line.is_corner[e.point];
  }

  // Both ends of a closed line are one place of it.
  bool is_one_line(const ChordEnd& a, const ChordEnd& b) const {
    if (is_through(a, b)) return true;
    const bool is_joined = a.point == 0 || b.point == 0;
    return a.line == b.line && is_joined && a.point + b.point + 1 == lines[a.line].axis.size();
  }

  std::optional<Pair> through_pair(std::span<const ChordEnd> ends) const {
    std::optional<Pair> found;
    for (std::size_t i = 0; i < ends.size(); ++i)
      for (std::size_t j = i + 1; j < ends.size(); ++j)
        if (is_one_line(ends[i], ends[j])) {
          if (found) return std::nullopt;
          found = Pair{ends[i], ends[j]};
        }
    return found;
  }

  // The two ends of the highest priority, if exactly two have it.
  std::optional<Pair> main_pair(std::span<const ChordEnd> ends) const {
    int highest = lines[ends[0].line].priority;
    for (const ChordEnd& e : ends) highest = std::max(highest, lines[e.line].priority);
    std::vector<ChordEnd> main;
    for (const ChordEnd& e : ends)
      if (lines[e.line].priority == highest) main.push_back(e);
    return main.size() == 2 ? std::optional(Pair{main[0], main[1]}) : std::nullopt;
  }

  // The ends of the circle, if the place has exactly two.
  std::optional<Pair> circle_pair(std::span<const ChordEnd> ends) const {
    std::vector<ChordEnd> circle;
    for (const ChordEnd& e : ends)
      if (lines[e.line].is_circle) circle.push_back(e);
    return circle.size() == 2 ? std::optional(Pair{circle[0], circle[1]}) : std::nullopt;
  }

  std::optional<Pair> pair_at(std::span<const ChordEnd> ends) const {
    if (ends.size() < 2 || std::ranges::any_of(ends, [&](const ChordEnd& e) { return is_corner(e); }))
      return std::nullopt;
    if (ends.size() == 2) return Pair{ends[0], ends[1]};
    if (const std::optional<Pair> circle = circle_pair(ends)) return circle;
    const std::optional<Pair> main = main_pair(ends);
    return main ? main : through_pair(ends);
  }

  double most_turn_deg(const Pair& pair, std::size_t ends) const {
    if (lines[pair.a.line].is_circle && lines[pair.b.line].is_circle) return kMostTurnInCircle_deg;
    return ends == 2 ? kMostTurn_deg : kMostTurnAtJunction_deg;
  }

  // The largest angle between the line and the chord: the bulge of a chord that leaves at slope s and comes back
  // within 27 / 4 of most_m / s has a radius of 1.69 most_m / s² at the node.
  double most_deg(const ChordEnd& e) const {
    return arctangent_deg(std::min(kMostSlope, std::sqrt(1.69 * limits(e).most_m / kLeastRadius_m)));
  }
};

// Even units: corners of less than 2 degrees are not seen, and the numbers take fewer bytes.
int slope_units(double angle_deg) { return 2 * static_cast<int>(std::round(tangent(angle_deg) / (2 * kSlopeUnit))); }

// The angles that the two chords of a pair take of their turn, both with its sign.
std::pair<double, double> parts_of_turn(const Nodes& nodes, const Pair& pair, double turn_deg) {
  const double a = nodes.limits(pair.a).most_m / nodes.length_m(pair.a);
  const double b = nodes.limits(pair.b).most_m / nodes.length_m(pair.b);
  if (a + b == 0) return {0, 0};
  const double all_deg = std::abs(turn_deg), most_a = nodes.most_deg(pair.a), most_b = nodes.most_deg(pair.b);
  double a_deg = std::min(all_deg * (a / (a + b)), most_a);
  const double b_deg = std::min(all_deg - a_deg, most_b);
  a_deg = std::min(all_deg - b_deg, most_a);
  const double sign = turn_deg < 0 ? -1 : 1;
  return {sign * a_deg, sign * b_deg};
}

// Sets the slope of a chord at one end. `turned_deg`: from the chord's direction towards the node to the line's there,
// or from the line's to that of the chord away from it.
void set_slope(std::vector<std::vector<Slopes>>& slopes, const ChordEnd& end, double turned_deg, bool is_first) {
  Slopes& chord = slopes[end.line][chord_of(end)];
  // towards the node the line turns away from the chord, after it towards the chord
  const int units = slope_units(turned_deg);
  if (is_first)
    (end.step < 0 ? chord.arrive : chord.leave) = units;
  else
    (end.step > 0 ? chord.leave : chord.arrive) = -units;
}

}  // namespace

std::vector<std::vector<Slopes>> slopes_of(std::span<const CurvableLine> lines) {
  std::vector<std::vector<Slopes>> slopes;
  for (const CurvableLine& line : lines) slopes.emplace_back(line.axis.size() - 1);
  const Nodes nodes{lines};
  const std::vector<ChordEnd> ends = ends_of_chords(lines);
  for (std::size_t from = 0, to = 0; from < ends.size(); from = to) {
    while (to < ends.size() && ends[to].node == ends[from].node && ends[to].network == ends[from].network) ++to;
    const std::optional<Pair> pair = nodes.pair_at(std::span(ends).subspan(from, to - from));
    if (!pair) continue;
    const double turn_deg = nodes.turn_deg(*pair);
    if (std::abs(turn_deg) < kLeastTurn_deg || std::abs(turn_deg) > nodes.most_turn_deg(*pair, to - from)) continue;
    const auto [a_deg, b_deg] = parts_of_turn(nodes, *pair, turn_deg);
    set_slope(slopes, pair->a, a_deg, true);
    set_slope(slopes, pair->b, b_deg, false);
  }
  return slopes;
}

}  // namespace citykiln::assume
