// Effects of grade limits: earth moved by roads and their distance from the heightmap, over a factor on the limits.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/ground/plan.h"
#include "compiler/ground/profiles/graph/grade_rules.h"
#include "compiler/ground/profiles/plan_profiles.h"
#include "compiler/ground/profiles/smoothing/profile_knots.h"
#include "compiler/ground/water/plan_water_heights.h"
#include "compiler/map/heights/resample.h"
#include "compiler/map/locate.h"
#include "compiler/roads/roads_on_ground.h"
#include "compiler/source/read_osm.h"
#include "compiler/source/read_raster.h"
#include "compiler/source/voids/fill_gaps.h"
#include "tests/charts/chart.h"

namespace citykiln::charts {
namespace {

/// Step of the comparison along roads.
constexpr double kEvery_m = 4;

struct ProfileInputs {
  map::Features features;
  map::Heightfield heights;
  std::vector<roads::Road> roads;
  std::vector<roads::Junction> junctions;
  ground::Waters waters;
};

Result<ProfileInputs> read_profile_inputs(const ChartRequest& request) {
  if (request.maps.empty() || request.rasters.empty())
    return Error{"chart profile", "needs a map and a heightmap (--map FILE --dem FILE)"};
  Report ignored;
  const Result<source::OsmData> osm = source::read_osm(request.maps.front(), request.threads, ignored);
  if (!osm) return osm.error();
  const Result<std::vector<source::Raster>> rasters = source::read_heightmaps(request.rasters, nullptr, ignored);
  if (!rasters) return rasters.error();
  const source::LonLatBox box = map::choose_box(*osm, {});
  const map::Plane plane(map::default_origin(box));
  ProfileInputs inputs;
  inputs.features = map::locate(*osm, plane, box, {}, ignored);
  Result<map::Heightfield> heights = map::resample(*rasters, plane, inputs.features.extent, ignored);
  if (!heights) return heights.error();
  inputs.heights = std::move(*heights);
  inputs.roads = roads::roads_on_ground(inputs.features, ignored);
  inputs.junctions = roads::plan_junctions(inputs.roads, ignored);
  inputs.waters =
      ground::plan_water_heights(ground::plan(inputs.features, ignored), ground::plan_streams(inputs.features, ignored),
                                 ground::covered_waterways(inputs.features), inputs.heights, ignored);
  return inputs;
}

struct ProfileMeasure {
  double length_m = 0, over_m = 0, earth_m3 = 0, squares_m3 = 0;

  double over_percent() const { return 100 * over_m / std::max(length_m, 1.0); }
  double earth_m3_per_km() const { return earth_m3 / std::max(length_m * 1e-3, 1e-3); }
  double rms_m() const { return std::sqrt(squares_m3 / std::max(length_m, 1.0)); }
};

/// Integrates along the axis, with the heightmap sampled in the middle of each step.
void add_earth(const roads::Road& road, const map::Heightfield& heights, ProfileMeasure& measure) {
  const std::vector<double> along = roads::distances_along(road);
  for (std::size_t i = 0; i + 1 < along.size(); ++i) {
    const double long_m = along[i + 1] - along[i];
    const int n = std::max(1, static_cast<int>(std::ceil(long_m / kEvery_m)));
    for (int k = 0; k < n; ++k) {
      const double t = (k + 0.5) / n, step_m = long_m / n;
      const Vec2 p = road.axis[i] + (road.axis[i + 1] - road.axis[i]) * t;
      const double off_m = knot_at(road.profile, along[i] + long_m * t).z_m - map::height_m_at(heights, p);
      measure.length_m += step_m;
      measure.earth_m3 += std::abs(off_m) * roads::width_m(road) * step_m;
      measure.squares_m3 += off_m * off_m * step_m;
    }
  }
}

void add_grades(const roads::Road& road, double scale, ProfileMeasure& measure) {
  const double limit = scale * ground::grade_rule_of(road.surface).limit;
  for (std::size_t i = 1; i < road.profile.size(); ++i) {
    const Knot a = road.profile[i - 1], b = road.profile[i];
    const double run_m = b.at_m - a.at_m;
    if (std::abs(b.z_m - a.z_m) > limit * run_m + 2 * ground::kKnotError_m) measure.over_m += run_m;
  }
}

ProfileMeasure measure_at(const ProfileInputs& inputs, double scale) {
  Report ignored;
  ground::ProfileGraph graph = ground::graph_of(inputs.features, inputs.roads, inputs.junctions);
  graph.limit_scale = scale;
  const ground::Profiles profiles = ground::plan_profiles_on(
      graph, inputs.features, inputs.roads, inputs.waters.streams, inputs.waters.surfaces, inputs.heights, ignored);
  ProfileMeasure measure;
  for (const roads::Road& road : profiles.roads) {
    if (road.profile.empty() || !ground::has_profile(road.surface)) continue;
    add_earth(road, inputs.heights, measure);
    add_grades(road, scale, measure);
  }
  return measure;
}

Chart chart_of(const std::string& name, const std::string& title, const std::string& label, const std::string& map) {
  return {name,
          title + ", by the grade limit: " + map,
          {"grade limits, times the classes' own", true},
          {label, false},
          {{map, {}}}};
}

}  // namespace

Result<std::vector<Chart>> chart_profile(const ChartRequest& request) {
  const Result<ProfileInputs> inputs = read_profile_inputs(request);
  if (!inputs) return inputs.error();
  const std::string map = request.maps.front().substr(request.maps.front().rfind('/') + 1);
  Chart earth = chart_of("profile_earth", "Earth moved", "cut and filled under roads on the ground (m³ per km)", map);
  Chart error = chart_of("profile_error", "Profiles against the heightmap", "root mean square (m)", map);
  Chart over = chart_of("profile_over", "Share over the limit", "share of roads on the ground (%)", map);
  for (const double scale : {0.5, 0.7, 0.85, 1.0, 1.2, 1.4, 1.7, 2.0}) {
    const ProfileMeasure measure = measure_at(*inputs, scale);
    earth.series.front().points.emplace_back(scale, measure.earth_m3_per_km());
    error.series.front().points.emplace_back(scale, measure.rms_m());
    over.series.front().points.emplace_back(scale, measure.over_percent());
  }
  return std::vector{earth, error, over};
}

}  // namespace citykiln::charts
