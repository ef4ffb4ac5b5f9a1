// Writes the outputs of a scene to a folder. Shared by compile and bake, so that both write the same bytes.
#pragma once

#include <cstddef>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/contract/report.h"
#include "compiler/contract/result.h"
#include "compiler/scene/scene.h"
#include "compiler/spec.h"
#include "compiler/stage_timer.h"
#include "compiler/verify/run_report.h"
#include "exporters/output_folder.h"

namespace citykiln::commands {

/// Bakes and writes scene.kiln and glb/<x>_<y>_L<n>.glb as the outputs ask, one tile at a time.
Result<verify::WrittenFiles> write_outputs(const scene::Scene& scene, const Outputs& outputs, int threads,
                                           exporters::OutputFolder& folder, Report& report,
                                           const OnProgress& on_progress);

}  // namespace citykiln::commands
