// Reads any text as a .tree file, as species.txt and as spawners.txt, or as one error line. Any tree grows, twice
// alike, within its limits to a finite skeleton. Any rows make a table, and rows that are written and read again are
// unchanged.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "compiler/map/plants/user_plants.h"
#include "compiler/plants/species_table.h"
#include "lsystems/weber_penn.h"
#include "tests/fuzz/sound_skeleton.h"

namespace {

using namespace citykiln;

void check_error(const Error& error) {
  if (to_string(error).find('\n') != std::string::npos) std::abort();
}

void check_tree(const std::string& text) {
  Result<lsystems::TreeParameters> tree = lsystems::read_weber_penn(text, "fuzz.tree");
  if (!tree) return check_error(tree.error());
  const lsystems::GrownTree grown = lsystems::grow_tree(*tree, 1);
  if (grown.skeleton.segments.size() + grown.skeleton.instances.size() > lsystems::kMostPlantParts) std::abort();
  lsystems::check_skeleton(grown.skeleton);
  if (grown.stopped) return;
  const lsystems::GrownTree again = lsystems::grow_tree(*tree, 1);
  if (again.skeleton.segments.size() != grown.skeleton.segments.size()) std::abort();
  for (std::size_t i = 0; i < grown.skeleton.segments.size(); ++i)
    if (grown.skeleton.segments[i].start.at != again.skeleton.segments[i].start.at) std::abort();
}

void check_rows(const std::string& text) {
  const Result<std::vector<plants::SpeciesRow>> rows = plants::read_species_rows(text, "species.txt");
  if (!rows) return check_error(rows.error());
  const plants::SpeciesTable table(*rows, "");
  for (const plants::Species species : table.all()) {
    const plants::SpeciesValues& values = table[species];
    if (!(values.height_m > 0) || values.tallest_m < values.height_m || values.months.size() != 12) std::abort();
  }
  std::string written;
  for (const plants::SpeciesRow& row : *rows) written += to_text(row) + "\n";
  const Result<std::vector<plants::SpeciesRow>> again = plants::read_species_rows(written, "species.txt");
  if (!again || again->size() != rows->size()) std::abort();
  for (std::size_t i = 0; i < rows->size(); ++i)
    if (to_text((*rows)[i]) != to_text((*again)[i])) std::abort();
}

void check_spawners(const std::string& text) {
  if (const auto rows = map::read_spawners(text, "spawners.txt"); !rows) check_error(rows.error());
  const plants::SpeciesTable table({}, text);
  for (std::size_t row = 0; row < map::kMostSpawners; ++row)
    if (table.spawner(plants::species_mix_of_spawner(row)).species.empty()) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  // the first byte chooses the reader
  switch (data[0] % 4) {
    case 0:
      check_rows(text);
      break;
    case 1:
      check_spawners(text);
      break;
    default:
      check_tree(text);
  }
  return 0;
}
