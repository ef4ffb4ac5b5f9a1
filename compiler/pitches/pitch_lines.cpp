#include "compiler/pitches/pitch_lines.h"

#include <algorithm>
#include <cmath>

#include "compiler/contract/texts/parse.h"
#include "compiler/geometry/mathematics.h"
#include "compiler/geometry/trig.h"
#include "compiler/pitches/pitch_rules.h"

namespace citykiln::pitches {
namespace {

// The largest distance of a chord from its arc.
constexpr double kSagitta_m = 0.004;
// Sections of arcs are at most this long, and turn by at most this angle.
constexpr double kSection_m = 4, kSection_deg = 30;

// A command of a text: its letter, its copies (1, 2 or 4) and its arguments.
struct Command {
  int copies = 1;
  std::string_view word;
  std::vector<std::string_view> arguments;
};

std::optional<Command> command_of(std::string_view text) {
  Command command;
  text = trimmed(text);
  if (text.empty()) return std::nullopt;
  if (text.front() == '2' || text.front() == '4') command.copies = text.front() - '0', text.remove_prefix(1);
  command.arguments = split(text, ' ');
  command.word = command.arguments.front();
  command.arguments.erase(command.arguments.begin());
  return command;
}

std::optional<Vec2> point_of(std::string_view text, HalfSize half) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const auto x = coordinate_m(text.substr(0, comma), half), y = coordinate_m(text.substr(comma + 1), half);
  return x && y ? std::optional(Vec2{*x, *y}) : std::nullopt;
}

// The points from an index of the arguments on; empty if one of them cannot be read.
Polyline points_of(const Command& command, std::size_t first, HalfSize half) {
  Polyline points;
  for (std::size_t i = first; i < command.arguments.size(); ++i) {
    const std::optional<Vec2> point = point_of(command.arguments[i], half);
    if (!point) return {};
    points.push_back(*point);
  }
  return points;
}

// The arguments after the first one as numbers; empty if there are not `count` of them.
std::vector<double> numbers_of(const Command& command, std::size_t first, std::size_t count, HalfSize half) {
  std::vector<double> numbers;
  for (std::size_t i = first; i < command.arguments.size(); ++i)
    if (const auto number = coordinate_m(command.arguments[i], half)) numbers.push_back(*number);
  return numbers.size() == count && command.arguments.size() == first + count ? numbers : std::vector<double>{};
}

PitchLine arc(Vec2 about, double radius_m, double from_deg, double to_deg) {
  const double turn_deg = to_deg - from_deg;
  const double sections =
      std::ceil(std::max(turn_deg / kSection_deg, radius_m * turn_deg / 180 * kPi / kSection_m) - 1e-9);
  const double chord_deg = 2 * arccosine_deg(std::max(0.9, 1 - kSagitta_m / radius_m));
  const double chords = std::ceil(turn_deg / sections / chord_deg - 1e-9);
  PitchLine line;
  line.section_chords = static_cast<std::size_t>(chords);
  for (double i = 0; i <= sections * chords; ++i)
    line.path.push_back(about + direction_of((from_deg + turn_deg * i / (sections * chords)) / 360) * radius_m);
  if (turn_deg == 360) line.path.back() = line.path.front();
  return line;
}

// A three-point line: the part of an arc within |y| <= limit, and straight lines from there to the end line.
std::vector<PitchLine> opened_arc(Vec2 about, double radius_m, double limit_m, double end_m) {
  const double y = std::min(limit_m, radius_m), half_deg = arcsine_deg(y / radius_m);
  const double x = about.x - std::sqrt(radius_m * radius_m - y * y);
  std::vector<PitchLine> lines = {arc(about, radius_m, 180 - half_deg, 180 + half_deg)};
  for (const double side : {y, -y})
    if (x < end_m) lines.push_back({.path = {{x, about.y + side}, {end_m, about.y + side}}});
  return lines;
}

// An arc begins at the side of the pitch if it would begin beyond it.
double beginning_deg(Vec2 middle, const std::vector<double>& arc, HalfSize half) {
  const double to_side_m = half.to_side_line_m - middle.y;
  return to_side_m < arc[0] ? std::max(arc[1], 180 - arcsine_deg(to_side_m / arc[0])) : arc[1];
}

std::vector<PitchLine> round_lines(const Command& command, HalfSize half) {
  const auto middle = command.arguments.empty() ? std::nullopt : point_of(command.arguments[0], half);
  const std::size_t count = command.word == "A" ? 3 : command.word == "T" ? 2 : 1;
  const std::vector<double> numbers = numbers_of(command, 1, count, half);
  if (!middle || numbers.empty() || !(numbers[0] > 0)) return {};
  if (command.word == "A") return {arc(*middle, numbers[0], beginning_deg(*middle, numbers, half), numbers[2])};
  if (command.word == "T") return opened_arc(*middle, numbers[0], numbers[1], half.to_end_line_m);
  PitchLine circle = arc(*middle, numbers[0], 0, 360);
  circle.is_disc = command.word == "D";
  return {circle};
}

std::vector<PitchLine> straight_lines(const Command& command, HalfSize half) {
  const bool is_broken = command.word == "B";
  Polyline points = points_of(command, is_broken ? 2 : 0, half);
  if (points.size() < 2) return {};
  // from the middle of a side, so that all corners are bends of the path
  if (command.word == "R") {
    const Vec2 low = points[0], high = points[1], start{(low.x + high.x) / 2, low.y};
    points = {start, {high.x, low.y}, high, {low.x, high.y}, low, start};
  }
  PitchLine line{.path = points};
  if (is_broken) {
    const auto dash = coordinate_m(command.arguments[0], half), gap = coordinate_m(command.arguments[1], half);
    if (!dash || !gap || !(*dash > 0)) return {};
    line.dash_m = *dash, line.gap_m = *gap;
  }
  return {line};
}

std::vector<Vec2> signs_of_copies(int copies) {
  if (copies == 1) return {{1, 1}};
  return copies == 2 ? std::vector<Vec2>{{1, 1}, {-1, -1}} : std::vector<Vec2>{{1, 1}, {-1, -1}, {1, -1}, {-1, 1}};
}

}  // namespace

