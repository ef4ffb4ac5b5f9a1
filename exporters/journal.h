// The journal of a run in progress: one line of JSON for each complete file, appended after the file has its final
// name. A process may end at any moment: readers skip a last line that is incomplete.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "compiler/contract/result.h"
#include "exporters/file_list.h"

namespace citykiln::exporters {

/// A complete file of a run in progress.
struct StagedFile {
  ListedFile file;
  /// A hash of all inputs that determine the bytes. 0: there is no key, so later runs cannot reuse the file.
  std::uint64_t key = 0;
  std::string note;  ///< Facts about the file for a run that reuses it, UTF-8.
};

/// Returns the line of a file, with the line feed.
std::string journal_line(const StagedFile& staged);

/// Returns the files of a journal by name; the last line of a name counts. Skips lines that are not entries, so it
/// accepts any text.
std::map<std::string, StagedFile> read_journal(const std::string& text);

}  // namespace citykiln::exporters
