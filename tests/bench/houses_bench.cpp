// Whole houses, from their recipes to their meshes: masses, roofs, rules and triangles, at the tolerances of the
// levels. L0 is to give 3 million triangles a second and core.
#include <benchmark/benchmark.h>

#include <cmath>

#include "compiler/buildings/generate.h"
#include "compiler/buildings/style.h"

namespace citykiln::buildings {
namespace {

constexpr int kHouses = 24;  // no two of a size, so that nothing is derived for all

// the i-th along a street that runs at an angle to the axes, `wide` metres on average
Building house(Style style, roofs::Form form, double wide_m, int levels, int i) {
  Building b;
  b.id = {{OsmType::kWay, 1000 + i}, 0};
  const double width_m = wide_m * (0.8 + 0.4 * ((i * 7) % kHouses) / kHouses), depth_m = 11 + i % 5 * 0.5;
  const Vec2 along{0.8, 0.6}, back{-0.6, 0.8}, corner = along * (i * (wide_m * 1.3));
  b.footprint.outer = {corner, corner + along * width_m, corner + along * width_m + back * depth_m,
                       corner + back * depth_m};
  b.style = style;
  b.levels = static_cast<std::uint8_t>(levels);
  b.roof_shape.form = form;
  b.roof_shape.height_m = form == roofs::Form::kFlat ? 0 : 4;
  b.top_m = 3.0 * levels + b.roof_shape.height_m;
  b.wall = materials::Material::kPlaster, b.roof = materials::Material::kRoofTile;
  b.facade_edges.resize(4);
  b.facade_edges.front().faces_street = true;
  return b;
}

void expand_street(benchmark::State& state, Style style, roofs::Form form, double wide_m, int levels) {
  std::vector<Building> street;
  for (int i = 0; i < kHouses; ++i) street.push_back(house(style, form, wide_m, levels, i));
  const Rulebook rulebook = parse_rulebook(shipped_rules());
  const double tolerance_m = static_cast<double>(state.range(0)) / 1000;
  std::uint64_t houses = 0, triangles = 0;
  Report report;
  for (auto _ : state) {
    for (const Building& building : street) {
      const GeneratedBuilding house = generate(building, rulebook, {1}, tolerance_m, report);
      for (const auto& dressed : house.meshes) triangles += dressed.mesh.triangles.size();
      for (const auto& textured_faces : house.textured_faces) triangles += textured_faces.mesh.mesh.triangles.size();
      ++houses;
    }
  }
  state.counters["triangles"] = static_cast<double>(triangles) / static_cast<double>(houses);
  state.counters["triangles/s"] = benchmark::Counter(static_cast<double>(triangles), benchmark::Counter::kIsRate);
  state.counters["houses/s"] = benchmark::Counter(static_cast<double>(houses), benchmark::Counter::kIsRate);
}

void expand_villas(benchmark::State& state) { expand_street(state, Style::kVilla, roofs::Form::kGabled, 12, 2); }
void expand_flats(benchmark::State& state) { expand_street(state, Style::kPanelBlock, roofs::Form::kFlat, 40, 5); }
void expand_town_houses(benchmark::State& state) {
  expand_street(state, Style::kOldTownHouse, roofs::Form::kHipped, 15, 4);
}

// tolerances in millimetres
BENCHMARK(expand_villas)->ArgName("mm")->Arg(20)->Arg(100)->Arg(500)->Arg(2500)->Unit(benchmark::kMillisecond);
BENCHMARK(expand_flats)->ArgName("mm")->Arg(20)->Arg(100)->Arg(500)->Arg(2500)->Unit(benchmark::kMillisecond);
BENCHMARK(expand_town_houses)->ArgName("mm")->Arg(20)->Arg(100)->Arg(500)->Arg(2500)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace citykiln::buildings
