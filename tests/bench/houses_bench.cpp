// Generates whole houses from recipes to meshes (masses, roofs, rules, triangles) at the tolerances of the levels.
// Goal: 3 million triangles per second and core at level 0.
#include <benchmark/benchmark.h>

#include <cmath>

#include "compiler/buildings/generate.h"
#include "compiler/buildings/styles/style.h"

namespace citykiln::buildings {
namespace {

constexpr int kHouses = 24;  // all of different sizes, so that no derivation is shared

// The i-th house along a street at an angle to the axes; mean width `wide` metres.
Building house(Style style, roofs::RoofForm form, double wide_m, int levels, int i) {
  Building b;
  b.id = {{OsmType::kWay, 1000 + i}, 0};
  const double width_m = wide_m * (0.8 + 0.4 * ((i * 7) % kHouses) / kHouses), depth_m = 11 + i % 5 * 0.5;
  const Vec2 along{0.8, 0.6}, back{-0.6, 0.8}, corner = along * (i * (wide_m * 1.3));
  b.footprint.outer = {corner, corner + along * width_m, corner + along * width_m + back * depth_m,
                       corner + back * depth_m};
  b.style = style;
  b.levels = static_cast<std::uint8_t>(levels);
  b.roof_shape.form = form;
  b.roof_shape.height_m = form == roofs::RoofForm::kFlat ? 0 : 4;
  b.top_m = 3.0 * levels + b.roof_shape.height_m;
  b.wall = materials::Material::kPlaster, b.roof = materials::Material::kRoofTile;
  b.facade_edges.resize(4);
  b.facade_edges.front().faces_street = true;
  return b;
}

void generate_street(benchmark::State& state, Style style, roofs::RoofForm form, double wide_m, int levels) {
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

void generate_villas(benchmark::State& state) {
  generate_street(state, Style::kVilla, roofs::RoofForm::kGabled, 12, 2);
}
void generate_flats(benchmark::State& state) {
  generate_street(state, Style::kPanelBlock, roofs::RoofForm::kFlat, 40, 5);
}
void generate_town_houses(benchmark::State& state) {
  generate_street(state, Style::kOldTownHouse, roofs::RoofForm::kHipped, 15, 4);
}

// tolerance in millimetres
BENCHMARK(generate_villas)->ArgName("mm")->Arg(20)->Arg(100)->Arg(500)->Arg(2500)->Unit(benchmark::kMillisecond);
BENCHMARK(generate_flats)->ArgName("mm")->Arg(20)->Arg(100)->Arg(500)->Arg(2500)->Unit(benchmark::kMillisecond);
BENCHMARK(generate_town_houses)->ArgName("mm")->Arg(20)->Arg(100)->Arg(500)->Arg(2500)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace citykiln::buildings
