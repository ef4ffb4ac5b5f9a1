#include "compiler/commands/plan/plan_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "compiler/outputs/ledger_json.h"

namespace citykiln::commands {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr int kPlanVersion = 3;

OrderedJson planned_region_json(const PlannedRegion& region) {
  return {{"region", to_string(region.key)},
          {"x", region.key.x},
          {"y", region.key.y},
          {"tiles", region.tiles},
          {"file_bytes", region.file.bytes},
          {"nodes", region.file.nodes},
          {"ways", region.file.ways},
          {"relations", region.file.relations},
          {"way_nodes", region.file.way_nodes},
          {"own_way_nodes", region.file.own_way_nodes},
          {"own_nodes", region.file.own_nodes},
          {"own_building_nodes", region.file.own_building_nodes},
          {"own_road_nodes", region.file.own_road_nodes},
          {"own_trees", region.file.own_trees},
          {"own_plantings", region.file.own_plantings},
          {"terrain_vertices", region.terrain_vertices},
          {"expected",
           {{"seconds", region.expected.seconds},
            {"memory_bytes", region.expected.memory_bytes},
            {"output_bytes", region.expected.output_bytes}}}};
}

PlannedRegion region_of(const OrderedJson& json) {
  const OrderedJson& expected = json.at("expected");
  return {.key = {json.at("x"), json.at("y")},
          .tiles = json.at("tiles"),
          .file = {.bytes = json.at("file_bytes"),
                   .nodes = json.at("nodes"),
                   .ways = json.at("ways"),
                   .relations = json.at("relations"),
                   .way_nodes = json.at("way_nodes"),
                   .own_way_nodes = json.at("own_way_nodes"),
                   .own_nodes = json.at("own_nodes"),
                   .own_building_nodes = json.at("own_building_nodes"),
                   .own_road_nodes = json.at("own_road_nodes"),
                   .own_trees = json.at("own_trees"),
                   .own_plantings = json.at("own_plantings")},
          .terrain_vertices = json.at("terrain_vertices"),
          .expected = {expected.at("seconds"), expected.at("memory_bytes"), expected.at("output_bytes")}};
}

// Each polygon as its rings, the outer one first, in plane metres.
OrderedJson clip_json(const scene::Clip& clip) {
  OrderedJson polygons = OrderedJson::array();
  for (const Polygon& polygon : clip) {
    OrderedJson rings = OrderedJson::array();
    for (const Ring* ring : rings_of(polygon)) {
      OrderedJson points = OrderedJson::array();
      for (const Vec2 p : *ring) points.push_back({p.x, p.y});
      rings.push_back(std::move(points));
    }
    polygons.push_back(std::move(rings));
  }
  return polygons;
}

scene::Clip clip_of(const OrderedJson& plan) {
  scene::Clip clip;
  if (!plan.contains("clip_m")) return clip;
  for (const OrderedJson& rings : plan.at("clip_m")) {
    Polygon& polygon = clip.emplace_back();
    for (const OrderedJson& points : rings) {
      Ring ring;
      for (const OrderedJson& p : points) ring.push_back({p.at(0).get<double>(), p.at(1).get<double>()});
      (polygon.outer.empty() ? polygon.outer : polygon.holes.emplace_back()) = std::move(ring);
    }
  }
  return clip;
}

Plan plan_of(const OrderedJson& json) {
  Plan plan{.working_folder = json.at("working_folder"),
            .spec_path = json.at("spec"),
            .settings = {},
            .extent = {},
            .grid = {},
            .regions = {},
            .elements = {}};
  for (const OrderedJson& setting : json.at("settings")) plan.settings.emplace_back(setting.at(0), setting.at(1));
  const OrderedJson &degrees = json.at("extent_deg"), &metres = json.at("extent_m");
  plan.extent = {degrees.at(0), degrees.at(1), degrees.at(2), degrees.at(3)};
  plan.grid = {.extent = {{metres.at(0), metres.at(1)}, {metres.at(2), metres.at(3)}},
               .tile_m = json.at("tile_m"),
               .region_m = json.at("region_m"),
               .halo_m = json.at("halo_m"),
               .clip = clip_of(json)};
  for (const OrderedJson& region : json.at("regions")) plan.regions.push_back(region_of(region));
  outputs::add_ledger(json.at("elements"), plan.elements);
  return plan;
}

}  // namespace

std::string plan_json(const Plan& plan) {
  OrderedJson json = {
      {"citykiln_plan", kPlanVersion}, {"working_folder", plan.working_folder}, {"spec", plan.spec_path}};
  json["settings"] = OrderedJson::array();
  for (const auto& [name, value] : plan.settings) json["settings"].push_back({name, value});
  json["extent_deg"] = {plan.extent.west, plan.extent.south, plan.extent.east, plan.extent.north};
  const Box2& extent = plan.grid.extent;
  json["extent_m"] = {extent.min.x, extent.min.y, extent.max.x, extent.max.y};
  json["tile_m"] = plan.grid.tile_m, json["region_m"] = plan.grid.region_m, json["halo_m"] = plan.grid.halo_m;
  if (!plan.grid.clip.empty()) json["clip_m"] = clip_json(plan.grid.clip);
  json["elements"] = outputs::ledger_json(plan.elements);
  json["regions"] = OrderedJson::array();
  for (const PlannedRegion& region : plan.regions) json["regions"].push_back(planned_region_json(region));
  return json.dump(1) + "\n";
}

Result<Plan> read_plan(const std::string& folder) {
  const std::string path = folder + "/plan.json";
  std::ifstream file(path, std::ios::binary);
  if (!file) return Error{path, "cannot be read; expected the folder of a plan (citykiln plan)"};
  try {
    const OrderedJson json = OrderedJson::parse(file);
    if (json.at("citykiln_plan") != kPlanVersion) return Error{path, "is a plan of another version of citykiln"};
    return plan_of(json);
  } catch (const nlohmann::json::exception&) {
    return Error{path, "is not a plan written by citykiln"};
  }
}

Result<CompileRequest> request_of(const Plan& plan) {
  CompileRequest request{.spec_path = plan.spec_path, .given = {}};
  for (const auto& [name, value] : plan.settings) {
    const auto setting = std::ranges::find(settings(), name, &Setting::name);
    if (setting == settings().end()) return Error{"plan.json", fmt::format("unknown setting \"{}\"", name)};
    request.given.emplace_back(&*setting, value);
  }
  return request;
}

Result<PlannedRegion> region_named(const Plan& plan, const std::string& name) {
  for (const PlannedRegion& region : plan.regions)
    if (to_string(region.key) == name) return region;
  if (plan.regions.empty()) return Error{"--region", "the plan has no regions"};
  return Error{"--region",
               fmt::format("the plan has no region \"{}\"; its {} regions are {} to {}", name, plan.regions.size(),
                           to_string(plan.regions.front().key), to_string(plan.regions.back().key))};
}

source::OwnsPlace owned_places(const Plan& plan, const map::Plane& plane, regions::RegionKey region) {
  return [grid = plan.grid, extent = plan.extent, &plane, region](double lon, double lat) {
    return regions::owner_of(grid, regions::place_near(plane, extent, lon, lat)) == region;
  };
}

std::string cut_path(const std::string& plan_folder, regions::RegionKey region) {
  return plan_folder + "/cut/" + to_string(region) + ".osm.pbf";
}

std::string outputs_path(const std::string& plan_folder, regions::RegionKey region) {
  return plan_folder + "/regions/" + to_string(region);
}

std::string survey_findings_path(const std::string& plan_folder) { return plan_folder + "/survey.json"; }

}  // namespace citykiln::commands
