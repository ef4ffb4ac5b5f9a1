// Reads and writes report.json, which states the inputs, recipes and outputs of a run, and writes timing.json. Times
// have their own file because they differ between runs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/contract/result.h"
#include "compiler/scene/scene.h"
#include "compiler/spec.h"
#include "compiler/stage_timer.h"
#include "exporters/gltf/compression.h"
#include "exporters/gltf/glb.h"

namespace citykiln::outputs {

/// A file written by a run.
struct WrittenFile {
  std::string name;  ///< Relative to the folder.
  std::uint64_t bytes = 0;
};

/// The file of a tile at one level.
struct WrittenTile {
  WrittenFile file;
  scene::TileKey tile;
  std::size_t level = 0;
  double tolerance_m = 0, error_m = 0;
  std::uint64_t triangles = 0;  ///< With the triangles of every instance.
  std::uint64_t instances = 0;
};

/// All files written by a run.
struct WrittenFiles {
  std::vector<WrittenFile> files;  ///< All files except tiles.
  std::vector<WrittenTile> tiles;
  std::vector<WrittenTile> usd{};  ///< The tiles as layers of USD.
  std::uint64_t bytes() const;
};

/// Returns the report as JSON. It contains no times, folders or thread counts, so that equal inputs give equal bytes.
/// @param heights  The consistency of heights: result of verify::heights_json().
std::string report_json(const scene::Header& header, const scene::Scene& scene, const Report& report,
                        const WrittenFiles& written, const Outputs& outputs, const nlohmann::ordered_json& heights);
/// Returns the time and memory of each stage as JSON.
std::string timing_json(std::span<const StageCost> costs, int threads);

/// Returns the settings of a run as types of the .glb exporter.
exporters::GlbOptions glb_options_of(const Outputs& outputs);
/// Returns the largest number of instances that a tile should have for its target (bake::prepare()).
std::size_t most_instances_of(Target target);

/// True if a diagnosis is kMended or kDropped.
bool has_mended_or_dropped(const Report& report);
/// True if --strict lets the run end with exit code 2: a diagnosis has one of the codes of --strict, or, without codes,
/// is kMended or kDropped.
bool is_violated(const Strictness& strict, const Report& report);

/// The part of report.json that `check` and `preview` need.
struct RunRecord {
  std::vector<WrittenTile> tiles, usd;
  Target target = Target::kGeneric;
  Split split = Split::kLayer;
  Compress compress = Compress::kNone;
  Layout layout = Layout::kEmbedded;
  bool has_manifest = false;
  Report ledger;                        ///< The ledger, without diagnoses.
  std::vector<std::string> unbalanced;  ///< The accounts of the ledger that do not balance.
};
/// Reads report.json of a run's folder, after finishing a commit that was interrupted (exporters/settle_folder.h).
/// Errors: no finished run, or a report of another form.
Result<RunRecord> read_report(const std::string& folder);

}  // namespace citykiln::outputs
