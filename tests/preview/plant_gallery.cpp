// Renders species side by side at several tolerances, one row per species, and prints the size of each:
//   plant_gallery OUT.png PIXELS TOLERANCE,… SPECIES,… [DISTANCE in heights, 0: 2 m before the trunk [TIME]]
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "compiler/bake/merge.h"
#include "compiler/bake/prototype_cache.h"
#include "compiler/sky/plan.h"
#include "exporters/gltf/glb.h"
#include "preview/render.h"

namespace citykiln {
namespace {

std::vector<std::string> parts_of(const std::string& text) {
  std::vector<std::string> parts;
  std::stringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
  return parts;
}

plants::Species species_called(const std::string& name) {
  for (int s = 0; s < static_cast<int>(plants::Species::kCount); ++s)
    if (plants::values_of(static_cast<plants::Species>(s)).file == name) return static_cast<plants::Species>(s);
  std::fprintf(stderr, "no species is called %s\n", name.c_str());
  std::exit(2);
}

bake::Primitive lawn(float half_m) {
  bake::Primitive lawn{materials::Material::kGrass, {}, {}, {}, {}, {}};
  for (const bake::Float3& p :
       {bake::Float3{-half_m, -half_m, 0}, {half_m, -half_m, 0}, {half_m, half_m, 0}, {-half_m, half_m, 0}}) {
    lawn.positions.push_back(p), lawn.normals.push_back({0, 0, 1});
    lawn.colours.push_back(materials::kNoTint), lawn.features.push_back(0);
  }
  lawn.triangles = {{0, 1, 2}, {0, 2, 3}};
  return lawn;
}

bake::BakedTile planted(const bake::BakedPrototype& shape, const std::string& name, double height_m,
                        double tolerance_m) {
  bake::BakedTile tile;
  tile.features = {OsmId{}};
  tile.primitives = {lawn(static_cast<float>(6 * height_m))};
  if (!shape.primitives.empty())
    tile.instanced = {{name,
                       shape.primitives,
                       {{0, 0, 0}},
                       {{0, 0, 0, 1}},
                       {static_cast<float>(height_m / bake::prototype_height_m(height_m))},
                       {0},
                       shape.cutout}};
  tile.textures = bake::textures_shown(tile, tolerance_m, materials::TextureCache(1));
  return tile;
}

void put(const preview::Image& from, int x0, int y0, preview::Image& to) {
  for (int y = 0; y < from.height; ++y)
    for (int i = 0; i < 3 * from.width; ++i)
      to.rgb[(static_cast<std::size_t>(y0 + y) * to.width + x0) * 3 + i] =
          from.rgb[static_cast<std::size_t>(y) * from.width * 3 + i];
}

preview::Camera before(double height_m, double away) {
  const Vec3 middle{0, 0, 0.5 * height_m};
  return {middle + Vec3{0.25, -1, 0.12} * (away * height_m), middle, 2 * std::atan(0.62 / away) * 57.29578};
}

preview::Camera before_trunk() { return {{0.5, -2.4, 1.6}, {0, 0, 1.6}, 60}; }

int run(char** argv, double away, const std::string& time) {
  const int pixels = std::atoi(argv[2]);
  const auto tolerances = parts_of(argv[3]), names = parts_of(argv[4]);
  scene::Header header;
  header.origin = {11, 48};
  if (!time.empty()) header.sky.time = *sky::parse_time(time);
  const bake::PrototypeCache prototypes(header);
  const auto sky = sky::plan(header.origin, *sky::parse_time("2026-06-21T09:30"));
  preview::Image sheet{pixels * static_cast<int>(tolerances.size()), pixels * static_cast<int>(names.size()), {}};
  sheet.rgb.resize(static_cast<std::size_t>(sheet.width) * sheet.height * 3);
  for (std::size_t row = 0; row < names.size(); ++row)
    for (std::size_t column = 0; column < tolerances.size(); ++column) {
      const plants::Species species = species_called(names[row]);
      const double height_m = plants::values_of(species).height_m, tolerance_m = std::atof(tolerances[column].c_str());
      const auto start = std::chrono::steady_clock::now();
      const bake::BakedPrototype& shape =
          prototypes.prototype({species, 0}, bake::prototype_height_m(height_m), tolerance_m);
      const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
      const bake::BakedTile tile = planted(shape, names[row], height_m, tolerance_m);
      std::size_t triangles = 0;
      for (const bake::Primitive& p : shape.primitives) triangles += p.triangles.size();
      std::printf("%-8s %6s m: %7zu triangles %8zu bytes %6.3f s error %.3f m\n", names[row].c_str(),
                  tolerances[column].c_str(), triangles, exporters::encode_glb(tile, header, {}).size(), took.count(),
                  shape.error_per_m * height_m);
      preview::Options options;
      options.width = options.height = pixels, options.samples = 24;
      const preview::Camera camera = away > 0 ? before(height_m, away) : before_trunk();
      put(preview::render(std::span(&tile, 1), sky, camera, options), pixels * static_cast<int>(column),
          pixels * static_cast<int>(row), sheet);
    }
  return preview::write_image(sheet, argv[1]) ? 0 : 1;
}

}  // namespace
}  // namespace citykiln

int main(int argc, char** argv) {
  if (argc < 5) return 2;
  return citykiln::run(argv, argc > 5 ? std::atof(argv[5]) : 3, argc > 6 ? argv[6] : "");
}
