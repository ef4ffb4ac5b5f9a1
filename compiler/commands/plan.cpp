// citykiln plan MAP … --region M -o PLAN: cuts a map into regions that are compiled apart.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>

#include "compiler/commands/compile_request.h"
#include "compiler/commands/plan/expected_cost.h"
#include "compiler/commands/plan/plan_file.h"
#include "compiler/commands/plan/plan_status.h"
#include "compiler/commands/plan/survey_file.h"
#include "compiler/commands/plan/task_lists.h"
#include "compiler/commands/plan/zone_lists.h"
#include "compiler/commands/verb.h"
#include "compiler/contract/system/give_back_memory.h"
#include "compiler/edits/with_edits.h"
#include "compiler/find_area.h"
#include "compiler/make_clip.h"
#include "compiler/map/extent/choose_extent.h"
#include "compiler/outputs/findings.h"
#include "compiler/regions/cut_extract.h"
#include "compiler/regions/radii.h"
#include "compiler/regions/zones.h"
#include "exporters/file.h"
#include "exporters/output_folder.h"

namespace citykiln::commands {
namespace {

namespace fs = std::filesystem;

struct PlanRequest {
  CompileRequest compile;
  double region_m = 16384, zone_m = regions::kZoneSide_m;
  double halo_m = 0;  // 0: usual_halo_m()
  std::string status, geojson;
};

/// Checks that regions can have these outputs. Error: they do not have them yet.
Result<Done> can_be_planned(const CompileSpec& spec) {
  if (spec.outputs.surroundings == AroundWish::kYes && (spec.outputs.usd || spec.outputs.tiles3d))
    return Error{"--surroundings", "a plan writes the land around the map as .glb only; leave usd and 3dtiles out"};
  if (!spec.outputs.manifest) return Error{"--emit", "a plan needs manifests; add kiln"};
  if (spec.outputs.tiles3d_archive)
    return Error{"--emit", "a plan writes no archive, since gather joins none; give 3dtiles instead of 3tz"};
  if (spec.outputs.page) return Error{"--emit", "a plan writes no page, which shows one run; leave page out"};
  if (spec.world == World::kCylinder) return Error{"--world", "a plan is for worlds in the plane; compile instead"};
  if (!spec.only.empty()) return Error{"--only", "a plan has all tiles; give a part of the map with --bbox"};
  return Done{};
}

/// The extent in degrees: the box asked for, limited as compile does, or that of the map's header.
Result<source::LonLatBox> extent_of(const CompileSpec& spec, Report& report) {
  source::OsmData header;
  const Result<source::LonLatBox> box = regions::header_box_of(spec.map_path);
  if (!box && !spec.map.bbox) return box.error();
  if (!box) return *spec.map.bbox;
  const double width_deg = box->east - box->west;
  if (!spec.map.bbox && width_deg > 180 && width_deg < 360)
    return Error{spec.map_path,
                 "has a box that crosses 180 degrees, which a plan cannot cut; compile it in one run, "
                 "or plan each side with --bbox W,S,E,N"};
  header.header_box = *box, header.node_box = *box;
  return map::choose_extent(header, spec.map.bbox, report);
}

double usual_halo_m(const CompileSpec& spec) {
  const double moved_m = spec.edits ? edits::longest_move_m(*spec.edits) : 0;
  return regions::kRegionHalo_m + (spec.fill_lots ? regions::kFilledLotsHalo_m : 0) +
         std::ceil(moved_m / map::kCell_m) * map::kCell_m;
}

Result<Plan> make_plan(const PlanRequest& request, const CompileSpec& spec, const source::LonLatBox& extent,
                       const map::Plane& plane) {
  Plan plan{.working_folder = fs::current_path().string(),
            .spec_path = request.compile.spec_path,
            .settings = {},
            .extent = extent,
            .grid = {},
            .regions = {},
            .elements = {}};
  for (const auto& [setting, text] : request.compile.given) plan.settings.emplace_back(setting->name, text);
  plan.grid = {.extent = map::extent_of(plane, extent),
               .tile_m = spec.tile_m,
               .region_m = request.region_m,
               .halo_m = request.halo_m > 0 ? request.halo_m : usual_halo_m(spec),
               .clip = make_clip(spec, plane)};
  if (const Result<Done> sound = regions::check_grid(plan.grid); !sound) return sound.error();
  if (plan.grid.extent.width() > map::kMaxSide_m || plan.grid.extent.height() > map::kMaxSide_m)
    return Error{spec.map_path, fmt::format("the area measures {:.0f} x {:.0f} km; give a part of at most {:.0f} km a "
                                            "side with --bbox W,S,E,N",
                                            plan.grid.extent.width() / 1000, plan.grid.extent.height() / 1000,
                                            map::kMaxSide_m / 1000)};
  return plan;
}

/// The number of vertices of the heights around a region.
std::size_t vertices_near(const map::Heightfield& heights, const regions::RegionGrid& grid, regions::RegionKey region) {
  const map::Heightfield window = map::window_of(heights, regions::box_of(grid, region).widened(grid.halo_m));
  return window.heights.size();
}

void describe_regions(const regions::CutFiles& files, const map::Heightfield& heights, const CompileSpec& spec,
                      Plan& plan) {
  const std::vector<regions::RegionKey> keys = regions::regions_of(plan.grid);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (regions::tiles_of(plan.grid, keys[i]).empty()) continue;
    PlannedRegion region{.key = keys[i],
                         .tiles = regions::tiles_of(plan.grid, keys[i]).size(),
                         .file = files.regions[i],
                         .terrain_vertices = vertices_near(heights, plan.grid, keys[i]),
                         .expected = {}};
    region.expected = expected_cost(region, plan.grid.tile_m, spec.outputs.tolerances_m);
    plan.regions.push_back(region);
  }
  plan.elements = files.report;
}

Result<Done> write_if_changed(const std::string& path, const std::string& text) {
  const Result<std::vector<std::byte>> before = exporters::read_file(path);
  if (before && std::ranges::equal(*before, exporters::bytes_of(text))) return Done{};
  return exporters::write_file(path, exporters::bytes_of(text));
}

Result<Done> write_lists(const Plan& plan, const std::string& folder) {
  const std::string program = fs::read_symlink("/proc/self/exe").string();
  std::map<std::string, std::string> files = task_lists(plan, program);
  files["plan.json"] = plan_json(plan);
  for (const auto& [name, text] : files) {
    if (Result<Done> done = write_if_changed(folder + "/" + name, text); !done) return done;
    std::error_code none;
    if (name.ends_with(".sh")) fs::permissions(folder + "/" + name, fs::perms(0755), none);
  }
  return Done{};
}

void print_plan_summary(const Plan& plan, const std::string& folder, double seconds, const Console& console) {
  ExpectedCost all;
  std::uint64_t most_bytes = 0;
  std::size_t tiles = 0;
  for (const PlannedRegion& region : plan.regions) {
    all.seconds += region.expected.seconds, all.output_bytes += region.expected.output_bytes;
    most_bytes = std::max(most_bytes, region.expected.memory_bytes);
    tiles += region.tiles;
  }
  console.print_line(fmt::format(
      "{}: {} regions, {} tiles, planned in {:.1f} s; expected: {:.1f} core hours, up to {:.1f} "
      "GB of memory a task, {:.1f} GB of outputs",
      folder, plan.regions.size(), tiles, seconds, all.seconds / 3600, most_bytes * 1e-9, all.output_bytes * 1e-9));
  console.print_line(
      fmt::format("  ninja -C {0}      compiles them on this machine\n  {0}/submit.sh      on a cluster, with "
                  "Slurm\n  citykiln plan --status {0}",
                  folder));
}

/// Plans one extent in one plane, in the folder of the spec.
Result<Exit> plan_extent(const PlanRequest& request, const CompileSpec& spec, const source::LonLatBox& extent,
                         Report& report, const Console& console) {
  const auto begin = std::chrono::steady_clock::now();
  const map::Plane plane(spec.map.origin.value_or(map::default_origin(extent)));
  Result<Plan> plan = make_plan(request, spec, extent, plane);
  if (!plan) return plan.error();

  const std::string& folder = spec.outputs.folder;
  std::error_code problem;
  fs::create_directories(folder + "/cut", problem);
  if (problem) return Error{folder, "cannot be created: " + problem.message()};
  const OnProgress on_progress = console.progress();
  on_progress("cut", 0);
  const Result<regions::CutFiles> files = regions::cut_extract(
      {spec.map_path, folder + "/cut", extent, spec.threads, spec.edits ? &*spec.edits : nullptr}, plane, plan->grid);
  if (!files) return files.error();
  give_back_memory();
  if (spec.edits) edits::report_lines(*spec.edits, files->edits_had_effect, report);
  const Result<Survey> surveyed = survey(spec, folder + "/cut/survey.osm.pbf", extent, report, on_progress);
  if (!surveyed) return surveyed.error();
  if (Result<Done> done = write_survey(*surveyed, plan->grid, folder, spec.threads); !done) return done.error();
  const std::vector<outputs::Finding> findings = outputs::findings_of(report, surveyed->places, {}, surveyed->header);
  const std::string diagnosed = outputs::findings_json(findings, surveyed->header);
  if (Result<Done> done = write_if_changed(survey_findings_path(folder), diagnosed); !done) return done.error();
  describe_regions(*files, surveyed->heights, spec, *plan);
  if (spec.edits) plan->elements.account("edits", "line") = report.account("edits", "line");
  if (Result<Done> done = write_lists(*plan, folder); !done) return done.error();
  print_plan_summary(*plan, folder, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(),
                     console);
  console.print_json(plan_json(*plan));
  return Exit::kDone;
}

/// The zones with ground in the clip. Error: there is none.
Result<std::vector<regions::Zone>> zones_in_clip(const CompileSpec& spec, std::vector<regions::Zone> zones) {
  std::erase_if(zones, [&](const regions::Zone& zone) {
    const map::Plane plane(map::default_origin(zone.box));
    return !scene::touches_clip(make_clip(spec, plane), map::extent_of(plane, zone.box));
  });
  if (zones.empty()) return Error{spec.clip->where, "leaves no ground of the map inside"};
  return zones;
}

/// Plans each zone in a folder of its own, and writes the lists over all of them.
Result<Exit> plan_zones(const PlanRequest& request, const CompileSpec& spec, const std::vector<regions::Zone>& zones,
                        const Report& of_extent, const Console& console) {
  if (spec.map.origin)
    return Error{"--origin",
                 fmt::format("the area is cut into {} zones of at most {:.0f} m, each with an origin of its "
                             "own; leave the origin out",
                             zones.size(), request.zone_m)};
  for (const regions::Zone& zone : zones) {
    CompileSpec of_zone = spec;
    of_zone.outputs.folder = zone_path(spec.outputs.folder, to_string(zone));
    // diagnoses of the whole extent are reported once
    Report report = &zone == &zones.front() ? of_extent : Report();
    const Result<Exit> planned = plan_extent(request, of_zone, zone.box, report, console);
    if (!planned) return planned;
    console.print_line(
        fmt::format("zone {}: scale error up to {:.0f} ppm", to_string(zone), regions::scale_error(zone) * 1e6));
  }
  for (const auto& [name, text] : zone_lists(zones)) {
    const std::string path = spec.outputs.folder + "/" + name;
    if (Result<Done> done = write_if_changed(path, text); !done) return done.error();
    std::error_code none;
    if (name.ends_with(".sh")) fs::permissions(path, fs::perms(0755), none);
  }
  return Exit::kDone;
}

Result<Exit> plan_map(const PlanRequest& request, const Console& console) {
  Result<CompileSpec> spec = spec_of(request.compile);
  if (!spec) return spec.error();
  if (const Result<Done> complete = check_complete(*spec); !complete) return complete.error();
  if (const Result<Done> area = resolve_area(*spec); !area) return area.error();
  if (const Result<Done> can = can_be_planned(*spec); !can) return can.error();
  if (spec->outputs.surroundings == AroundWish::kWherePossible && (spec->outputs.usd || spec->outputs.tiles3d))
    console.print_line("note: a plan writes the land around the map as .glb only, without usd and 3dtiles");
  Report report;
  const Result<source::LonLatBox> extent = extent_of(*spec, report);
  if (!extent) return extent.error();
  const std::vector<regions::Zone> zones = regions::zones_of(*extent, request.zone_m);
  if (zones.size() > 1) {
    const auto clipped = zones_in_clip(*spec, zones);
    if (!clipped) return clipped.error();
    return plan_zones(request, *spec, *clipped, report, console);
  }
  return plan_extent(request, *spec, *extent, report, console);
}

}  // namespace

