// Reads and writes report.json (what a run read, planned and wrote) and writes timing.json. Times are kept apart
// because they differ between runs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/contract/result.h"
#include "compiler/scene/scene.h"
#include "compiler/spec.h"
#include "compiler/stage_timer.h"
#include "compiler/verify/measure_heights.h"
#include "exporters/gltf/glb.h"

namespace citykiln::verify {

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
  std::uint64_t triangles = 0;  ///< Including those of every instance.
  std::uint64_t instances = 0;
};

struct WrittenFiles {
  std::vector<WrittenFile> files;  ///< All files except tiles.
  std::vector<WrittenTile> tiles;
  std::vector<WrittenTile> usd{};  ///< The same tiles as layers of USD.
  std::uint64_t bytes() const;
};

/// Consistency of heights: of the recipes, and of the planner's lines if the run compiled a map.
struct HeightReport {
  HeightMeasures recipes;
  std::optional<ground::ProfileMeasures> planned{};
};

/// The report as JSON. The same inputs give the same bytes: it contains no times, folders or thread counts.
std::string report_json(const scene::Header& header, const scene::Scene& scene, const Report& report,
                        const WrittenFiles& written, const Outputs& outputs, const HeightReport& heights);
std::string timing_json(std::span<const StageCost> costs, int threads);

/// The settings of a run as types of the .glb exporter.
exporters::GlbOptions glb_options_of(const Outputs& outputs);
/// The most instances a tile should have for its target (bake::prepare()).
std::size_t most_instances_of(Target target);

/// True if a diagnosis is kMended or kDropped.
bool has_mended_or_dropped(const Report& report);
/// Whether --strict reports a run by the exit code: a diagnosis has one of its codes, or is kMended or kDropped if it
/// has none.
bool is_violated(const Strictness& strict, const Report& report);

/// The part of report.json that `check` and `preview` need.
struct RunRecord {
  std::vector<WrittenTile> tiles, usd;
  Target target = Target::kGeneric;
  Split split = Split::kLayer;
  Compression compress = Compression::kNone;
  Layout layout = Layout::kEmbedded;
  bool has_manifest = false;
  Report ledger;                        ///< Without diagnoses.
  std::vector<std::string> unbalanced;  ///< Accounts of the ledger whose numbers do not balance.
};
/// Finishes an interrupted commit first (exporters/settle_folder.h).
Result<RunRecord> read_report(const std::string& folder);

}  // namespace citykiln::verify
