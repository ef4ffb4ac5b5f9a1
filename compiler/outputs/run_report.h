// Reads and writes report.json, which states the inputs, the numbers of objects and the files of a run, and writes
// timing.json. Times have their own file because they differ between runs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/contract/result.h"
#include "compiler/scene/scene.h"
#include "compiler/spec.h"
#include "compiler/stage_timer.h"
#include "exporters/gltf/glb.h"

namespace citykiln::outputs {

/// A file written by a run.
struct WrittenFile {
  std::string name;  ///< Relative to the folder.
  std::uint64_t bytes = 0;
};

/// The file of a tile at one level of detail.
struct WrittenTile {
  WrittenFile file;
  scene::TileKey tile;    ///< The column and row of the tile.
  std::size_t level = 0;  ///< Index into the tolerances of the run; 0 is the finest.
  /// The tolerance of the level; the error that the meshes have, at most the tolerance.
  double tolerance_m = 0, error_m = 0;
  std::uint64_t triangles = 0;  ///< With the triangles of every instance.
  std::uint64_t instances = 0;  ///< The number of placed copies of shared meshes.
};

/// All files written by a run.
struct WrittenFiles {
  std::vector<WrittenFile> files;  ///< All files except tiles.
  std::vector<WrittenTile> tiles;  ///< The tiles as .glb files.
  std::vector<WrittenTile> usd{};  ///< The tiles as USD layers.
  /// Returns the size of all files together.
  std::uint64_t bytes() const;
};

/// Returns the report as JSON. It contains no times, folders or thread counts, so that equal inputs give equal bytes.
/// @param report   The diagnoses (findings about the input data) and the ledger of the run (see RunRecord::ledger).
/// @param heights  Measures of the scene's heights, such as clearances below bridges: result of verify::heights_json().
std::string report_json(const scene::Header& header, const scene::Scene& scene, const Report& report,
                        const WrittenFiles& written, const Outputs& outputs, const nlohmann::ordered_json& heights);
/// Returns the time and memory of each stage as JSON.
std::string timing_json(std::span<const StageCost> costs, int threads);

/// Returns the settings of a run as types of the .glb exporter.
exporters::GlbOptions glb_options_of(const Outputs& outputs);
/// Returns the largest number of instances that a tile should have for its target (bake::prepare()).
std::size_t most_instances_of(Target target);

/// True if an object of the input was changed or left out: a diagnosis has Severity::kMended or kDropped.
bool has_mended_or_dropped(const Report& report);
/// True if the run must end with exit code 2 because of --strict. If --strict lists codes, one diagnosis with such a
/// code is enough; without codes the condition is has_mended_or_dropped().
bool is_violated(const Strictness& strict, const Report& report);

/// The part of report.json that `check` and `preview` need.
struct RunRecord {
  std::vector<WrittenTile> tiles, usd;        ///< WrittenFiles::tiles and usd of the run.
  Target target = Target::kGeneric;           ///< The program for which the files were written.
  NodeSplit split = NodeSplit::kLayer;        ///< The division of a tile into meshes.
  Compression compress = Compression::kNone;  ///< The compression of the meshes.
  Layout layout = Layout::kEmbedded;          ///< The place of shared meshes and images: in each tile or in files.
  std::size_t lights = 0;                     ///< The largest number of lamps of a tile that are lights.
  bool has_manifest = false;                  ///< True if the run wrote the scene as a file (scene.kiln).
  /// The object counts of the run, and those of assumptions, without its diagnoses. A Report::ledger() has one account
  /// per stage and kind of objects: how many went into the stage, came out, were merged or were dropped.
  Report ledger;
  /// The accounts in which these counts do not add up (Account::balances()), as "stage/kind": objects were lost without
  /// a diagnosis.
  std::vector<std::string> unbalanced;
};
/// Reads report.json of a run's folder. If a run was interrupted while its complete files were moved into the folder,
/// the function first moves the others (exporters/finish_commit.h). Errors: a folder without a finished run; a file
/// that is not JSON or lacks a member that report_json() writes.
Result<RunRecord> read_report(const std::string& folder);

}  // namespace citykiln::outputs
