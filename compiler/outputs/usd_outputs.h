// Writes USD: the layers (files) of levels, tiles and scene, and the textures that they share.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/outputs/run_report.h"
#include "exporters/output_folder.h"
#include "exporters/usd/encode_level.h"
#include "exporters/usd/encode_scene.h"

namespace citykiln::outputs {

/// An encoded level of a tile. Levels are written in order.
struct ReadyUsd {
  exporters::UsdLevel encoded;
  Vec3 origin;  ///< The tile's origin, plane metres.
  double plant_error_m = 0;
  std::vector<bake::PlacedLamp> lights;
  WrittenTile record;
};

/// Encodes a level of a tile.
///
/// @param level   Index into the tolerances of the run.
/// @param lights  The lights of the tile.
ReadyUsd ready_usd(const bake::BakedTile& tile, std::size_t level, const std::vector<bake::PlacedLamp>& lights,
                   const scene::Header& header);

/// Writes levels in the order of tiles, then levels, and each texture once. Keeps a small record per tile. Header and
/// folder must outlive it. Errors of all functions: a file that cannot be written.
class UsdWriter {
 public:
  UsdWriter(const scene::Header& header, exporters::OutputFolder& folder) : header_(header), folder_(folder) {}

  /// Writes a level and its new textures.
  /// @param written  Receives the names and sizes of files, here and below.
  Result<Done> write(const ReadyUsd& ready, WrittenFiles& written);
  /// Writes the layer of the land around the scene, to which finish() refers.
  Result<Done> write_surroundings(const bake::BakedTile& tile, WrittenFiles& written);
  /// Writes the layers of tiles and scene. Call once, after the last level.
  Result<Done> finish(WrittenFiles& written);

 private:
  Result<Done> write_textures(const exporters::UsdLevel& level, WrittenFiles& written);
  Result<Done> write_file(const std::string& name, const std::vector<std::byte>& bytes, WrittenFiles& written);

  const scene::Header& header_;
  exporters::OutputFolder& folder_;
  std::set<std::string> textures_;
  std::vector<exporters::UsdTile> tiles_;
  std::optional<exporters::UsdSurroundings> around_;
};

}  // namespace citykiln::outputs
