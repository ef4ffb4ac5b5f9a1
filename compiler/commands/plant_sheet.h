// A picture of plants, each at several levels.
#pragma once

#include <string>
#include <vector>

#include "compiler/commands/console.h"
#include "compiler/contract/result.h"

namespace citykiln::commands {

/// The plants that a sheet shows, and where it is written.
struct PlantSheet {
  std::string species;  ///< The name of a shipped species, the path of a plant's file, or a folder of species.
  std::string path;     ///< The picture to write.
};

/// Draws a plant, or all those of a folder, one in a row, in its usual height at 0.1, 0.5, 1.2, 2.5 and 12.5 m (low
/// plants at a tenth), seen from a person's height or from lower down if it is low. Prints a line of triangles and
/// error for each level. Errors: neither a species nor a file; those of plants::read_species_folder(), and of writing
/// the picture. Takes about five seconds a plant.
Result<Done> draw_plant_sheet(const PlantSheet& asked, const Console& console);

}  // namespace citykiln::commands
