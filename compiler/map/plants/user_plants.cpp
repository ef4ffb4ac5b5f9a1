#include "compiler/map/plants/user_plants.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "compiler/contract/texts/parse.h"

namespace citykiln::map {
namespace {

constexpr double kLeastGrid_m = 1, kMostGrid_m = 255, kLeastScale = 0.05, kMostScale = 4, kMostShare = 1000;
constexpr std::string_view kSpawnerColumns = "tags, species, grid, probability, jitter, scale";

Error expected(std::string_view column, std::string_view what, std::string_view found) {
  return {"", fmt::format("{}: expected {}, found \"{}\"", column, what, found)};
}

std::optional<double> within(std::string_view text, double least, double most) {
  const std::optional<double> number = number_in<double>(text);
  return number && *number >= least && *number <= most ? number : std::nullopt;
}

// "oak" or "oak*3".
std::optional<SpawnedSpecies> spawned_species_of(std::string_view text) {
  const std::size_t star = text.find('*');
  const auto share = star == std::string_view::npos ? 1.0 : within(text.substr(star + 1), 1e-3, kMostShare);
  if (text.empty() || star == 0 || !share) return std::nullopt;
  return SpawnedSpecies{std::string(text.substr(0, star)), *share};
}

Result<Done> read_species_column(std::string_view text, SpawnerRow& row) {
  for (const std::string_view part : split(text, ',')) {
    const std::optional<SpawnedSpecies> species = spawned_species_of(part);
    if (!species) return expected("species", "names with shares, such as oak*3,birch", text);
    row.species.push_back(*species);
  }
  return Done{};
}

// "0.8" or "0.6..1.2".
Result<Done> read_scale(std::string_view text, SpawnerRow& row) {
  const std::size_t dots = text.find("..");
  const auto from = within(text.substr(0, dots), kLeastScale, kMostScale);
  const auto to =
      dots == std::string_view::npos ? from : within(text.substr(dots + 2), from.value_or(kLeastScale), kMostScale);
  if (!from || !to)
    return expected("scale", fmt::format("{} to {}, such as 1 or 0.6..1.2", kLeastScale, kMostScale), text);
  row.from_scale = *from, row.to_scale = *to;
  return Done{};
}

Result<SpawnerRow> spawner_of(const std::vector<std::string_view>& words) {
  if (words.size() != 6)
    return Error{"", fmt::format("expected 6 columns ({}), found {}", kSpawnerColumns, words.size())};
  SpawnerRow row;
  Result<TagTests> tags = read_tag_tests(words[0]);
  if (!tags) return tags.error();
  row.tags = std::move(*tags);
  if (const Result<Done> done = read_species_column(words[1], row); !done) return done.error();
  const auto grid_m = within(words[2], kLeastGrid_m, kMostGrid_m), probability = within(words[3], 0, 1),
             jitter = within(words[4], 0, 1);
  if (!grid_m) return expected("grid", fmt::format("{} to {} metres", kLeastGrid_m, kMostGrid_m), words[2]);
  if (!probability) return expected("probability", "0 to 1", words[3]);
  if (!jitter) return expected("jitter", "0 to 1", words[4]);
  row.grid_m = std::floor(*grid_m * 8 + 0.5) / 8, row.probability = *probability, row.jitter = *jitter;
  if (const Result<Done> done = read_scale(words[5], row); !done) return done.error();
  return row;
}

}  // namespace

Result<std::vector<SpawnerRow>> read_spawners(std::string_view text, const std::string& file) {
  std::vector<SpawnerRow> rows;
  std::size_t number = 0;
  for (const std::string_view line : split(text, '\n')) {
    ++number;
    const std::vector<std::string_view> words = words_in(line.substr(0, line.find('#')));
    if (words.empty()) continue;
    const std::string place = fmt::format("{}:{}", file, number);
    Result<SpawnerRow> row = spawner_of(words);
    if (!row) return Error{place, row.error().message};
    row->place = place;
    rows.push_back(std::move(*row));
    if (rows.size() > kMostSpawners) return Error{place, fmt::format("expected at most {} rows", kMostSpawners)};
  }
  return rows;
}

}  // namespace citykiln::map
