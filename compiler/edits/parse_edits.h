// Parses a file of edits (edits.md).
#pragma once

#include <string>
#include <string_view>

#include "compiler/contract/result.h"
#include "compiler/edits/edit.h"

namespace citykiln::edits {

/// Returns the edits of a text, one of each line that has words. Error: the first line that is wrong, with its place
/// "FILE:LINE:COLUMN" and what was expected there. O(bytes).
/// @param file  The path of the file, for errors.
Result<Edits> parse_edits(std::string_view text, const std::string& file);

/// Reads a file of edits. Errors: those of parse_edits(); a file that cannot be read.
Result<Edits> read_edits(const std::string& path);

}  // namespace citykiln::edits
