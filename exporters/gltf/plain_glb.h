// A .glb while it is written, with its JSON as text: for sources that do not read JSON.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace citykiln::exporters {

/// A .glb whose buffer is apart, since tinygltf would copy its bytes several times.
struct PlainGlb {
  std::string without_buffer;     ///< The file with an empty buffer, as tinygltf writes it.
  std::vector<std::byte> buffer;  ///< The bytes of its only buffer.
};

/// Returns the file with its buffer, whose memory is reused.
std::vector<std::byte> joined_glb(PlainGlb plain);

}  // namespace citykiln::exporters
