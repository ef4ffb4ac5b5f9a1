#include "compiler/outputs/run_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>

#include "compiler/bake/bake.h"
#include "compiler/contract/system/program_version.h"
#include "compiler/map/plane/degrees.h"
#include "compiler/map/plane/lonlat_box.h"
#include "compiler/outputs/findings.h"
#include "compiler/outputs/ledger_json.h"
#include "compiler/outputs/written_tile_json.h"
#include "compiler/scene/kinds.h"
#include "exporters/finish_commit.h"
#include "exporters/run_files.h"

namespace citykiln::outputs {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// Object ids listed for each diagnosis.
constexpr std::size_t kNamedObjects = 20;

/// All diagnoses with one code.
struct Tally {
  std::uint64_t count = 0;
  double largest = 0;
  std::set<OsmId> objects;
  std::map<std::string, std::uint64_t> tags;  ///< Diagnoses by tag, for those that have one.
};

OrderedJson diagnoses_of(const Report& report) {
  std::map<Code, Tally> tallies;
  for (const Diagnosis& diagnosis : report.diagnoses()) {
    Tally& tally = tallies[diagnosis.code];
    ++tally.count;
    tally.largest = std::max(tally.largest, rounded_size(diagnosis));
    tally.objects.insert(diagnosis.object);
    if (!diagnosis.tag.empty()) ++tally.tags[diagnosis.tag];
    // keeps the lowest ids, so the list does not depend on the order of diagnoses
    if (tally.objects.size() > kNamedObjects) tally.objects.erase(std::prev(tally.objects.end()));
  }
  OrderedJson diagnoses = OrderedJson::object();
  for (const auto& [code, tally] : tallies) {
    OrderedJson objects = OrderedJson::array();
    for (const OsmId object : tally.objects) objects.push_back(to_string(object));
    diagnoses[std::string(name_of(code))] = {{"severity", name_of(severity_of(code))},
                                             {"meaning", text_of(code)},
                                             {"count", tally.count},
                                             {"largest_size", tally.largest},
                                             {"objects", objects}};
    if (!tally.tags.empty()) diagnoses[std::string(name_of(code))]["tags"] = tally.tags;
  }
  return diagnoses;
}

/// The number of different objects of each kind in all chunks, by the kinds' names: an object that crosses a tile
/// border is in several.
std::map<std::string_view, std::size_t> different(const scene::Scene& scene) {
  std::map<std::string_view, std::set<ObjectId>> ids;
  for (const scene::Chunk& chunk : scene.chunks)
    scene::for_each_element_kind(chunk, [&](std::string_view kind, const auto& objects) {
      std::set<ObjectId>& of_kind = ids[kind];
      for (const auto& object : objects) of_kind.insert(object.id);
    });
  std::map<std::string_view, std::size_t> counts;
  for (const auto& [kind, of_kind] : ids) counts[kind] = of_kind.size();
  return counts;
}

// The kinds that are counted, in the order of the report. Further kinds follow, by name.
constexpr std::string_view kFirstKinds[] = {"roads", "surfaces", "bridges", "tunnels", "buildings",
                                            "trees", "barriers", "lamps",   "things",  "wire_spans"};
constexpr std::string_view kNotCounted[] = {"watercourses", "landforms", "tree_rows"};

OrderedJson counts_of(const scene::Scene& scene) {
  std::size_t junctions = 0;
  for (const scene::Chunk& chunk : scene.chunks) junctions += scene::anchored_junctions(scene.header, chunk).size();
  std::map<std::string_view, std::size_t> of_kinds = different(scene);
  OrderedJson counts = {{"tiles", scene.chunks.size()}};
  for (const std::string_view kind : kFirstKinds) {
    counts[kind == "surfaces" ? "land_cover_polygons" : std::string(kind)] = of_kinds[kind];
    if (kind == "roads") counts["junctions"] = junctions;
  }
  for (const auto& [kind, count] : of_kinds)
    if (std::ranges::find(kFirstKinds, kind) == std::end(kFirstKinds) &&
        std::ranges::find(kNotCounted, kind) == std::end(kNotCounted))
      counts[std::string(kind)] = count;
  return counts;
}

OrderedJson levels_of(std::span<const WrittenTile> tiles, const Outputs& outputs) {
  OrderedJson levels = OrderedJson::array();
  for (std::size_t n = 0; n < outputs.tolerances_m.size(); ++n) {
    std::uint64_t bytes = 0, triangles = 0;
    double error_m = 0;
    for (const WrittenTile& tile : tiles) {
      if (tile.level != n) continue;
      bytes += tile.file.bytes;
      triangles += tile.triangles;
      error_m = std::max(error_m, tile.error_m);
    }
    levels.push_back({{"level", n},
                      {"tolerance_m", outputs.tolerances_m[n]},
                      {"error_m", error_m},
                      {"triangles", triangles},
                      {"bytes", bytes}});
  }
  return levels;
}

OrderedJson files_of(const WrittenFiles& written) {
  OrderedJson files = OrderedJson::array();
  for (const WrittenFile& file : written.files) files.push_back({{"file", file.name}, {"bytes", file.bytes}});
  return files;
}

/// West, south, east, north in degrees; west is more than east across 180°.
OrderedJson box_deg_of(const Box2& box, const map::Plane& plane) {
  return map::rounded_degrees(map::geojson_box_of(box, plane));
}

OrderedJson tiles_of(std::span<const WrittenTile> written, const scene::Header& header, const map::Plane& plane) {
  OrderedJson tiles = OrderedJson::array();
  for (const WrittenTile& tile : written) {
    tiles.push_back(json_of(tile));
    tiles.back()["box_deg"] = box_deg_of(scene::box_of(header, tile.tile), plane);
  }
  return tiles;
}

/// The sky of the run, by which programs that import its tiles light them.
OrderedJson sky_of(const sky::Sky& sky) {
  return {{"time", sky::text_of(sky.time)},
          {"to_sun", {sky.to_sun.x, sky.to_sun.y, sky.to_sun.z}},
          {"turbidity", sky.turbidity},
          {"visibility_km", sky.visibility_km},
          {"ground_m", sky.ground_m}};
}

// Adds the numbers of objects of each assumption.
void add_assumed(const OrderedJson& assumed, Report& report) {
  for (const auto& [name, objects] : assumed.items())
    if (const auto assumption = assumption_named(name); assumption)
      report.add_assumed(*assumption, objects.get<std::uint64_t>());
}

RunRecord record_of(const OrderedJson& report) {
  RunRecord record;
  for (const OrderedJson& tile : report.at("tiles")) record.tiles.push_back(parse_written_tile(tile));
  if (report.contains("usd"))
    for (const OrderedJson& tile : report.at("usd")) record.usd.push_back(parse_written_tile(tile));
  if (const auto target = target_named(report.at("target").get<std::string>()); target) record.target = *target;
  if (const auto split = node_split_named(report.at("split").get<std::string>()); split) record.split = *split;
  // reports of older versions have no such key
  if (const auto layout = layout_named(report.value("layout", "embedded")); layout) record.layout = *layout;
  record.lights = report.value("lights", std::size_t{0});
  if (const auto compress = compression_named(report.value("compress", "none")); compress) record.compress = *compress;
  for (const OrderedJson& file : report.at("files")) record.has_manifest |= file.at("file") == exporters::kManifestName;
  add_ledger(report.at("ledger"), record.ledger);
  // reports of older versions have no such key
  if (report.contains("assumed")) add_assumed(report.at("assumed"), record.ledger);
  for (const auto& [name, account] : record.ledger.ledger())
    if (!account.balances()) record.unbalanced.push_back(name);
  return record;
}

// The number of objects of each assumption.
OrderedJson assumed_of(const Report& report) {
  OrderedJson assumed = OrderedJson::object();
  for (std::size_t i = 0; i < static_cast<std::size_t>(Assumption::kCount); ++i) {
    const auto assumption = static_cast<Assumption>(i);
    assumed[std::string(name_of(assumption))] = report.assumed(assumption);
  }
  return assumed;
}

}  // namespace

