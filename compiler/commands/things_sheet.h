// A picture of things, each at three tolerances.
#pragma once

#include <string>
#include <vector>

#include "compiler/commands/console.h"
#include "compiler/contract/result.h"

namespace citykiln::commands {

/// The things that a sheet shows, and where it is written.
struct ThingsSheet {
  std::string folder;              ///< A folder with a table and rules, as for compile; "" for the shipped ones alone.
  std::vector<std::string> names;  ///< Names of rows of the table; empty for all.
  std::string path;                ///< The picture to write.
};

/// Draws things in their default sizes at 2, 10 and 50 cm, four things in a row, and prints a line for each row of the
/// sheet. Errors: a name that the table lacks, those of the table and the rules, and of writing the picture. Takes
/// about a second a thing.
Result<Done> draw_things_sheet(const ThingsSheet& asked, const Console& console);

}  // namespace citykiln::commands
