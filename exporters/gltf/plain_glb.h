// A .glb while it is written, with its JSON as text. Sources that do not parse JSON include this header only.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace citykiln::exporters {

/// A .glb whose buffer is separate, since tinygltf would copy its bytes several times.
struct PlainGlb {
  std::string without_buffer;     ///< The file with an empty buffer, as tinygltf writes it.
  std::vector<std::byte> buffer;  ///< The bytes of the file's only buffer.
};

/// Returns the complete file. Reuses the memory of the buffer.
std::vector<std::byte> joined_glb(PlainGlb plain);

}  // namespace citykiln::exporters
