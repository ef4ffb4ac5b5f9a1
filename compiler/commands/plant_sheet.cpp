#include "compiler/commands/plant_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>
#include <utility>

#include "compiler/bake/merge.h"
#include "compiler/bake/prototype_cache.h"
#include "compiler/commands/sheet.h"
#include "compiler/contract/texts/parse.h"
#include "compiler/make_header.h"
#include "compiler/source/read_texts.h"
#include "exporters/file.h"
#include "lsystems/plant_file.h"
#include "preview/picture/denoise.h"
#include "preview/render.h"

namespace citykiln::commands {
namespace {

namespace fs = std::filesystem;

constexpr std::array kPlantTolerances_m = {0.1, 0.5, 1.2, 2.5, 12.5};
// Plants below this height are drawn at a tenth of these tolerances.
constexpr double kLow_m = 8, kLowShare = 0.1;
constexpr int kPlantPixels = 240, kPlantSamples = 6;
constexpr double kEye_m = 1.7;

// The species to draw, and their texts.
struct DrawnSpecies {
  std::vector<plants::SpeciesText> texts;
  std::vector<std::string> names;
};

std::string text_of_file(const std::vector<std::byte>& bytes) {
  return std::string(source::without_byte_order_mark({reinterpret_cast<const char*>(bytes.data()), bytes.size()}));
}

// The row of a species in the table beside its file, "" if there is none.
Result<std::string> row_beside(const fs::path& file) {
  const std::string path = (file.parent_path() / plants::kUserSpeciesName).string();
  if (!fs::exists(path)) return std::string();
  const Result<std::vector<std::byte>> bytes = exporters::read_file(path);
  if (!bytes) return bytes.error();
  const std::string text = text_of_file(*bytes), stem = file.stem().string();
  // lines of other species are left empty, so that errors have the right line
  std::string rows;
  for (const std::string_view line : split(text, '\n')) {
    const std::vector<std::string_view> words = words_in(line);
    if (!words.empty() && words[0] == stem) rows += line;
    rows += '\n';
  }
  return rows;
}

Result<DrawnSpecies> species_of_file(const fs::path& file) {
  const Result<std::vector<std::byte>> bytes = exporters::read_file(file.string());
  if (!bytes) return bytes.error();
  Result<std::string> rows = row_beside(file);
  if (!rows) return rows.error();
  const std::string folder = file.has_parent_path() ? file.parent_path().string() : ".";
  const std::array files = {plants::SpeciesText{file.filename().string(), text_of_file(*bytes)},
                            plants::SpeciesText{std::string(plants::kUserSpeciesName), std::move(*rows)}};
  Result<plants::UserSpecies> own = plants::read_species_folder(files, folder);
  if (!own) return own.error();
  return DrawnSpecies{std::move(own->texts), {file.stem().string()}};
}

Result<DrawnSpecies> species_in_folder(const std::string& folder) {
  Result<plants::UserSpecies> own = read_species(folder);
  if (!own) return own.error();
  DrawnSpecies drawn{std::move(own->texts), {}};
  for (const plants::SpeciesText& text : drawn.texts)
    if (!text.name.ends_with(".txt")) drawn.names.emplace_back(species_of(text));
  return drawn;
}

bool is_plant_path(const fs::path& path) {
  return std::ranges::find(lsystems::kPlantEndings, path.extension().string()) != lsystems::kPlantEndings.end();
}

Result<DrawnSpecies> species_asked(const std::string& species) {
  if (plants::shipped_table().named(species)) return DrawnSpecies{{}, {species}};
  std::error_code none;
  if (fs::is_directory(species, none)) return species_in_folder(species);
  if (is_plant_path(species)) return species_of_file(species);
  return Error{species, fmt::format("expected a shipped species such as oak, a folder of species, or a file {}",
                                    fmt::join(lsystems::kPlantEndings, ", "))};
}

bake::BakedTile tile_of_plant(const bake::BakedPrototype& shape, const std::string& name, double height_m,
                              double tolerance_m) {
  bake::BakedTile tile;
  tile.features = {OsmId{}};
  tile.primitives = {ground_square(materials::Material::kGrass, static_cast<float>(20 * height_m))};
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

// From the south, so far away that the whole plant is seen.
preview::Camera plant_camera(double height_m, double crown_share) {
  const double size_m = height_m * std::max(1.0, crown_share), away_m = 1.8 * size_m;
  return {{0.3 * away_m, -away_m, std::min(kEye_m, 0.7 * height_m)}, {0, 0, 0.5 * height_m}, 36};
}

std::size_t triangles_in(const bake::BakedPrototype& shape) {
  std::size_t triangles = 0;
  for (const bake::Primitive& primitive : shape.primitives) triangles += primitive.triangles.size();
  return triangles;
}

// Draws a plant at all tolerances in a row of the sheet.
void draw_plant(plants::Species species, int row, const bake::PrototypeCache& prototypes, const sky::Sky& sky,
                const Console& console, preview::Image& sheet) {
  const plants::SpeciesValues& values = prototypes.species()[species];
  preview::Options options;
  options.width = options.height = kPlantPixels, options.samples = kPlantSamples, options.has_guides = true;
  const std::string name(values.file);
  for (std::size_t k = 0; k < kPlantTolerances_m.size(); ++k) {
    const double tolerance_m = kPlantTolerances_m[k] * (values.height_m < kLow_m ? kLowShare : 1);
    const bake::BakedPrototype& shape =
        prototypes.prototype({species, 0}, bake::prototype_height_m(values.height_m), tolerance_m);
    console.print_line(fmt::format("{:<16} {:5.2f} m high at {:5.3g} m: {:>7} triangles, error {:.3f} m", name,
                                   values.height_m, tolerance_m, triangles_in(shape),
                                   shape.error_per_m * values.height_m));
    const bake::BakedTile tile = tile_of_plant(shape, name, values.height_m, tolerance_m);
    const preview::Image noisy =
        preview::render(std::span(&tile, 1), sky, plant_camera(values.height_m, values.crown_share), options);
    put_picture(preview::denoise(noisy, options.threads), kPlantPixels * static_cast<int>(k), kPlantPixels * row,
                sheet);
  }
}

}  // namespace

Result<Done> draw_plant_sheet(const PlantSheet& asked, const Console& console) {
  Result<DrawnSpecies> drawn = species_asked(asked.species);
  if (!drawn) return drawn.error();
  scene::Header header;
  header.origin = {11, 48}, header.species = std::move(drawn->texts);
  const bake::PrototypeCache prototypes(header);
  const sky::Sky sky = sheet_sky();
  preview::Image sheet = empty_sheet(kPlantPixels * static_cast<int>(kPlantTolerances_m.size()),
                                     kPlantPixels * static_cast<int>(drawn->names.size()));
  for (std::size_t row = 0; row < drawn->names.size(); ++row)
    draw_plant(*prototypes.species().named(drawn->names[row]), static_cast<int>(row), prototypes, sky, console, sheet);
  return preview::write_image(sheet, asked.path);
}

}  // namespace citykiln::commands
