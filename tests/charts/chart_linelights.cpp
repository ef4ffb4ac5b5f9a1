// Line lights of the inside of a cylinder: the closed form of irradiance against samples on the line, error over time.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <random>
#include <vector>

#include "compiler/sky/inside/line_light.h"
#include "compiler/sky/inside/plan_inside.h"
#include "tests/charts/chart.h"
#include "tests/charts/stopwatch.h"

namespace citykiln::charts {
namespace {

/// A place of the ground with a normal, in the frame of the cylinder.
struct Receiver {
  Vec3 at, normal;
};
struct Segment {
  Vec3 from, to;
};

constexpr double kDrumRadius_m = 977.848;
constexpr std::size_t kReceivers = 2000;

// Level ground, slopes and walls, all around.
std::vector<Receiver> receivers_in(const sky::Inside& inside) {
  std::mt19937 random(48);
  const auto share = [&] { return static_cast<double>(random()) / 4294967296.0 * 2 - 1; };
  std::vector<Receiver> receivers;
  while (receivers.size() < kReceivers) {
    const map::BentPoint place = map::at(inside.cylinder, {share() * 1280, share() * 3072, 25 + 25 * share()});
    const Vec3 tilt{share(), share(), share()};
    const Vec3 normal = unit(place.up + tilt * (receivers.size() % 3 == 0   ? 0.0
                                                : receivers.size() % 3 == 1 ? 0.5
                                                                            : 3.0));
    receivers.push_back({place.at, normal});
  }
  return receivers;
}

std::vector<Segment> segments_of(const sky::Inside& inside) {
  std::vector<Segment> segments;
  for (const sky::LineLight& line : inside.lines)
    segments.push_back({map::at(inside.cylinder, line.from).at, map::at(inside.cylinder, line.to).at});
  return segments;
}

/// Returns the irradiance of a receiver by one segment.
using Method = std::function<double(const Segment&, const Receiver&)>;

/// A wall 20 m high and 40 m wide, 10 m from a receiver.
struct ScreenWall {
  Vec3 middle, away, along, up;  ///< `middle` is that of its foot.
};
constexpr double kScreenAway_m = 10, kScreenHeight_m = 20, kScreenHalfWidth_m = 20;

ScreenWall screen_wall_before(const Receiver& receiver) {
  const Vec3 up = receiver.normal;
  const Vec3 any = std::abs(up.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 along = unit(cross(up, any)), away = cross(along, up);
  return {receiver.at + away * kScreenAway_m, away, along, up};
}

bool is_behind(const ScreenWall& wall, Vec3 from, Vec3 direction) {
  const double ahead = dot(direction, wall.away);
  if (ahead <= 0) return false;
  const Vec3 on_wall = from + direction * (dot(wall.middle - from, wall.away) / ahead) - wall.middle;
  const double height_m = dot(on_wall, wall.up);
  return height_m >= 0 && height_m <= kScreenHeight_m && std::abs(dot(on_wall, wall.along)) <= kScreenHalfWidth_m;
}

double closed_form(const Segment& line, const Receiver& receiver) {
  const auto seen = sky::seen_line(line.from, line.to, receiver.at, receiver.normal);
  return seen ? sky::irradiance(*seen, receiver.normal) : 0;
}

// The middles of equal parts of the line's length, as points of light.
double by_points(const Segment& line, const Receiver& receiver, int count, bool has_wall = false) {
  const ScreenWall wall = screen_wall_before(receiver);
  const Vec3 whole = line.to - line.from, along = unit(whole);
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    const Vec3 out = line.from + whole * ((i + 0.5) / count) - receiver.at;
    if (has_wall && is_behind(wall, receiver.at, out)) continue;
    const double distance2 = dot(out, out), distance = std::sqrt(distance2);
    sum += length(cross(out, along)) / distance * std::max(0.0, dot(receiver.normal, out) / distance) / distance2;
  }
  return sum * length(whole) / count;
}

// The middles of equal parts of the sine of the angle along the line, over the part above the horizon: what the path
// tracer draws.
double by_angles(const Segment& line, const Receiver& receiver, int count, bool has_wall = false) {
  const ScreenWall wall = screen_wall_before(receiver);
  const auto seen = sky::seen_line(line.from, line.to, receiver.at, receiver.normal);
  if (!seen) return 0;
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    const Vec3 direction = direction_to(*seen, seen->low_sine + seen->extent() * (i + 0.5) / count);
    if (has_wall && is_behind(wall, receiver.at, direction)) continue;
    sum += std::max(0.0, dot(receiver.normal, direction));
  }
  return sum * sky::fluence(*seen) / count;
}

struct MethodCost {
  double error;  ///< Root mean square of the error over the mean irradiance.
  double time_us;
};

MethodCost method_cost(const Method& method, std::span<const Segment> lines, std::span<const Receiver> receivers,
                       std::span<const double> expected) {
  double squares = 0, mean = 0, seconds = 1e9;
  std::vector<double> found;
  // the fastest of several runs, since other programs run beside this one
  for (int run = 0; run < 7; ++run) {
    found.assign(receivers.size(), 0);
    const Stopwatch watch;
    for (std::size_t i = 0; i < receivers.size(); ++i)
      for (const Segment& line : lines) found[i] += method(line, receivers[i]);
    seconds = std::min(seconds, watch.seconds());
  }
  for (std::size_t i = 0; i < receivers.size(); ++i)
    squares += (found[i] - expected[i]) * (found[i] - expected[i]), mean += expected[i];
  const double count = static_cast<double>(receivers.size());
  return {std::sqrt(squares / count) / (mean / count), seconds * 1e6 / (count * static_cast<double>(lines.size()))};
}

Series sampled_series(const std::string& name,
                      const std::function<double(const Segment&, const Receiver&, int)>& method,
                      std::span<const int> counts, std::span<const Segment> lines, std::span<const Receiver> receivers,
                      std::span<const double> expected, std::vector<std::string>& notes) {
  Series series{name, {}};
  for (const int count : counts) {
    const MethodCost of = method_cost([&](const Segment& l, const Receiver& r) { return method(l, r, count); }, lines,
                                      receivers, expected);
    series.points.push_back({of.time_us, of.error});
    notes.push_back(fmt::format("{}, {} a line: error {:.2g}, {:.3f} µs", name, count, of.error, of.time_us));
  }
  return series;
}

constexpr int kLineCounts[] = {1, 2, 4, 8, 10, 16, 30, 32, 64, 128, 256};

using CountedMethod = double (*)(const Segment&, const Receiver&, int, bool);

std::vector<double> line_light_reference(std::span<const Segment> lines, std::span<const Receiver> receivers,
                                         bool has_wall) {
  constexpr int kReference = 20'000;  // without walls within about 1e-9
  std::vector<double> expected;
  for (const Receiver& receiver : receivers) {
    double sum = 0;
    for (const Segment& line : lines) sum += by_angles(line, receiver, kReference, has_wall);
    expected.push_back(sum);
  }
  return expected;
}

Chart line_light_chart(std::span<const Segment> lines, std::span<const Receiver> receivers, bool has_wall) {
  Chart chart{.name = has_wall ? "linelights_shadowed" : "linelights",
              .title = fmt::format("Irradiance of ground by the six lines inside of a cylinder{}",
                                   has_wall ? ", beside a wall" : ""),
              .x = {"time for a place and a line (µs)", true},
              .y = {"error, as a share of the mean irradiance", true},
              .series = {}};
  const std::vector<double> expected = line_light_reference(lines, receivers, has_wall);
  const auto add = [&](const std::string& name, CountedMethod method) {
    chart.series.push_back(sampled_series(
        name, [&](const Segment& l, const Receiver& r, int count) { return method(l, r, count, has_wall); },
        kLineCounts, lines, receivers, expected, chart.notes));
  };
  add("points of the line", by_points);
  add("angles above the horizon", by_angles);
  if (has_wall) return chart;
  const MethodCost closed = method_cost(closed_form, lines, receivers, expected);
  chart.series.push_back({"closed form", {{closed.time_us, std::max(closed.error, 1e-16)}}});
  chart.notes.push_back(
      fmt::format("closed form: error {:.2g} (of the reference), {:.3f} µs", closed.error, closed.time_us));
  return chart;
}

}  // namespace

Result<std::vector<Chart>> chart_linelights(const ChartRequest&) {
  const sky::Inside inside = sky::plan_inside({kDrumRadius_m}, {{-1280, -3072}, {1280, 3072}});
  const std::vector<Receiver> receivers = receivers_in(inside);
  const std::vector<Segment> lines = segments_of(inside);
  return std::vector{line_light_chart(lines, receivers, false), line_light_chart(lines, receivers, true)};
}

}  // namespace citykiln::charts
