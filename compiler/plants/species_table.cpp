#include "compiler/plants/species_table.h"

#include <algorithm>
#include <array>

#include "compiler/contract/erase_repeated.h"
#include "compiler/map/plants/user_plants.h"

namespace citykiln::plants {
namespace {

constexpr std::size_t kShipped = static_cast<std::size_t>(Species::kCount);

std::string_view text_of(std::span<const SpeciesText> texts, std::string_view name) {
  const auto found = std::ranges::find(texts, name, &SpeciesText::name);
  return found == texts.end() ? std::string_view() : std::string_view(found->text);
}

std::vector<SpeciesRow> rows_in(std::span<const SpeciesText> texts) {
  Result<std::vector<SpeciesRow>> rows =
      read_species_rows(text_of(texts, kUserSpeciesName), std::string(kUserSpeciesName));
  return rows ? std::move(*rows) : std::vector<SpeciesRow>{};
}

// The values of a row; views refer to the row and to shipped species.
SpeciesValues values_in(const SpeciesRow& row, const SpeciesValues& like) {
  SpeciesValues values = like;
  values.file = row.name;
  values.leaf_form = row.leaf_form.value_or(like.leaf_form);
  values.height_m = row.height_m.value_or(like.height_m);
  values.tallest_m = std::max(row.tallest_m.value_or(like.tallest_m), values.height_m);
  values.crown_share = row.crown_share.value_or(like.crown_share);
  values.leaf = row.leaf.value_or(like.leaf), values.bark = row.bark.value_or(like.bark);
  values.young_leaf = row.young_leaf.value_or(like.young_leaf);
  values.turned_leaf = row.turned_leaf.value_or(like.turned_leaf);
  if (!row.months.empty()) values.months = row.months;
  return values;
}

const SpeciesValues* shipped_named(std::string_view name) {
  const auto found = std::ranges::find(kSpecies, name, &SpeciesValues::file);
  return found == std::end(kSpecies) ? nullptr : &*found;
}

const SpeciesValues& like_of(const SpeciesRow& row) {
  const SpeciesValues* named = shipped_named(row.like.empty() ? std::string_view(row.name) : row.like);
  return named == nullptr ? values_of(Species::kLime) : *named;
}

}  // namespace

struct SpeciesTable::Rows {
  std::vector<SpeciesRow> texts;  // what the views of values refer to
  std::array<SpeciesValues, kShipped> shipped;
  std::vector<SpeciesValues> own;
  std::vector<Spawner> spawners;
};

SpeciesTable::SpeciesTable() : SpeciesTable(std::span<const SpeciesRow>{}, "") {}

SpeciesTable::SpeciesTable(std::span<const SpeciesText> texts)
    : SpeciesTable(rows_in(texts), text_of(texts, kSpawnersName)) {}

SpeciesTable::SpeciesTable(std::span<const SpeciesRow> rows, std::string_view spawners_text) {
  auto made = std::make_shared<Rows>();
  made->texts.assign(rows.begin(), rows.end());
  std::ranges::copy(kSpecies, made->shipped.begin());
  for (const SpeciesRow& row : made->texts) {
    const SpeciesValues values = values_in(row, like_of(row));
    if (const SpeciesValues* shipped = shipped_named(row.name))
      made->shipped[static_cast<std::size_t>(shipped - kSpecies)] = values;
    else if (made->own.size() < kMostUserSpecies)
      made->own.push_back(values);
  }
  rows_ = made;
  const auto spawners = map::read_spawners(spawners_text, std::string(kSpawnersName));
  if (!spawners) return;
  for (const map::SpawnerRow& row : *spawners) {
    Spawner spawner{{}, row.grid_m, row.probability, row.jitter, row.from_scale, row.to_scale};
    for (const map::SpawnedSpecies& each : row.species)
      spawner.species.push_back({named(each.name).value_or(Species::kBush), each.share});
    made->spawners.push_back(std::move(spawner));
  }
}

const SpeciesValues& SpeciesTable::operator[](Species species) const {
  const auto number = static_cast<std::size_t>(species);
  if (number < kShipped) return rows_->shipped[number];
  const std::size_t own = number - kFirstUserSpecies;
  if (number >= kFirstUserSpecies && own < rows_->own.size()) return rows_->own[own];
  return rows_->shipped[static_cast<std::size_t>(Species::kBush)];
}

std::vector<Species> SpeciesTable::all() const {
  std::vector<Species> all;
  for (std::size_t s = 0; s < kShipped; ++s) all.push_back(static_cast<Species>(s));
  for (std::size_t s = 0; s < rows_->own.size(); ++s) all.push_back(static_cast<Species>(kFirstUserSpecies + s));
  return all;
}

std::optional<Species> SpeciesTable::named(std::string_view name) const {
  for (const Species species : all())
    if ((*this)[species].file == name) return species;
  return std::nullopt;
}

const Spawner& SpeciesTable::spawner(SpeciesMix species_mix) const {
  static const Spawner kNone{{{Species::kBush, 1}}, 1, 1, 0, 1, 1};
  assert(is_spawner(species_mix));
  const std::size_t row = static_cast<std::uint8_t>(species_mix) - kFirstSpawner;
  return row < rows_->spawners.size() ? rows_->spawners[row] : kNone;
}

const SpeciesTable& shipped_table() {
  static const SpeciesTable table;
  return table;
}

std::string name_of(const SpeciesTable& table, SpeciesMix species_mix) {
  if (is_single_species(species_mix)) return std::string(table[single_species(species_mix)].file);
  if (!is_spawner(species_mix)) return name_of(species_mix);
  std::string names;
  for (const SpawnerShare& each : table.spawner(species_mix).species)
    names += (names.empty() ? "" : "+") + std::string(table[each.species].file);
  return names;
}

std::vector<Species> species_in(const SpeciesTable& table, SpeciesMix species_mix) {
  if (!is_spawner(species_mix)) return species_in(species_mix);
  std::vector<Species> all;
  for (const SpawnerShare& each : table.spawner(species_mix).species) all.push_back(each.species);
  sort_unique(all);
  return all;
}

Species draw_species(const SpeciesTable& table, SpeciesMix species_mix, const Habitat& habitat, std::uint64_t seed,
                     double uniform) {
  if (!is_spawner(species_mix)) return draw_species(species_mix, habitat, seed, uniform);
  const std::vector<SpawnerShare>& all = table.spawner(species_mix).species;
  double sum = 0;
  for (const SpawnerShare& each : all) sum += each.share;
  double left = uniform * sum;
  for (const SpawnerShare& each : all)
    if ((left -= each.share) < 0) return each.species;
  return all.back().species;
}

}  // namespace citykiln::plants
