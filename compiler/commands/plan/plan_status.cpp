#include "compiler/commands/plan/plan_status.h"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "compiler/commands/plan/plan_file.h"
#include "compiler/commands/plan/region_state.h"
#include "compiler/map/locate.h"
#include "compiler/map/plane/degrees.h"
#include "exporters/file.h"
#include "exporters/output_folder.h"

namespace citykiln::commands {
namespace {

using OrderedJson = nlohmann::ordered_json;

struct RegionStatus {
  PlannedRegion planned;
  RegionState state;
};

std::vector<RegionStatus> statuses_of(const Plan& plan, const std::string& folder) {
  std::vector<RegionStatus> all;
  for (const PlannedRegion& region : plan.regions) all.push_back({region, read_state(folder, region.key)});
  return all;
}

/// Returns the remaining seconds of one core: those expected, scaled by what finished tasks took in relation to what
/// was expected.
double seconds_left(const std::vector<RegionStatus>& all) {
  double expected_s = 0, expected_done_s = 0, took_s = 0;
  for (const auto& [planned, state] : all) {
    if (state.state != TaskState::kDone) expected_s += planned.expected.seconds;
    if (state.state == TaskState::kDone) expected_done_s += planned.expected.seconds, took_s += state.seconds;
  }
  return expected_done_s > 0 ? expected_s * took_s / expected_done_s : expected_s;
}

OrderedJson region_status_json(const RegionStatus& region) {
  OrderedJson json = {{"region", to_string(region.planned.key)},
                      {"state", name_of(region.state.state)},
                      {"tiles", region.planned.tiles},
                      {"expected_seconds", region.planned.expected.seconds},
                      {"expected_memory_bytes", region.planned.expected.memory_bytes}};
  if (region.state.state == TaskState::kDone)
    json["seconds"] = region.state.seconds, json["memory_bytes"] = region.state.memory_bytes,
    json["output_bytes"] = region.state.output_bytes;
  if (!region.state.error.empty()) json["error"] = region.state.error;
  return json;
}

OrderedJson outline_of(const Box2& box, const map::Plane& plane) {
  OrderedJson ring = OrderedJson::array();
  for (const Vec2 corner : {box.min, Vec2{box.max.x, box.min.y}, box.max, Vec2{box.min.x, box.max.y}, box.min}) {
    const LonLat place = plane.backward(corner);
    ring.push_back({map::rounded_degrees(place.lon_deg), map::rounded_degrees(place.lat_deg)});
  }
  return {{"type", "Polygon"}, {"coordinates", {ring}}};
}

Result<Done> write_geojson(const std::vector<RegionStatus>& all, const Plan& plan, const std::string& path) {
  const Result<CompileRequest> request = request_of(plan);
  if (!request) return request.error();
  const Result<CompileSpec> spec = spec_of(*request);
  if (!spec) return spec.error();
  const map::Plane plane(spec->map.origin.value_or(map::default_origin(plan.extent)));
  OrderedJson features = OrderedJson::array();
  for (const RegionStatus& region : all)
    features.push_back({{"type", "Feature"},
                        {"geometry", outline_of(regions::box_of(plan.grid, region.planned.key), plane)},
                        {"properties", region_status_json(region)}});
  const OrderedJson json = {{"type", "FeatureCollection"}, {"features", features}};
  const std::string text = json.dump(1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
  return exporters::write_file(path, exporters::bytes_of(text));
}

}  // namespace

Result<Exit> print_status(const std::string& plan_folder, const std::string& geojson, const Console& console) {
  const Result<Plan> plan = read_plan(plan_folder);
  if (!plan) return plan.error();
  const std::vector<RegionStatus> all = statuses_of(*plan, plan_folder);
  std::map<TaskState, std::size_t> counts;
  for (const RegionStatus& region : all) ++counts[region.state.state];
  std::string line = fmt::format("{}: {} regions", plan_folder, all.size());
  for (const auto& [state, count] : counts) line += fmt::format(", {} {}", count, name_of(state));
  console.print_line(fmt::format("{}; {:.2f} core hours left", line, seconds_left(all) / 3600));
  OrderedJson regions = OrderedJson::array();
  for (const RegionStatus& region : all) {
    regions.push_back(region_status_json(region));
    if (region.state.state == TaskState::kFailed)
      console.print_line(fmt::format("  region {} failed: {}", to_string(region.planned.key), region.state.error));
  }
  const OrderedJson json = {{"regions", regions}, {"seconds_left", seconds_left(all)}};
  console.print_json(json.dump(1, ' ', false, OrderedJson::error_handler_t::replace) + "\n");
  if (geojson.empty()) return Exit::kDone;
  const Result<Done> written = write_geojson(all, *plan, geojson);
  return written ? Result<Exit>(Exit::kDone) : written.error();
}

}  // namespace citykiln::commands
