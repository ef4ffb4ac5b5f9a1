// Takes the files of a tileset into the folder of a run: as files of 3dtiles/, as one archive, or both.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/outputs/run_report.h"
#include "compiler/spec.h"
#include "exporters/output_folder.h"
#include "exporters/tiles3d/archive.h"

namespace citykiln::outputs {

/// The tileset in progress, in the forms that Outputs names. Its bytes depend on the order of its files.
class TreeSink {
 public:
  /// Begins the archive, if there is to be one. Error of this and the other functions: a file that cannot be written.
  /// @param folder  Must outlive the sink.
  static Result<TreeSink> open(const Outputs& outputs, exporters::OutputFolder& folder);

  /// Writes a file.
  /// @param name  The path relative to tileset.json.
  Result<Done> put(const std::string& name, std::span<const std::byte> bytes);

  /// Ends the archive. Returns the files that were written. Nothing may be put afterwards.
  Result<std::vector<WrittenFile>> finish();

 private:
  struct GrowingArchive {
    exporters::GrowingOutput output;
    exporters::TilesetArchive archive{};
  };

  TreeSink(exporters::OutputFolder& folder, bool has_files) : folder_(folder), has_files_(has_files) {}

  exporters::OutputFolder& folder_;
  bool has_files_;
  std::optional<GrowingArchive> archive_;
  std::vector<WrittenFile> files_;
};

}  // namespace citykiln::outputs
