// Reads and writes whole files. A file gets its final name only when it is complete.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/result.h"

namespace citykiln::exporters {

/// Writes a temporary file beside the final name, closes it, then renames it. On any failure (full disk, unwritable
/// folder) it removes the temporary file and leaves an earlier file of that name as it was.
Result<Done> write_file(const std::string& path, std::span<const std::byte> bytes);

/// A file that grows piece by piece under a temporary name. An object destroyed before finish() removes it.
class GrowingFile {
 public:
  /// Creates the temporary file, in place of an earlier one. Error: a file that cannot be created.
  /// @param part  The temporary name, in the folder of `path`.
  static Result<GrowingFile> create(std::string path, std::string part);
  ~GrowingFile();
  GrowingFile(GrowingFile&& other) noexcept;
  GrowingFile& operator=(GrowingFile&&) = delete;
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  /// Writes bytes at the end. Error of both: a file that cannot be written. Nothing may follow an error.
  Result<Done> append(std::span<const std::byte> bytes);
  /// Closes the file and renames it to `path`. Nothing may be appended afterwards.
  Result<Done> finish();

 private:
  GrowingFile(std::string path, std::string part, int file);
  Error not_written(int reason) const;

  std::string path_, part_;
  int file_;  ///< A file descriptor; -1 once closed or moved from.
};

/// Reads a file. Errors: a missing file, a folder, a pipe (its size is unknown).
Result<std::vector<std::byte>> read_file(const std::string& path);

}  // namespace citykiln::exporters
