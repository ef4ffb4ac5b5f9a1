// Decodes any bytes to a tile or an error. A decoded tile that is encoded and decoded again is unchanged.
#include <cstdlib>

#include "exporters/gltf/glb.h"
#include "tests/exporters/made_tile.h"
#include "tests/fuzz/unpacked.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace citykiln;
  using namespace citykiln::exporters;
  const std::span<const std::uint8_t> input(data, size);
  (void)decode_glb(std::as_bytes(input), "raw");
  const auto bytes = fuzz::packed_glb(input);
  const auto tile = decode_glb(std::as_bytes(std::span(bytes)), "packed");
  if (!tile) return 0;
  for (const auto& primitive : tile->primitives)
    for (const auto& triangle : primitive.triangles)
      for (const auto corner : triangle)
        if (corner >= primitive.positions.size()) std::abort();
  const auto again = decode_glb(encode_glb(*tile, {}, {.has_exact_pictures = true}), "again");
  if (!again || exporters::without_uvs(*again) != exporters::without_uvs(*tile)) std::abort();
  return 0;
}
