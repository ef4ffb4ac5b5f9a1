// The commit of the source that the program was built from, for --version. No output file has it, so that equal inputs
// give equal bytes.
#pragma once

namespace citykiln::commands {

/// Text to append to the version: a space and `git describe --always --tags` in brackets, such as " (1eb75821)".
/// Changes that are not committed are not marked. "" if the source was no git repository. built_commit.cmake writes the
/// definition, again when the commit changes.
extern const char* const kBuiltCommit;

}  // namespace citykiln::commands
