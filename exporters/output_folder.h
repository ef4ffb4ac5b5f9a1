// The folder of a run: whole files or none, and report.json last, as the mark that the run is complete.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/result.h"

namespace citykiln::exporters {

/// Files and folders that this made are gone again when it ends without commit().
class OutputFolder {
 public:
  /// Makes the folder where it is missing and takes away the report of an earlier run. Errors: a folder that cannot be
  /// made or written, found now and not after an hour's work.
  static Result<OutputFolder> open(const std::string& path);
  ~OutputFolder();
  OutputFolder(OutputFolder&& other) noexcept;
  OutputFolder& operator=(OutputFolder&&) = delete;
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// @param name  Relative to the folder, "glb/0_0_L1.glb".
  Result<Done> write(const std::string& name, std::span<const std::byte> bytes);

  /// Writes report.json; from here on the files stay.
  Result<Done> commit(const std::string& report_json);

 private:
  explicit OutputFolder(std::string path) : path_(std::move(path)) {}
  Result<Done> make_folder(const std::string& path);

  std::string path_;
  std::vector<std::string> made_folders_, made_files_;
  bool is_open_ = true;  ///< False once committed or moved from.
};

/// A JSON text as bytes.
std::span<const std::byte> bytes_of(const std::string& text);

}  // namespace citykiln::exporters
