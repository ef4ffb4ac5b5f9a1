// Compiles a map, or a region of a plan, and writes its outputs to a folder.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "compiler/commands/verb.h"
#include "compiler/pipeline.h"
#include "exporters/output_folder.h"

namespace citykiln::commands {

/// Makes the scene: compile() or compile_region().
using CompileMap = std::function<Result<CompileResult>(const OnProgress& on_progress)>;

/// What a compile took.
struct Compiled {
  Exit exit = Exit::kDone;
  std::vector<StageCost> costs;
  std::uint64_t bytes = 0;  ///< Of the outputs.
};

/// Writes the outputs that the spec asks for to its folder and prints a summary. The folder then holds this run, or,
/// after an error, the run before.
Result<Compiled> compile_to_folder(const CompileSpec& spec, const CompileMap& compile_map, const Console& console,
                                   exporters::TakesOver takes_over = exporters::TakesOver::kInterrupted);

}  // namespace citykiln::commands
