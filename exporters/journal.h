// The journal of a run in progress: a line of JSON for each file that is whole, appended after the file has its name.
// A process that ends at any moment leaves whole lines, and perhaps one torn line at the end, which is not read.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "compiler/contract/result.h"
#include "exporters/file_list.h"

namespace citykiln::exporters {

/// A whole file of a run in progress.
struct StagedFile {
  ListedFile file;
  std::uint64_t key = 0;  ///< Of what the bytes are a function. 0: none; a later run does not take such a file over.
  std::string note;       ///< What the writer needs to know when it takes the file over. UTF-8.
};

/// The line of a file, with its end.
std::string journal_line(const StagedFile& staged);

/// The files of a journal by name; the last line of a name counts. Lines that are no entries are skipped, so every
/// text is a journal.
std::map<std::string, StagedFile> read_journal(const std::string& text);

}  // namespace citykiln::exporters
