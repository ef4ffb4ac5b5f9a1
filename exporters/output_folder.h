// The folder of a run: it holds whole files or none, and report.json, written last, marks the run as complete.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/result.h"

namespace citykiln::exporters {

/// Files and folders that it has made are removed when it ends without commit().
class OutputFolder {
 public:
  /// Makes the folder where it is missing, and removes the report of an earlier run. Errors, before any work is done: a
  /// folder that cannot be made or written.
  static Result<OutputFolder> open(const std::string& path);
  ~OutputFolder();
  OutputFolder(OutputFolder&& other) noexcept;
  OutputFolder& operator=(OutputFolder&&) = delete;
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Writes a file. @param name  Relative to the folder, "glb/0_0_L1.glb".
  Result<Done> write(const std::string& name, std::span<const std::byte> bytes);

  /// Writes report.json; from then on the files stay.
  Result<Done> commit(const std::string& report_json);

 private:
  explicit OutputFolder(std::string path) : path_(std::move(path)) {}
  Result<Done> make_folder(const std::string& path);

  std::string path_;
  std::vector<std::string> made_folders_, made_files_;
  bool is_open_ = true;  ///< False once committed or moved from.
};

/// The bytes of a JSON text.
std::span<const std::byte> bytes_of(const std::string& text);

}  // namespace citykiln::exporters
