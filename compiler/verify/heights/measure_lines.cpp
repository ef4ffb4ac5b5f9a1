#include "compiler/verify/heights/measure_lines.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/segment.h"
#include "compiler/ground/profiles/crossings/ground_crossings.h"
#include "compiler/ground/profiles/graph/grade_rules.h"
#include "compiler/ground/profiles/smoothing/profile_knots.h"
#include "compiler/ground/water/measure_waters.h"

namespace citykiln::verify {
namespace {

using structures::Span;

/// Adds a piece of constant grade inside the tile.
void add_stretch(Grades& grades, map::LandCoverClass surface, double run_m, double rise_m) {
  const double limit = ground::grade_rule_of(surface).limit;
  grades.length_m += run_m;
  if (std::abs(rise_m) > limit * run_m + 2 * ground::kKnotError_m) grades.over_m += run_m;
}

/// The length of a road's axis inside the box, between two distances along its way.
double length_in_m(const roads::Road& road, const std::vector<double>& along, double from_m, double to_m,
                   const Box2& box) {
  double sum_m = 0;
  for (std::size_t i = 0; i + 1 < along.size(); ++i) {
    const double low_m = std::max(from_m, along[i]), high_m = std::min(to_m, along[i + 1]);
    if (low_m >= high_m) continue;
    const double t = ((low_m + high_m) / 2 - along[i]) / (along[i + 1] - along[i]);
    if (box.contains_half_open(road.axis[i] + (road.axis[i + 1] - road.axis[i]) * t)) sum_m += high_m - low_m;
  }
  return sum_m;
}

void add_road(Grades& grades, const roads::Road& road, const Box2& box) {
  if (!ground::has_profile(road.surface)) return;
  const std::vector<double> along = roads::distances_along(road);
  const double limit = ground::grade_rule_of(road.surface).limit;
  grades.length_m += length_in_m(road, along, along.front(), along.back(), box);
  for (std::size_t i = 1; i < road.profile.size(); ++i) {
    const Knot a = road.profile[i - 1], b = road.profile[i];
    if (std::abs(b.z_m - a.z_m) > limit * (b.at_m - a.at_m) + 2 * ground::kKnotError_m)
      grades.over_m += length_in_m(road, along, a.at_m, b.at_m, box);
  }
}

void add_span(Grades& grades, const Span& span) {
  if (!ground::has_profile(span.surface)) return;
  for (std::size_t i = 1; i < span.profile.size(); ++i) {
    const Knot a = span.profile[i - 1], b = span.profile[i];
    add_stretch(grades, span.surface, b.at_m - a.at_m, b.z_m - a.z_m);
  }
}

/// The height of a line at one of its vertices.
struct Passing {
  Vec2 at;
  bool is_off_ground;
  double z_m;
};

void add_passings(const roads::Road& road, std::vector<Passing>& passings) {
  if (!ground::has_profile(road.surface) || road.profile.empty()) return;
  const std::vector<double> along = roads::distances_along(road);
  for (std::size_t i = 0; i < along.size(); ++i)
    passings.push_back({road.axis[i], false, knot_at(road.profile, along[i]).z_m});
}

void add_passings(const Span& span, std::vector<Passing>& passings) {
  if (!ground::has_profile(span.surface) || span.profile.empty()) return;
  const std::vector<double> along = roads::distances_along(span);
  passings.push_back({span.axis.front(), true, knot_at(span.profile, along.front()).z_m});
  passings.push_back({span.axis.back(), true, knot_at(span.profile, along.back()).z_m});
}

std::vector<Passing> passings_of(const scene::Scene& scene) {
  std::vector<Passing> passings;
  for (const scene::Chunk& chunk : scene.chunks) {
    for (const roads::Road& road : chunk.roads) add_passings(road, passings);
    for (const Span& bridge : chunk.bridges) add_passings(bridge, passings);
    for (const Span& tunnel : chunk.tunnels) add_passings(tunnel, passings);
  }
  std::ranges::sort(passings, {}, [](const Passing& p) { return std::tuple(p.at, p.is_off_ground, p.z_m); });
  return passings;
}

// A segment of a way on the ground, between two distances along it.
struct HeightSegment {
  Vec2 a, b;
  double from_m = 0, to_m = 0;
  const roads::Road* road = nullptr;

