// The program citykiln-chart: measures speed and accuracy on this machine and draws charts of them.
//
//     citykiln-chart NAME… -o FOLDER
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>

#include "compiler/parse_values.h"
#include "compiler/source/read_raster.h"
#include "tests/charts/chart.h"

namespace citykiln::charts {
namespace {

/// One row for each chart.
struct Kind {
  const char* name;
  Result<std::vector<Chart>> (*make)(const ChartRequest& request);
};
constexpr std::array kKinds = {Kind{"plane", chart_plane},
                               Kind{"terrain", chart_terrain},
                               Kind{"smooth", chart_smooth},
                               Kind{"junctions", chart_junctions},
                               Kind{"roads", chart_roads},
                               Kind{"ground", chart_ground},
                               Kind{"view", chart_view},
                               Kind{"profile", chart_profile},
                               Kind{"roof", chart_roof},
                               Kind{"facade", chart_facade},
                               Kind{"woods", chart_woods},
                               Kind{"canopy", chart_canopy},
                               Kind{"plant", chart_plant},
                               Kind{"lsystem", chart_lsystem},
                               Kind{"compression", chart_compression},
                               Kind{"lod", chart_lod},
                               Kind{"render", chart_render},
                               Kind{"lights", chart_lights},
                               Kind{"forms", chart_forms},
                               Kind{"sky", chart_sky},
                               Kind{"linelights", chart_linelights},
                               Kind{"sampling", chart_sampling},
                               Kind{"hierarchy", chart_hierarchy},
                               Kind{"scatter", chart_scatter},
                               Kind{"stability", chart_stability},
                               Kind{"air", chart_air},
                               Kind{"cloud", chart_cloud},
                               Kind{"assumed", chart_assumed},
                               Kind{"invented", chart_invented},
                               Kind{"curves", chart_curves}};

std::string known_names() {
  std::string names;
  for (const Kind& kind : kKinds) names += (names.empty() ? "" : ", ") + std::string(kind.name);
  return names;
}

/// The options whose text has a form of its own.
struct Texts {
  std::vector<std::string> rasters;
  std::string bbox, eye;
};

void declare(CLI::App& app, ChartRequest& request, Texts& texts) {
  app.add_option("names", request.names, known_names())->type_name("NAME...")->required();
  app.add_option("--map", request.maps,
                 "maps for all charts except plane, terrain, smooth, canopy, plant, lsystem, lights, sky, linelights, "
                 "cloud, air, sampling, hierarchy, scatter and stability")
      ->type_name("FILE...");
  app.add_option("--dem", texts.rasters,
                 "heightmap for terrain, smooth, ground, view, profile, facade, lod and assumed")
      ->type_name("FILE[,key=value...]");
  app.add_option("--bbox", texts.bbox, "terrain: part of the heightmap in degrees (default: all of it)")
      ->type_name("W,S,E,N");
  app.add_option("--cell", request.cell_m, "terrain: side of the meshed cells in metres (default: 1024)")
      ->type_name("M")
      ->check(CLI::Range(128, 65536));
  app.add_option("--lat", request.lat_deg, "plane: latitude of the origin in degrees (default: 42.5)")
      ->type_name("DEG")
      ->check(CLI::Range(-80, 80));
  app.add_option("--eye", texts.eye,
                 "view: place of the viewer in plane metres (default: 100 m above the middle of the map)")
      ->type_name("X,Y,Z");
  app.add_option("--threads", request.threads, "number of threads; 0 uses all processors (default: 0)")
      ->type_name("N")
      ->check(CLI::NonNegativeNumber);
  app.add_option("-o,--out", request.folder, "folder for the charts")->type_name("FOLDER")->required();
  app.footer(
      "Examples:\n  citykiln-chart plant -o out/charts\n"
      "  citykiln-chart terrain --dem N43E007.hgt --bbox 7.0,43.5,7.5,44.0 -o out/charts");
}

Result<Done> parse_texts(const Texts& texts, ChartRequest& request) {
  for (const std::string& text : texts.rasters) {
    const Result<source::RasterSpec> raster = source::parse_raster_spec(text);
    if (!raster) return Error{"--dem", raster.error().message};
    request.rasters.push_back(*raster);
  }
  if (!texts.bbox.empty()) {
    const Result<std::vector<double>> n = parse_numbers(texts.bbox, 4);
    if (!n) return Error{"--bbox", n.error().message};
    request.bbox = {(*n)[0], (*n)[1], (*n)[2], (*n)[3]};
    request.has_bbox = true;
  }
  if (!texts.eye.empty()) {
    const Result<std::vector<double>> n = parse_numbers(texts.eye, 3);
    if (!n) return Error{"--eye", n.error().message};
    request.eye = Vec3{(*n)[0], (*n)[1], (*n)[2]};
  }
  return Done{};
}

Result<Done> make_and_write(const Kind& kind, const ChartRequest& request) {
  const Result<std::vector<Chart>> charts = kind.make(request);
  if (!charts) return charts.error();
  for (const Chart& chart : *charts) {
    if (const Result<Done> written = write_chart(chart, request.folder); !written) return written.error();
    fmt::print("{0}/{1}.csv, {0}/{1}.svg: {2}\n", request.folder, chart.name, chart.title);
    for (const std::string& note : chart.notes) fmt::print("{}\n", note);
  }
  return Done{};
}

Result<Done> run_charts(const ChartRequest& request) {
  std::vector<Kind> kinds;
  for (const std::string& name : request.names) {
    const auto kind = std::ranges::find(kKinds, name, &Kind::name);
    if (kind == kKinds.end()) return Error{name, "is no chart; expected one of " + known_names()};
    kinds.push_back(*kind);
  }
  std::error_code problem;
  std::filesystem::create_directories(request.folder, problem);
  if (!std::filesystem::is_directory(request.folder)) return Error{request.folder, "cannot be created as a folder"};
  for (const Kind& kind : kinds)
    if (const Result<Done> made = make_and_write(kind, request); !made) return made.error();
  return Done{};
}

}  // namespace
}  // namespace citykiln::charts

int main(int argc, char** argv) {
  using namespace citykiln::charts;
  CLI::App app("citykiln-chart measures speed and accuracy on this machine and draws charts (CSV and SVG)",
               "citykiln-chart");
  ChartRequest request;
  Texts texts;
  declare(app, request, texts);
  CLI11_PARSE(app, argc, argv);
  citykiln::Result<citykiln::Done> done = parse_texts(texts, request);
  if (done) done = run_charts(request);
  if (!done) fmt::print(stderr, "{}\n", to_string(done.error()));
  return done ? 0 : 1;
}
