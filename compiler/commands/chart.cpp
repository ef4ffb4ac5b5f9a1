// citykiln chart NAME… -o FOLDER: measures speed and accuracy on this machine and draws charts of them.
#include "compiler/charts/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "compiler/commands/run_paths.h"
#include "compiler/commands/verb.h"
#include "compiler/commands/view/view_options.h"
#include "compiler/parse_values.h"
#include "compiler/source/read_raster.h"

namespace citykiln::commands {
namespace {

/// One row for each chart.
struct Kind {
  const char* name;
  Result<std::vector<charts::Chart>> (*make)(const charts::ChartRequest& request);
};
constexpr std::array kKinds = {Kind{"plane", charts::chart_plane},
                               Kind{"terrain", charts::chart_terrain},
                               Kind{"junctions", charts::chart_junctions},
                               Kind{"roads", charts::chart_roads},
                               Kind{"ground", charts::chart_ground},
                               Kind{"view", charts::chart_view},
                               Kind{"profile", charts::chart_profile},
                               Kind{"roof", charts::chart_roof},
                               Kind{"facade", charts::chart_facade},
                               Kind{"woods", charts::chart_woods},
                               Kind{"plant", charts::chart_plant},
                               Kind{"lsystem", charts::chart_lsystem},
                               Kind{"compression", charts::chart_compression},
                               Kind{"lod", charts::chart_lod},
                               Kind{"render", charts::chart_render},
                               Kind{"lights", charts::chart_lights},
                               Kind{"forms", charts::chart_forms},
                               Kind{"sky", charts::chart_sky},
                               Kind{"linelights", charts::chart_linelights},
                               Kind{"cloud", charts::chart_cloud},
                               Kind{"assumed", charts::chart_assumed},
                               Kind{"invented", charts::chart_invented}};

std::string known_names() {
  std::string names;
  for (const Kind& kind : kKinds) names += (names.empty() ? "" : ", ") + std::string(kind.name);
  return names;
}

Result<std::vector<charts::Chart>> make(const std::string& name, const charts::ChartRequest& request) {
  const auto kind = std::ranges::find(kKinds, name, &Kind::name);
  if (kind != kKinds.end()) return kind->make(request);
  return Error{"chart", fmt::format("expected one of {}, found \"{}\"", known_names(), name)};
}

Result<Exit> run_chart(const charts::ChartRequest& request, const Console& console) {
  if (request.names.empty()) return Error{"", "no chart is named; expected one of " + known_names()};
  if (request.folder.empty()) return Error{"", "no output folder is given; add -o FOLDER"};
  if (const Result<Done> made = make_output_folder(request.folder); !made) return made.error();
  for (const std::string& name : request.names) {
    const Result<std::vector<charts::Chart>> charts = make(name, request);
    if (!charts) return charts.error();
    for (const charts::Chart& chart : *charts) {
      if (const Result<Done> written = charts::write_chart(chart, request.folder); !written) return written.error();
      console.print_line(fmt::format("{0}/{1}.csv, {0}/{1}.svg: {2}", request.folder, chart.name, chart.title));
      for (const std::string& note : chart.notes) console.print_line(note);
    }
  }
  return Exit::kDone;
}

Result<Done> parse_raster(const std::string& text, charts::ChartRequest& request) {
  const Result<source::RasterSpec> raster = source::parse_raster_spec(text);
  if (!raster) return raster.error();
  request.rasters.push_back(*raster);
  return Done{};
}

Result<Done> parse_bbox(const std::string& text, charts::ChartRequest& request) {
  const Result<std::vector<double>> n = parse_numbers(text, 4);
  if (!n) return n.error();
  request.bbox = {(*n)[0], (*n)[1], (*n)[2], (*n)[3]};
  request.has_bbox = true;
  return Done{};
}

}  // namespace

Verb chart_verb() {
  const auto request = std::make_shared<charts::ChartRequest>();
  Verb verb{"chart", "measures speed and accuracy on this machine and draws charts (CSV and SVG)", {}, {}};
  verb.options = {
      {"names", "NAME...", known_names(), true, append_text(request->names)},
      {"--map", "FILE...",
       "maps for all charts except plane, terrain, plant, lsystem, lights, sky, linelights and cloud", true,
       append_text(request->maps)},
      {"--dem", "FILE[,key=value...]", "heightmap for terrain, ground, view, profile, facade and lod", true,
       [request = request.get()](const std::string& t) { return parse_raster(t, *request); }},
      {"--bbox", "W,S,E,N", "terrain: part of the heightmap in degrees (default: all of it)", false,
       [request = request.get()](const std::string& t) { return parse_bbox(t, *request); }},
      {"--cell", "M", "terrain: side of the meshed cells in metres (default: 1024)", false,
       store_number(request->cell_m, {128, 65536, true})},
      {"--lat", "DEG", "plane: latitude of the origin in degrees (default: 42.5)", false,
       store_number(request->lat_deg, {-80, 80, true})},
      {"--eye", "X,Y,Z", "view: place of the viewer in plane metres (default: 100 m above the middle of the map)",
       false, store_point(request->eye)},
      threads_option(request->threads),
      {"-o,--out", "FOLDER", "folder for the charts", false, store_text(request->folder)},
  };
  verb.examples = {"citykiln chart plant -o out/charts",
                   "citykiln chart terrain --dem N43E007.hgt --bbox 7.0,43.5,7.5,44.0 -o out/charts"};
  verb.run = [request](const Console& console) { return run_chart(*request, console); };
  return verb;
}

}  // namespace citykiln::commands
