// Finishes the commit of a run whose files are all complete: moves them into the output folder by renames
// (output_folder.h, steps 3 to 5).
#pragma once

#include <string>

#include "compiler/contract/result.h"

namespace citykiln::exporters {

/// Moves the files of a finished run from .new into the folder, if there is such a run. Waits for another process that
/// does so. After an interruption at any moment, the function can be called again. It must be called before a run's
/// folder is read. Errors: files that cannot be renamed or removed.
Result<Done> finish_commit(const std::string& folder);

/// Does the work of finish_commit() for a caller that holds the lock of the folder, with the same errors.
Result<Done> finish_commit_locked(const std::string& folder);

/// True if the folder holds files of a run that was interrupted before all were complete.
bool has_unfinished_run(const std::string& folder);

/// Locks a folder against other runs until the descriptor is closed or the process ends. Folders on file systems
/// without locks are not protected. @return A file descriptor; -1 if another process holds the lock and `waits` is
/// false. Errors: a folder that cannot be opened.
Result<int> lock_folder(const std::string& folder, bool waits);

}  // namespace citykiln::exporters
