// PLAN/survey/X_Y.kiln: facts that region X_Y of a plan cannot find in its own data, as a manifest (scene file) of one
// chunk. The survey finds them in the whole map, such as levels of lakes and coastlines.
#pragma once

#include <string>

#include "compiler/commands/plan/plan_file.h"
#include "compiler/survey.h"

namespace citykiln::commands {

/// Writes a file per region, unless the file already has these bytes. It holds the header of the survey, and one chunk
/// with the key of the region's first tile and the heights and waters in the region and its halo (the data around it
/// that it is compiled with). Errors: a file that cannot be written. Memory: the survey, and the part of one region.
Result<Done> write_survey(const Survey& survey, const regions::RegionGrid& grid, const std::string& plan_folder,
                          int threads);

/// The survey of one region, and a hash of it.
struct RegionSurvey {
  Survey survey;
  std::uint64_t hash = 0;
};
/// Reads the survey of a region. Errors: a file that cannot be read, or that lacks this region.
Result<RegionSurvey> read_survey(const std::string& plan_folder, const Plan& plan, regions::RegionKey region);

}  // namespace citykiln::commands