std::optional<double> coordinate_m(std::string_view text, HalfSize half) {
  double sum = 0;
  if (text.empty()) return std::nullopt;
  while (!text.empty()) {
    const double sign = text.front() == '-' ? -1 : 1;
    if (text.front() == '-' || text.front() == '+') text.remove_prefix(1);
    const std::size_t end = std::min(text.find_first_of("+-"), text.size());
    const std::string_view term = text.substr(0, end);
    text.remove_prefix(end);
    const auto value = term == "e" ? half.to_end_line_m : term == "s" ? half.to_side_line_m : number_in<double>(term);
    if (!value) return std::nullopt;
    sum += sign * *value;
  }
  return sum;
}

HalfSize half_size_of(const Pitch& pitch) {
  const double line_m = rules_of(pitch.kind).line.width_m;
  return {(distance(pitch.from, pitch.to) - line_m) / 2, (pitch.width_m - line_m) / 2};
}

PitchFrame frame_of(const Pitch& pitch) { return {(pitch.from + pitch.to) * 0.5, unit(pitch.to - pitch.from)}; }

std::vector<PitchLine> lines_of(std::string_view text, HalfSize half) {
  std::vector<PitchLine> lines;
  for (const std::string_view part : split(text, ';')) {
    const std::optional<Command> command = command_of(part);
    if (!command) continue;
    const bool is_straight = command->word == "L" || command->word == "R" || command->word == "B";
    for (const PitchLine& line : is_straight ? straight_lines(*command, half) : round_lines(*command, half))
      for (const Vec2 sign : signs_of_copies(command->copies)) {
        lines.push_back(line);
        for (Vec2& p : lines.back().path) p = {p.x * sign.x, p.y * sign.y};
      }
  }
  return lines;
}

std::vector<PitchLine> lines_of(const Pitch& pitch) {
  return lines_of(rules_of(pitch.kind).lines, half_size_of(pitch));
}

std::vector<Equipment> equipment_of(const Pitch& pitch) {
  const PitchFrame frame = frame_of(pitch);
  std::vector<Equipment> all;
  for (const std::string_view part : split(rules_of(pitch.kind).equipment, ';')) {
    const std::optional<Command> command = command_of(part);
    if (!command || command->arguments.size() != 1) continue;
    const std::optional<Vec2> at = point_of(command->arguments[0], half_size_of(pitch));
    if (!at) continue;
    for (const Vec2 sign : signs_of_copies(command->copies)) {
      const Vec2 place{at->x * sign.x, at->y * sign.y};
      all.push_back({command->word, frame.in_plane(place), frame.along * (place.x > 0 ? -1.0 : 1.0)});
    }
  }
  return all;
}

}  // namespace citykiln::pitches
