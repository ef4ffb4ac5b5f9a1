// PLAN/survey/X_Y.kiln: what a region cannot know from its own data, as a manifest of one chunk.
#pragma once

#include <string>

#include "compiler/commands/plan_file.h"
#include "compiler/pipeline.h"

namespace citykiln::commands {

/// Writes a file for each region, unless it has these bytes already: the header of the survey, and a chunk with the key
/// of the region's first tile and the heights and waters within its halo. Errors: a file that cannot be written.
/// Memory: one region's besides the survey.
Result<Done> write_survey(const Survey& survey, const regions::RegionGrid& grid, const std::string& plan_folder,
                          int threads);

/// What the survey says of one region, with a hash of it. Errors: a file that cannot be read; one without this region.
struct RegionSurvey {
  Survey survey;
  std::uint64_t hash = 0;
};
Result<RegionSurvey> read_survey(const std::string& plan_folder, const Plan& plan, regions::RegionKey region);

}  // namespace citykiln::commands
