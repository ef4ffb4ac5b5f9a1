// The folder of a plan:
//
//     PLAN/plan.json           settings, extent, regions with what they are expected to cost
//     PLAN/build.ninja         tasks for Ninja; submit.sh for Slurm
//     PLAN/survey/X_Y.kiln     a manifest of one chunk: heights and waters around a region, the scene's header
//     PLAN/survey.json         what was diagnosed in the survey, as findings.json
//     PLAN/cut/X_Y.osm.pbf     the elements of a region and its halo
//     PLAN/regions/X_Y/        the outputs of a region, as compile writes them
//     PLAN/state/X_Y.json      how its task ended (region_state.h)
//     PLAN/out/                what gather writes
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "compiler/commands/compile_request.h"
#include "compiler/contract/result.h"
#include "compiler/map/plane.h"
#include "compiler/regions/cut_extract.h"
#include "compiler/regions/region.h"
#include "compiler/source/owns_place.h"

namespace citykiln::commands {

/// What a task is expected to take (expected_cost.h).
struct ExpectedCost {
  double seconds = 0;
  std::uint64_t memory_bytes = 0, output_bytes = 0;
};

struct PlannedRegion {
  regions::RegionKey key;
  std::size_t tiles = 0;
  regions::RegionFile file;
  std::size_t terrain_vertices = 0;  ///< Of the heights around it, with its halo.
  ExpectedCost expected;
};

struct Plan {
  std::string working_folder;                                 ///< Paths of settings are relative to it.
  std::string spec_path;                                      ///< Of --spec; "" for none.
  std::vector<std::pair<std::string, std::string>> settings;  ///< Name and value, as given.
  source::LonLatBox extent;
  regions::RegionGrid grid;
  std::vector<PlannedRegion> regions;  ///< Sorted by key.
  Report elements;                     ///< Accounts of the elements of the whole extract, which no region can count.
};

/// The plan as JSON. The same plan gives the same bytes.
std::string plan_json(const Plan& plan);
/// Reads PLAN/plan.json. Errors: a file that is missing or no plan.
Result<Plan> read_plan(const std::string& folder);

/// The settings of a plan as a request of compile. Errors: a setting that this program does not know.
Result<CompileRequest> request_of(const Plan& plan);

/// The region named "X_Y". Error: the plan has no such region.
Result<PlannedRegion> region_named(const Plan& plan, const std::string& name);

/// The places that a region owns: regions report the elements there (source/owned_elements.h).
source::OwnsPlace owned_places(const Plan& plan, const map::Plane& plane, regions::RegionKey region);

std::string cut_path(const std::string& plan_folder, regions::RegionKey region);
std::string outputs_path(const std::string& plan_folder, regions::RegionKey region);
/// Diagnoses of what belongs to no region, as findings.json.
std::string survey_findings_path(const std::string& plan_folder);

}  // namespace citykiln::commands