  double height_m(double share) const { return knot_at(road->profile, from_m + (to_m - from_m) * share).z_m; }
};

std::vector<HeightSegment> height_segments(const scene::Scene& scene) {
  std::vector<HeightSegment> segments;
  for (const scene::Chunk& chunk : scene.chunks)
    for (const roads::Road& road : chunk.roads) {
      if (!ground::has_profile(road.surface) || road.profile.empty()) continue;
      const std::vector<double> along = roads::distances_along(road);
      for (std::size_t i = 0; i + 1 < along.size(); ++i)
        segments.push_back({road.axis[i], road.axis[i + 1], along[i], along[i + 1], &road});
    }
  return segments;
}

bool share_an_end(const HeightSegment& s, const HeightSegment& t) {
  return s.a == t.a || s.a == t.b || s.b == t.a || s.b == t.b;
}

}  // namespace

std::vector<CrossingStep> measure_crossing_steps(const scene::Scene& scene) {
  constexpr double kBucket_m = 64;
  const std::vector<HeightSegment> segments = height_segments(scene);
  std::vector<Box2> boxes;
  for (const HeightSegment& s : segments) boxes.push_back(box_of_segment(s.a, s.b));
  const BoxGrid grid = grid_of(boxes, kBucket_m);
  std::map<std::pair<OsmId, OsmId>, CrossingStep> steps;
  for (std::size_t i = 0; i < segments.size(); ++i)
    for (const std::uint32_t j : boxes_about(grid, boxes[i])) {
      const HeightSegment &s = segments[i], &t = segments[j];
      const OsmId first = s.road->id.osm, second = t.road->id.osm;
      if (!(first < second) || !boxes[i].touches(boxes[j]) || share_an_end(s, t)) continue;
      const auto hit = crossing_shares(s.a, s.b, t.a, t.b);
      if (!hit) continue;
      const double step_m = std::abs(s.height_m(hit->first) - t.height_m(hit->second));
      CrossingStep& largest = steps[{first, second}];
      if (step_m > largest.step_m) largest = {first, second, step_m, s.a + (s.b - s.a) * hit->first};
    }
  std::vector<CrossingStep> found;
  for (const auto& [ways, step] : steps)
    if (step.step_m > ground::kSmallStep_m) found.push_back(step);
  std::ranges::stable_sort(found, std::ranges::greater{}, &CrossingStep::step_m);
  return found;
}

Grades measure_grades(const scene::Header& header, const scene::Chunk& chunk) {
  const Box2 box = scene::box_of(header, chunk.tile);
  Grades grades;
  for (const roads::Road& road : chunk.roads) add_road(grades, road, box);
  // bridges and tunnels are stored whole in every chunk that they touch
  for (const auto* spans : {&chunk.bridges, &chunk.tunnels})
    for (const Span& span : *spans)
      if (scene::baking_tile(header, span) == chunk.tile) add_span(grades, span);
  return grades;
}

Jumps measure_jumps(const scene::Scene& scene) {
  const std::vector<Passing> passings = passings_of(scene);
  Jumps jumps;
  for (std::size_t first = 0, last = 0; first < passings.size(); first = last) {
    double low_m = passings[first].z_m, high_m = low_m;
    for (last = first; last < passings.size() && passings[last].at == passings[first].at; ++last)
      low_m = std::min(low_m, passings[last].z_m), high_m = std::max(high_m, passings[last].z_m);
    jumps.places += last - first > 1;
    if (high_m - low_m > jumps.largest_m) jumps.largest_m = high_m - low_m, jumps.at = passings[first].at;
  }
  return jumps;
}

Rises measure_rises(const scene::Chunk& chunk) {
  // streams without a profile lie on the terrain: on level land, or reported as off it
  std::vector<roads::Strip> streams = chunk.watercourses;
  std::erase_if(streams, [](const roads::Strip& stream) { return stream.profile.empty(); });
  const ground::WaterMeasures measured = ground::measure_waters({}, streams, chunk.heights);
  return {measured.streams, measured.streams_that_rise, measured.largest_rise_m};
}

}  // namespace citykiln::verify
