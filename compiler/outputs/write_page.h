// Writes the page of a run, which shows its tileset in a browser.
#pragma once

#include <vector>

#include "compiler/contract/result.h"
#include "compiler/outputs/run_report.h"
#include "compiler/scene/scene.h"
#include "compiler/spec.h"
#include "exporters/output_folder.h"

namespace citykiln::outputs {

/// Writes index.html and page/: the files of the program, page.json (sky, classes, what is assumed), the records of
/// features with their recipes, and names. The page also reads 3dtiles/ and findings.json of the same folder.
/// Error: a geoid that cannot be read.
Result<std::vector<WrittenFile>> write_page(const scene::Scene& scene, const Outputs& outputs, int threads,
                                            exporters::OutputFolder& folder);

}  // namespace citykiln::outputs