std::uint64_t WrittenFiles::bytes() const {
  std::uint64_t sum = 0;
  for (const WrittenFile& file : files) sum += file.bytes;
  for (const auto* levels : {&tiles, &usd})
    for (const WrittenTile& tile : *levels) sum += tile.file.bytes;
  return sum;
}

std::string report_json(const scene::Header& header, const scene::Scene& scene, const Report& report,
                        const WrittenFiles& written, const Outputs& outputs, const OrderedJson& heights) {
  assert(
      std::ranges::all_of(written.tiles, [&](const WrittenTile& t) { return t.level < outputs.tolerances_m.size(); }));
  const map::Plane plane(header.origin);
  OrderedJson json;
  json["program"] = kProgramVersion;
  json["attribution"] = header.attributions;
  json["sources"] = header.sources;
  json["origin"] = {{"lon_deg", header.origin.lon_deg}, {"lat_deg", header.origin.lat_deg}};
  json["region_m"] = {header.extent.min.x, header.extent.min.y, header.extent.max.x, header.extent.max.y};
  json["region_deg"] = box_deg_of(header.extent, plane);
  json["tile_m"] = header.tile_m;
  if (const auto cylinder = scene::cylinder_of(header)) json["cylinder_radius_m"] = cylinder->radius_m;
  json["sky"] = sky_of(header.sky);
  json["seed"] = header.seed;
  json["resampling_error_m"] = header.resampling_error_m;
  json["target"] = values_of(outputs.target).name;
  json["split"] = name_of(outputs.split);
  json["compress"] = name_of(compression_of(outputs, outputs.target));
  json["layout"] = name_of(layout_of(outputs));
  if (outputs.lights > 0) json["lights"] = outputs.lights;
  json["counts"] = counts_of(scene);
  if (outputs.max_bytes) json["solved_for"]["max_bytes"] = *outputs.max_bytes;
  if (outputs.max_triangles) json["solved_for"]["max_triangles"] = *outputs.max_triangles;
  json["levels"] = json.contains("solved_for")
                       ? OrderedJson::array()
                       : levels_of(written.tiles.empty() ? written.usd : written.tiles, outputs);
  json["heights"] = heights;
  json["bytes"] = written.bytes();
  json["balances"] = report.balances();
  json["ledger"] = ledger_json(report);
  json["assumed"] = assumed_of(report);
  json["diagnoses"] = diagnoses_of(report);
  json["files"] = files_of(written);
  json["tiles"] = tiles_of(written.tiles, header, plane);
  if (!written.usd.empty()) json["usd"] = tiles_of(written.usd, header, plane);
  return json.dump(1) + "\n";
}

