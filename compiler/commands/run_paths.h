// The manifest and the folder of a run, given either of them.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "compiler/contract/result.h"

namespace citykiln::commands {

/// Returns "OUT/scene.kiln" for "OUT", the folder of a run; any other path unchanged. The manifest is the file with the
/// scene.
///
/// May change the folder, also for "OUT/scene.kiln": an interrupted run may have moved only some of its finished files
/// into the folder; the function then moves the rest (exporters/finish_commit.h). Errors: nothing is there; a map,
/// which has to be compiled first; a folder without a manifest; files that cannot be moved.
Result<std::string> find_committed_manifest(const std::string& path);

/// Tests whether a path may be the output of a run: a folder, or a .kiln, .glb or other file. Errors that say what to
/// do: nothing is there; it is a map, which has to be compiled first.
Result<Done> check_run_path(const std::string& path);

/// Returns the error of a folder without a manifest: no finished run, or one that was written without it.
Error missing_manifest(const std::string& folder);

/// True if a file's name ends as those of maps do: .osm, .osm.gz, .osm.bz2, .osm.pbf.
bool is_map_name(std::string_view path);

/// Tests before the work whether a file can be written after it. Errors: a name with another ending, if `endings` are
/// given; a folder of this name; a folder of the file that is not there or may not be written. Changes nothing.
Result<Done> check_output_file(const std::string& path, std::initializer_list<std::string_view> endings = {});

/// Creates a folder for outputs if it is missing. Errors: a file in its place; a folder that cannot be written.
Result<Done> make_output_folder(const std::string& folder);

/// Returns "OUT" for "OUT/scene.kiln" and "." for "scene.kiln"; any other path unchanged.
std::string folder_of(const std::string& path);

}  // namespace citykiln::commands
