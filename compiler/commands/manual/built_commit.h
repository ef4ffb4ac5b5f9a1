// The commit from which the program was built. Outputs do not state it: equal inputs give equal bytes.
#pragma once

namespace citykiln::commands {

/// The commit that is checked out, as `git describe` names it: " (1eb75821)"; "" if the source was no git repository.
/// built_commit.cmake writes it when the commit changes.
extern const char* const kBuiltCommit;

}  // namespace citykiln::commands