std::string timing_json(std::span<const StageCost> costs, int threads) {
  assert(threads >= 0);
  OrderedJson stages = OrderedJson::array();
  double seconds = 0;
  std::uint64_t peak_bytes = 0;
  for (const StageCost& cost : costs) {
    stages.push_back({{"stage", cost.stage}, {"seconds", cost.seconds}, {"peak_bytes", cost.peak_bytes}});
    seconds += cost.seconds;
    peak_bytes = std::max(peak_bytes, cost.peak_bytes);
  }
  const OrderedJson json = {{"threads", threads}, {"seconds", seconds}, {"peak_bytes", peak_bytes}, {"stages", stages}};
  return json.dump(1) + "\n";
}

exporters::GlbOptions glb_options_of(const Outputs& outputs) {
  return {.target = outputs.target, .split = outputs.split, .compression = compression_of(outputs, outputs.target)};
}

std::size_t most_instances_of(Target target) {
  const std::size_t most = values_of(target).most_nodes;
  return most == 0 ? bake::kAnyInstances : most;
}

bool has_mended_or_dropped(const Report& report) {
  return std::ranges::any_of(report.diagnoses(),
                             [](const Diagnosis& d) { return severity_of(d.code) != Severity::kNote; });
}

bool is_violated(const Strictness& strict, const Report& report) {
  if (strict.codes.empty()) return strict.is_on && has_mended_or_dropped(report);
  return std::ranges::any_of(report.diagnoses(), [&](const Diagnosis& d) {
    return std::ranges::find(strict.codes, d.code) != strict.codes.end();
  });
}

Result<RunRecord> read_report(const std::string& folder) {
  if (const Result<Done> done = exporters::finish_commit(folder); !done) return done.error();
  const std::string path = folder + "/" + exporters::kReportName;
  std::ifstream file(path, std::ios::binary);
  if (!file && exporters::has_unfinished_run(folder))
    return Error{folder, "holds an unfinished run; repeat the command that writes it"};
  if (!file) return Error{path, "cannot be read; expected the folder of a finished run"};
  try {
    return record_of(OrderedJson::parse(file));
  } catch (const nlohmann::json::exception&) {
    return Error{path, "is not a report written by citykiln"};
  }
}

}  // namespace citykiln::outputs
