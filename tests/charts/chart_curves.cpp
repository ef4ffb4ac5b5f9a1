// Corners of streets before and after their axes are curved, and how far the curves are from the mapped lines.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "compiler/assume/assume.h"
#include "compiler/geometry/mathematics.h"
#include "compiler/geometry/segment.h"
#include "compiler/map/locate.h"
#include "compiler/source/read_osm.h"
#include "tests/charts/chart.h"

namespace citykiln::charts {
namespace {

/// Turns at the inner nodes of streets, and distances of curves from the chords of the map.
struct Corners {
  std::vector<double> mapped_deg, curved_deg;  ///< At mapped nodes, in the same order.
  std::vector<double> between_deg;             ///< At the points of curves.
  std::vector<double> from_map_m;              ///< Distances of the points of curves.
};

double turn_deg(const Polyline& axis, std::size_t v) {
  const Vec2 in = axis[v] - axis[v - 1], out = axis[v + 1] - axis[v];
  return std::abs(arctangent2_deg(cross(in, out), dot(in, out)));
}

void add_corners(const map::Track& mapped, const map::Track& curved, Corners& corners) {
  std::size_t next = 1;
  for (std::size_t v = 1; v + 1 < curved.axis.size(); ++v) {
    const bool is_mapped = curved.node_ids[v] == mapped.node_ids[next];
    if (is_mapped) {
      corners.mapped_deg.push_back(turn_deg(mapped.axis, next++));
      corners.curved_deg.push_back(turn_deg(curved.axis, v));
    } else {
      corners.between_deg.push_back(turn_deg(curved.axis, v));
      corners.from_map_m.push_back(distance_to_segment(mapped.axis[next - 1], mapped.axis[next], curved.axis[v]));
    }
  }
}

Result<Corners> street_corners(const std::string& path, int threads) {
  Report ignored;
  const Result<source::OsmData> osm = source::read_osm(path, threads, ignored);
  if (!osm) return osm.error();
  const source::LonLatBox box = map::choose_box(*osm, {});
  const map::Features map = map::locate(*osm, map::Plane(map::default_origin(box)), box, {}, ignored);
  const assume::Assumed mapped = assume::assume(map, {.on = kNoAssumptions}, ignored);
  const assume::Assumed curved = assume::assume(map, {.on = bit_of(Assumption::kCurves)}, ignored);
  Corners corners;
  for (std::size_t t = 0; t < mapped.tracks.size(); ++t)
    if (map::is_street(mapped.tracks[t].surface)) add_corners(mapped.tracks[t], curved.tracks[t], corners);
  return corners;
}

double share_over(const std::vector<double>& turns, double least_deg) {
  return turns.empty()
             ? 0
             : 100.0 * static_cast<double>(std::ranges::count_if(turns, [&](double t) { return t > least_deg; })) /
                   static_cast<double>(turns.size());
}

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

std::string corner_row(const std::string& name, const Corners& c) {
  return fmt::format("| {} | {} | {:.1f} % | {:.1f} % | {:.1f} % | {} | {:.2f} % | {:.2f} | {:.2f} | {:.2f} |", name,
                     c.mapped_deg.size(), share_over(c.mapped_deg, 10), share_over(c.curved_deg, 10),
                     share_over(c.curved_deg, 60), c.between_deg.size(), share_over(c.between_deg, 10),
                     percentile(c.from_map_m, 0.5), percentile(c.from_map_m, 0.95), percentile(c.from_map_m, 1));
}

Series shares_of_turns(const std::string& name, const std::vector<double>& turns) {
  Series series{.name = name, .points = {}};
  for (int least_deg = 1; least_deg <= 90; ++least_deg)
    series.points.emplace_back(least_deg, share_over(turns, least_deg));
  return series;
}

}  // namespace

Result<std::vector<Chart>> chart_curves(const ChartRequest& request) {
  Chart chart{.name = "curves",
              .title = "Inner nodes of streets at which a car passes a corner",
              .x = {"corner of more than (degrees)"},
              .y = {"share of nodes (%)"},
              .series = {}};
  chart.notes = {
      "| map | inner nodes | over 10°, mapped | over 10°, curved | over 60° | points of curves | of these over 10° | "
      "median distance, m | 95 % | largest |",
      "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|"};
  for (const std::string& path : request.maps) {
    const Result<Corners> corners = street_corners(path, request.threads);
    if (!corners) return corners.error();
    const std::string name = std::filesystem::path(path).stem().stem().string();
    chart.series.push_back(shares_of_turns(name + ", mapped", corners->mapped_deg));
    chart.series.push_back(shares_of_turns(name + ", curved", corners->curved_deg));
    chart.notes.push_back(corner_row(name, *corners));
  }
  return std::vector{chart};
}

}  // namespace citykiln::charts
