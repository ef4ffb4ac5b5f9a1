// User-defined plants, as the map reads them: the words of tags that name species, and spawners, which say which
// species grow on areas, and how. The format is explained in compiler/plants/user_species.md.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/map/plants/plant_kind.h"
#include "compiler/map/tag_tests.h"

namespace citykiln::map {

/// A species of a spawner, and its share among them.
struct SpawnedSpecies {
  std::string name;
  double share = 1;
};

/// A row of spawners.txt: for areas and trees with these tags, plants of these species. On an area one plant stands in
/// each cell of a square grid, with a probability.
struct SpawnerRow {
  TagTests tags{};
  std::vector<SpawnedSpecies> species{};
  double grid_m = 0;       ///< The side of a cell, a multiple of 1/8 m.
  double probability = 1;  ///< The probability of a plant in a cell.
  double jitter = 0;       ///< The side of the square in which a plant is placed, as a share of the cell's.
  double from_scale = 1, to_scale = 1;  ///< The range of the height, as a share of the species' height.
  std::string place{};                  ///< File and line.
};

/// The most rows of spawners.txt.
inline constexpr std::size_t kMostSpawners = 64;

/// User-defined plants.
struct UserPlants {
  std::vector<PlantWords> words{};
  std::vector<SpawnerRow> spawners{};
};

/// Reads spawners.txt: one row a line, columns separated by blanks; "#" begins a comment. Errors, with file and line: a
/// wrong number of columns, a column that cannot be read, more than kMostSpawners rows.
Result<std::vector<SpawnerRow>> read_spawners(std::string_view text, const std::string& file);

}  // namespace citykiln::map
