// Writes the outputs of a scene to a folder. `compile` and `bake` share it, so that both write the same bytes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/contract/result.h"
#include "compiler/outputs/findings.h"
#include "compiler/outputs/run_report.h"
#include "compiler/scene/scene.h"
#include "compiler/spec.h"
#include "compiler/stage_timer.h"
#include "exporters/output_folder.h"

namespace citykiln::outputs {

/// The result of write_outputs().
struct WrittenOutputs {
  WrittenFiles files;
  std::vector<Finding> findings;  ///< The findings of baking.
  std::string solved;  ///< A line of text with the tolerances that were chosen to keep max_bytes or max_triangles;
                       ///< empty without these limits.
  std::vector<std::string> notes{};  ///< Lines for the user.
  std::size_t taken_over = 0;        ///< Tiles of an earlier run that were reused instead of baked.
};

/// Bakes the tiles of a scene and writes the forms that the outputs ask for: scene.kiln, glb/<x>_<y>_L<n>.glb, usd/…,
/// 3dtiles/…, the page, clouds and surroundings. Tiles are baked in parallel and written in order; with max_bytes or
/// max_triangles, one at a time.
///
/// Complete .glb tiles of an earlier run with equal keys (bake_keys.h) are reused, but not with USD, Layout::kShared,
/// max_bytes or max_triangles; records, report and findings are the same as if they were baked. Each tile is counted
/// in `report` once, however many forms are written.
///
/// Errors: files that cannot be written; a geoid that cannot be read. If tiles of this run can be reused, the error
/// says so.
Result<WrittenOutputs> write_outputs(const scene::Scene& scene, const Outputs& outputs, int threads,
                                     exporters::OutputFolder& folder, Report& report, const OnProgress& on_progress);

/// Bakes the land around a scene and writes it as glb/surroundings.glb; nothing where the header has none. Errors: the
/// file cannot be written.
Result<std::optional<WrittenFile>> write_glb_surroundings(const scene::Scene& scene, const Outputs& outputs,
                                                          int threads, exporters::OutputFolder& folder);

/// Writes findings.json and report.json, and replaces the earlier run in the folder. Errors: files that cannot be
/// written or moved.
Result<Done> commit_outputs(const WrittenOutputs& written, const std::string& report_json, const scene::Header& header,
                            exporters::OutputFolder& folder);

/// Returns lines for the user: the tolerances that limits led to, the number of reused tiles, and the files in the
/// folder that are not of the run.
std::vector<std::string> notes_of(const std::string& folder, const WrittenOutputs& written,
                                  const exporters::FileList& files);

}  // namespace citykiln::outputs
