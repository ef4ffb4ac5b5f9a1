#include "compiler/plants/species_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "compiler/plants/placing/placing.h"
#include "compiler/plants/prototypes/grown_plant_cache.h"
#include "lsystems/plant_file.h"

namespace citykiln::plants {
namespace {

// The height of plants whose file has no scale, and the tallest height as a share of the usual one.
constexpr double kUnknownHeight_m = 10, kTallestShare = 1.4, kLeastScale_m = 0.05;

bool is_plant_file(const SpeciesText& file) { return !file.name.ends_with(".txt"); }

const SpeciesText* file_named(std::span<const SpeciesText> files, std::string_view name) {
  const auto found = std::ranges::find(files, name, &SpeciesText::name);
  return found == files.end() ? nullptr : &*found;
}

bool is_shipped(std::string_view name) {
  return std::ranges::find(kSpecies, name, &SpeciesValues::file) != std::end(kSpecies);
}

// A plant as it is measured.
struct PlantSize {
  double height_m = 0, crown_share = 0;
};

// The mean of its extents in x and y, over its height.
double crown_share_of(const GrownPlant& grown) {
  double low_x = 0, high_x = 0, low_y = 0, high_y = 0;
  const auto add = [&](Vec3 p) {
    low_x = std::min(low_x, p.x), high_x = std::max(high_x, p.x);
    low_y = std::min(low_y, p.y), high_y = std::max(high_y, p.y);
  };
  for (const lsystems::Segment& segment : grown.skeleton.segments) add(segment.end().at);
  for (const Card& card : grown.foliage.cards) add(card.centre());
  return (high_x - low_x + high_y - low_y) / 2 / grown.height_m;
}

Result<PlantSize> size_of(const SpeciesText& file, const std::string& where) {
  const Result<lsystems::PlantFile> plant = lsystems::read_plant_file(file.text, where);
  if (!plant) return plant.error();
  const lsystems::GrownSkeleton skeleton = lsystems::grow_plant(*plant, 0);
  if (skeleton.stopped) return *skeleton.stopped;
  if (skeleton.undefined) return *skeleton.undefined;
  const GrownPlant grown = grow(*plant, values_of(Species::kLime), 0, kMidsummer);
  const std::size_t parts = grown.skeleton.segments.size() + grown.foliage.cards.size();
  if (parts > lsystems::kMostPlantParts)
    return Error{where,
                 fmt::format("expected at most {} stems and leaves, found {}", lsystems::kMostPlantParts, parts)};
  if (!(grown.height_m > 0)) return Error{where, "expected a plant above the ground, found none"};
  const PlantSize size{grown.height_m, crown_share_of(grown)};
  if (size.crown_share > kWidestCrown)
    return Error{where, fmt::format("expected a plant at most {} times as wide as high, found {:.2f}", kWidestCrown,
                                    size.crown_share)};
  return size;
}

// To the millimetre: these numbers are written as text.
double rounded(double v) { return std::floor(v * 1000 + 0.5) / 1000; }

// Puts the values that the plant has in place of those that the row lacks.
void complete(SpeciesRow& row, const PlantSize& size) {
  const bool has_scale = size.height_m >= kLeastScale_m && size.height_m <= kTallestPlant_m;
  if (!row.height_m) row.height_m = rounded(has_scale ? size.height_m : kUnknownHeight_m);
  if (!row.tallest_m) row.tallest_m = rounded(std::min(kTallestShare * *row.height_m, kTallestPlant_m));
  row.tallest_m = std::max(*row.tallest_m, *row.height_m);
  if (!row.crown_share) row.crown_share = std::max(rounded(size.crown_share), 0.02);
}

// The size of each species that has a file.
Result<std::map<std::string, PlantSize>> sizes_of(std::span<const SpeciesText> files, const std::string& folder) {
  std::map<std::string, PlantSize> sizes;
  for (const SpeciesText& file : files) {
    if (!is_plant_file(file)) continue;
    const std::string where = folder + "/" + file.name, name(species_of(file));
    if (!is_species_name(name))
      return Error{where, "expected a file name of small letters, digits and _, a letter first"};
    Result<PlantSize> size = size_of(file, where);
    if (!size) return size.error();
    if (!sizes.emplace(name, *size).second) return Error{where, fmt::format("is the second file of \"{}\"", name)};
  }
  return sizes;
}

// The rows of species.txt, and one for each file without a row; all with all values.
Result<std::vector<SpeciesRow>> rows_of(std::span<const SpeciesText> files, const std::string& folder) {
  const SpeciesText* table = file_named(files, kUserSpeciesName);
  Result<std::vector<SpeciesRow>> rows =
      read_species_rows(table == nullptr ? "" : table->text, fmt::format("{}/{}", folder, kUserSpeciesName));
  if (!rows) return rows.error();
  const Result<std::map<std::string, PlantSize>> sizes = sizes_of(files, folder);
  if (!sizes) return sizes.error();
  for (const auto& [name, size] : *sizes)
    if (std::ranges::find(*rows, name, &SpeciesRow::name) == rows->end()) rows->push_back({.name = name});
  for (SpeciesRow& row : *rows) {
    if (const auto size = sizes->find(row.name); size != sizes->end())
      complete(row, size->second);
    else if (!is_shipped(row.name))
      return Error{row.place, fmt::format("expected a file of the species \"{}\" in the folder, found none", row.name)};
  }
  std::ranges::sort(*rows, {}, &SpeciesRow::name);
  const auto own = std::ranges::count_if(*rows, [](const SpeciesRow& row) { return !is_shipped(row.name); });
  if (own > static_cast<std::ptrdiff_t>(kMostUserSpecies))
    return Error{folder, fmt::format("expected at most {} species, found {}", kMostUserSpecies, own)};
  return rows;
}

// The words of tags: those of the row; a species that is not shipped has its name without any.
std::vector<map::PlantWords> words_of(std::span<const SpeciesRow> rows, const SpeciesTable& table) {
  std::vector<map::PlantWords> words;
  for (const SpeciesRow& row : rows) {
    const auto kind = static_cast<map::PlantKind>(static_cast<std::uint8_t>(*table.named(row.name)) + 1);
    std::vector<std::string> names = row.names;
    if (names.empty() && !is_shipped(row.name)) names = {map::lower_words(row.name)};
    if (!names.empty()) words.push_back({kind, std::move(names)});
  }
  return words;
}

std::string table_text(std::span<const SpeciesRow> rows) {
  std::string text;
  for (const SpeciesRow& row : rows) text += to_text(row) + "\n";
  return text;
}

Result<std::vector<map::SpawnerRow>> spawners_of(const SpeciesText* text, const std::string& folder,
                                                 const SpeciesTable& table) {
  if (text == nullptr) return std::vector<map::SpawnerRow>{};
  Result<std::vector<map::SpawnerRow>> rows =
      map::read_spawners(text->text, fmt::format("{}/{}", folder, kSpawnersName));
  if (!rows) return rows.error();
  for (const map::SpawnerRow& row : *rows)
    for (const map::SpawnedSpecies& each : row.species)
      if (!table.named(each.name)) return Error{row.place, fmt::format("there is no species \"{}\"", each.name)};
  return rows;
}

}  // namespace

Result<UserSpecies> read_species_folder(std::span<const SpeciesText> files, const std::string& folder) {
  Result<std::vector<SpeciesRow>> rows = rows_of(files, folder);
  if (!rows) return rows.error();
  const SpeciesText* spawners_text = file_named(files, kSpawnersName);
  UserSpecies own;
  own.table = SpeciesTable(*rows, spawners_text == nullptr ? std::string_view() : spawners_text->text);
  Result<std::vector<map::SpawnerRow>> spawners = spawners_of(spawners_text, folder, own.table);
  if (!spawners) return spawners.error();
  own.for_map = {words_of(*rows, own.table), std::move(*spawners)};
  for (const SpeciesText& file : files) {
    if (file.name == kUserSpeciesName) continue;
    // our notation has no extension in a manifest
    const bool is_ours = file.name.ends_with(".lsys");
    own.texts.push_back({is_ours ? std::string(species_of(file)) : file.name, file.text});
  }
  if (!rows->empty()) own.texts.push_back({std::string(kUserSpeciesName), table_text(*rows)});
  std::ranges::sort(own.texts, {}, &SpeciesText::name);
  return own;
}

}  // namespace citykiln::plants
