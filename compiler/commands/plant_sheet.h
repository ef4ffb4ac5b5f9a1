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
  std::string path;     ///< The picture to write: .png, or .exr with linear colours.
};

/// Draws a plant in its usual height, or all plants of a folder. The picture has a row for each plant and a column for
/// each level: the tolerances 0.1, 0.5, 1.2, 2.5 and 12.5 m, for plants below 8 m a tenth of these. Plants are seen
/// from a person's height, or from lower down if they are low. Prints a line of triangles and error for each level.
/// Takes about five seconds a plant.
///
/// Errors: a text that is neither a shipped species nor such a path; those of plants::read_species_folder(), and of
/// writing the picture.
Result<Done> draw_plant_sheet(const PlantSheet& asked, const Console& console);

}  // namespace citykiln::commands
