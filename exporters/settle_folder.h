// Finishes a run whose files are all whole: moves them into its folder by renames (output_folder.h, steps 3 to 5).
#pragma once

#include <string>

#include "compiler/contract/result.h"

namespace citykiln::exporters {

/// Moves the files of a finished run from .new into the folder, if there is such a run; else does nothing. Waits for
/// another process that does the same. May end at any moment and be called again. Call before reading a run's folder.
/// Errors: files that cannot be renamed or removed.
Result<Done> settle(const std::string& folder);

/// The same while the caller holds the lock of the folder.
Result<Done> settle_locked(const std::string& folder);

/// Whether the folder holds files of a run that was interrupted before all were whole.
bool has_unfinished_run(const std::string& folder);

/// Locks a folder against other runs until the descriptor is closed or the process ends. Folders on file systems
/// without locks are not protected. @return A file descriptor; or -1 if another process holds the lock and the caller
/// does not wait. Errors: a folder that cannot be opened.
Result<int> lock_folder(const std::string& folder, bool waits);

}  // namespace citykiln::exporters
