#include "compiler/commands/plan/zone_lists.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "compiler/map/plane/degrees.h"

namespace citykiln::commands {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson zone_json(const regions::Zone& zone) {
  return {{"zone", to_string(zone)},
          {"box_deg", map::rounded_degrees(zone.box)},
          {"scale_error_ppm", regions::scale_error(zone) * 1e6}};
}

Result<std::vector<std::string>> zone_names(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  try {
    std::vector<std::string> names;
    const OrderedJson json = OrderedJson::parse(file);
    for (const OrderedJson& zone : json.at("zones")) names.push_back(zone.at("zone"));
    return names;
  } catch (const nlohmann::json::exception&) {
    return Error{path, "is not a list of zones written by citykiln"};
  }
}

}  // namespace

std::string zone_path(const std::string& plan_folder, const std::string& zone) {
  return plan_folder + "/zones/" + zone;
}

std::map<std::string, std::string> zone_lists(const std::vector<regions::Zone>& zones) {
  OrderedJson json = {{"agreement_m", regions::kZoneAgreement_m}, {"zones", OrderedJson::array()}};
  std::string ninja =
      "# Written by citykiln plan; run `ninja -C` with this folder.\n"
      "ninja_required_version = 1.5\n\n"
      "rule zone\n  command = ninja -C zones/$zone\n  description = zone $zone\n  pool = console\n\n";
  std::string submit =
      "#!/bin/sh\n# Written by citykiln plan: submits the tasks of all zones to Slurm.\nset -eu\n"
      "cd \"$(dirname \"$0\")\"\n";
  for (const regions::Zone& zone : zones) {
    const std::string name = to_string(zone);
    json["zones"].push_back(zone_json(zone));
    // the output never exists, so that Ninja looks into each zone every time
    ninja += fmt::format("build zone_{0}: zone\n  zone = {0}\n", name);
    submit += fmt::format("zones/{}/submit.sh \"$@\"\n", name);
  }
  return {{"zones.json", json.dump(1) + "\n"}, {"build.ninja", ninja}, {"submit.sh", submit}};
}

bool has_zones(const std::string& plan_folder) {
  std::error_code none;
  return std::filesystem::exists(plan_folder + "/zones.json", none);
}

Result<Exit> for_each_zone(const std::string& plan_folder,
                           const std::function<Result<Exit>(const std::string& folder)>& visit) {
  if (!has_zones(plan_folder)) return visit(plan_folder);
  const Result<std::vector<std::string>> names = zone_names(plan_folder + "/zones.json");
  if (!names) return names.error();
  Result<Exit> first = Exit::kDone;
  for (const std::string& name : *names)
    if (const Result<Exit> visited = visit(zone_path(plan_folder, name)); !visited && first) first = visited.error();
  return first;
}

}  // namespace citykiln::commands
