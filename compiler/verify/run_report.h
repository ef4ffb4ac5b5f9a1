// report.json: what a run took in, what became of it, and what it left; timing.json: what that took, apart, since it is
// never the same twice.
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
#include "exporters/gltf/compression.h"
#include "exporters/gltf/glb.h"

namespace citykiln::verify {

/// A file a run wrote.
struct WrittenFile {
  std::string name;  ///< Relative to the folder.
  std::uint64_t bytes = 0;
};

/// A tile at a level, in a file.
struct WrittenTile {
  WrittenFile file;
  scene::TileKey tile;
  std::size_t level = 0;
  double tolerance_m = 0, error_m = 0;
  std::uint64_t triangles = 0;  ///< Each instance's counted.
  std::uint64_t instances = 0;
};

struct WrittenFiles {
  std::vector<WrittenFile> files;  ///< Those that are not tiles.
  std::vector<WrittenTile> tiles;
  std::uint64_t bytes() const;
};

/// How well heights agree: what the recipes say, and what only a run that had the map can say.
struct HeightReport {
  HeightMeasures recipes;
  std::optional<ground::ProfileMeasures> planned{};
};

/// The report as JSON. Same inputs, same bytes: no times, no folders, no thread counts in it.
std::string report_json(const scene::Header& header, const scene::Scene& scene, const Report& report,
                        const WrittenFiles& written, const Outputs& outputs, const HeightReport& heights);
std::string timing_json(std::span<const StageCost> costs, int threads);

/// The settings of a run as the writer of .glb files has them.
exporters::Compression compression_of(Compress compress);
exporters::Instancing instancing_of(bool instances_as_nodes);

/// True where something was mended or dropped: what --strict objects to.
bool has_mended_or_dropped(const Report& report);

/// What `check` and `preview` need of a report.json.
struct RunRecord {
  std::vector<WrittenTile> tiles;
  bool instances_as_nodes = false;
  Compress compress = Compress::kNone;
  bool has_manifest = false;
  std::vector<std::string> unbalanced;  ///< Accounts of the ledger whose numbers, added up again, do not balance.
};
Result<RunRecord> read_report(const std::string& folder);

}  // namespace citykiln::verify
