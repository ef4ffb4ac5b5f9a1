// Reads and writes plan.json, and names the files in the folder of a plan. A plan divides a large map into regions,
// squares of whole tiles that separate tasks compile.
//
//     PLAN/plan.json           settings, extent, regions with their expected cost
//     PLAN/build.ninja         tasks for Ninja; submit.sh for Slurm
//     PLAN/survey/X_Y.kiln     a manifest of one chunk: heights and waters around a region, the scene's header
//     PLAN/survey.json         the diagnoses of the survey, as findings.json
//     PLAN/cut/X_Y.osm.pbf     the elements of a region and its halo
//     PLAN/regions/X_Y/        the outputs of a region, as compile writes them
//     PLAN/state/X_Y.json      how its task ended (region_state.h)
//     PLAN/out/                the outputs of the whole, written by gather
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "compiler/commands/compile_request.h"
#include "compiler/contract/result.h"
#include "compiler/map/plane/plane.h"
#include "compiler/regions/cut_extract.h"
#include "compiler/regions/region.h"
#include "compiler/source/owns_place.h"

namespace citykiln::commands {

/// The expected cost of a task: time on one core, largest memory, and size of all outputs (expected_cost.h).
struct ExpectedCost {
  double seconds = 0;
  std::uint64_t memory_bytes = 0, output_bytes = 0;
};

/// A region of a plan, with the counts from which its cost is estimated.
struct PlannedRegion {
  regions::RegionKey key;
  std::size_t tiles = 0;
  regions::RegionFile file;  ///< Counts of the map elements in the region's file.
  /// Number of heights of the region and its halo, the data around it that it is compiled with.
  std::size_t terrain_vertices = 0;
  ExpectedCost expected;
};

/// The contents of plan.json.
struct Plan {
  std::string working_folder;                                 ///< Paths of settings are relative to it.
  std::string spec_path;                                      ///< The value of --spec; "" for none.
  std::vector<std::pair<std::string, std::string>> settings;  ///< Name and value, as given.
  source::LonLatBox extent;
  regions::RegionGrid grid;
  std::vector<PlannedRegion> regions;  ///< Sorted by key.
  Report elements;  ///< The accounts of the elements of the whole extract, which no region can count.
};

/// Returns the plan as JSON. Deterministic.
std::string plan_json(const Plan& plan);
/// Reads PLAN/plan.json. Errors: a file that is missing or is not a plan.
Result<Plan> read_plan(const std::string& folder);

/// Returns the settings of a plan as a request of `compile`. Errors: a setting that this program does not know.
Result<CompileRequest> request_of(const Plan& plan);

/// Returns the region named "X_Y". Error: the plan has no such region.
Result<PlannedRegion> region_named(const Plan& plan, const std::string& name);

/// Returns a function that is true for places in the region, or outside the extent and nearest to it. The region
/// reports the elements there (source/read_osm.cpp).
source::OwnsPlace owned_places(const Plan& plan, const map::Plane& plane, regions::RegionKey region);

/// Returns the path of the file with the region's elements.
std::string cut_path(const std::string& plan_folder, regions::RegionKey region);
/// Returns the folder of the region's outputs.
std::string outputs_path(const std::string& plan_folder, regions::RegionKey region);
/// Returns the path of the diagnoses that belong to no region, in the format of findings.json.
std::string survey_findings_path(const std::string& plan_folder);

}  // namespace citykiln::commands