Verb plan_verb() {
  const auto request = std::make_shared<PlanRequest>();
  Verb verb{"plan",
            "cuts a map into regions that are compiled apart, in the memory of one region",
            options_of(request->compile),
            {}};
  verb.options.push_back({"--region", "M", "side of a region in metres, a multiple of --tile (default: 16384)", false,
                          store_number(request->region_m, {})});
  verb.options.push_back({"--halo", "M",
                          "data around a region that are compiled with it; less than the default changes tiles at its "
                          "sides (default: 12416; 14208 with --fill lots)",
                          false, store_number(request->halo_m, {})});
  verb.options.push_back({"--zone", "M",
                          "longest side of a zone, which has a plane of its own, in metres (default: 200000)", false,
                          store_number(request->zone_m, {})});
  verb.options.push_back(
      {"--status", "PLAN", "prints how far this plan is, instead of planning", false, store_text(request->status)});
  verb.options.push_back({"--geojson", "FILE", "with --status: writes the regions with their states", false,
                          store_text(request->geojson)});
  verb.examples = {"citykiln plan andorra.osm.pbf --dem heights/ --region 16384 -o out/plan", "ninja -C out/plan",
                   "citykiln plan --status out/plan"};
  verb.interrupted = "the plan is not finished; the same command makes it";
  verb.run = [request](const Console& console) -> Result<Exit> {
    if (request->status.empty()) return plan_map(*request, console);
    if (!request->geojson.empty() && has_zones(request->status))
      return Error{"--geojson", "the plan has zones; give the folder of one of them, such as zones/0_0"};
    return for_each_zone(request->status,
                         [&](const std::string& folder) { return print_status(folder, request->geojson, console); });
  };
  return verb;
}

}  // namespace citykiln::commands
