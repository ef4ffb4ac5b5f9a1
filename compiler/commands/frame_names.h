// Names of the pictures of a film.
#pragma once

#include <string>
#include <vector>

#include "compiler/contract/result.h"

namespace citykiln::commands {

/// The names of `count` frames: the last run of # in a file's name becomes the frame's number from 1, with as many
/// digits at least; without #, the last run of digits is the number of the first frame. "f_##.png": f_01.png, f_02.png;
/// "f_0017.png": f_0017.png, f_0018.png. The folder's name does not count. Error: neither # nor digits.
Result<std::vector<std::string>> frame_names(const std::string& path, int count);

}  // namespace citykiln::commands
