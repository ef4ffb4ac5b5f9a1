// PLAN/survey.kiln: what regions cannot know from their own data, as a manifest whose chunks are regions.
#pragma once

#include <string>

#include "compiler/commands/plan_file.h"
#include "compiler/pipeline.h"

namespace citykiln::commands {

/// Writes a survey, unless the file has these bytes already. The chunk of a region has the key of its first tile, and
/// the heights and waters within its halo. Errors: a file that cannot be written.
Result<Done> write_survey(const Survey& survey, const regions::RegionGrid& grid, const std::string& path, int threads);

/// What the survey says of one region, with a hash of it. Errors: a file that cannot be read; one without this region.
struct RegionSurvey {
  Survey survey;
  std::uint64_t hash = 0;
};
Result<RegionSurvey> read_survey(const std::string& path, const Plan& plan, regions::RegionKey region);

}  // namespace citykiln::commands
