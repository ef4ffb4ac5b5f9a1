// The file names of the pictures of a film.
#pragma once

#include <string>
#include <vector>

#include "compiler/contract/result.h"

namespace citykiln::commands {

/// Returns the names of `count` frames. The last run of # in the file's name is replaced by the frame's number from 1,
/// with at least as many digits. Without #, the last run of digits is the number of the first frame. "f_##.png":
/// f_01.png, f_02.png; "f_0017.png": f_0017.png, f_0018.png. The folder's name is not searched. Error: neither # nor
/// digits.
Result<std::vector<std::string>> frame_names(const std::string& path, int count);

}  // namespace citykiln::commands
