// Changes of bytes for quick tests of readers: a short run of what a fuzz program does for hours.
#pragma once

#include <algorithm>
#include <cstddef>
#include <random>
#include <string>

namespace citykiln {

/// Returns the bytes with one to six changes: a byte is replaced, or a part is left out, doubled or moved to another
/// place. Equal states of `chance` give equal changes.
inline std::string mutated(std::string bytes, std::mt19937& chance) {
  for (std::size_t changes = 1 + chance() % 6; changes > 0 && !bytes.empty(); --changes) {
    const std::size_t at = chance() % bytes.size(), size = std::min<std::size_t>(bytes.size() - at, 1 + chance() % 24);
    const std::size_t to = chance() % bytes.size();
    const std::string part = bytes.substr(at, size);
    switch (chance() % 4) {
      case 0:
        bytes[at] = static_cast<char>(chance() % 256);
        break;
      case 1:
        bytes.erase(at, size);
        break;
      case 2:
        bytes.insert(to, part);
        break;
      default:
        bytes.erase(at, size).insert(std::min(to, bytes.size()), part);
    }
  }
  return bytes;
}

}  // namespace citykiln
