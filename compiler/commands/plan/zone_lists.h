// The folder of a plan with several zones (regions/zones.h):
//
//     PLAN/zones.json          the zones, with their boxes and scale errors
//     PLAN/build.ninja         runs the build.ninja of each zone; submit.sh for Slurm
//     PLAN/zones/X_Y/          the plan of a zone (plan_file.h)
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "compiler/commands/verb.h"
#include "compiler/regions/zones.h"

namespace citykiln::commands {

/// Returns the folder of a zone, which is the plan of the zone. A zone is a part of a wide extent with a plane of its
/// own.
std::string zone_path(const std::string& plan_folder, const std::string& zone);

/// Returns the files of the plan's folder: from each name ("zones.json", "build.ninja", "submit.sh") to the file's
/// text. build.ninja compiles zones one after the other, and the regions of each in parallel.
std::map<std::string, std::string> zone_lists(const std::vector<regions::Zone>& zones);

/// True if a plan has zones: its folder has a zones.json.
bool has_zones(const std::string& plan_folder);

/// Calls visit(folder) for the folder of each zone of a plan, also after a visit that failed. Returns kDone if no visit
/// returns an error, whatever Exit they return. For a plan without zones, calls visit(plan_folder) and returns its
/// result.
///
/// Errors: a zones.json that cannot be read (then nothing is visited); else the first error of a visit.
Result<Exit> for_each_zone(const std::string& plan_folder,
                           const std::function<Result<Exit>(const std::string& folder)>& visit);

}  // namespace citykiln::commands
