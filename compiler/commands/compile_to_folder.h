// Compiles a map, or a region of a plan, and writes its outputs to a folder. A plan divides a large map into regions
// that are compiled separately.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "compiler/commands/verb.h"
#include "compiler/pipeline.h"
#include "exporters/output_folder.h"

namespace citykiln::commands {

/// A function that makes the scene: compile() or compile_region().
using CompileMap = std::function<Result<CompileResult>(const OnProgress& on_progress)>;

/// The result and the cost of a compile.
struct Compiled {
  Exit exit = Exit::kDone;
  std::vector<StageCost> costs;
  std::uint64_t bytes = 0;  ///< The size of all outputs.
};

/// Compiles a map, writes the outputs that the spec asks for to its folder, and prints a summary. Afterwards the folder
/// holds this run or, after an error, the earlier run.
/// @param compile_map  Makes the scene.
/// @param takes_over   The runs whose finished tiles may be reused.
Result<Compiled> compile_to_folder(const CompileSpec& spec, const CompileMap& compile_map, const Console& console,
                                   exporters::TakesOver takes_over = exporters::TakesOver::kInterrupted);

/// Returns the command that shows a run, as a line of output.
std::string view_line(const std::string& folder);

}  // namespace citykiln::commands
