// Decodes any bytes to a scene or an error. A decoded scene that is encoded and decoded again is unchanged.
#include <cstdlib>

#include "exporters/kiln/manifest.h"
#include "tests/fuzz/unpacked.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace citykiln;
  using namespace citykiln::exporters;
  const std::span<const std::uint8_t> input(data, size);
  // the input as a file, and then with correct checksums
  (void)decode_manifest(std::as_bytes(input), "raw", {});
  const auto bytes = fuzz::packed_manifest(input);
  const auto scene = decode_manifest(std::as_bytes(std::span(bytes)), "packed", {});
  if (!scene) return 0;
  for (const auto& chunk : scene->chunks) {
    const auto alone = decode_manifest(std::as_bytes(std::span(bytes)), "packed", std::span(&chunk.tile, 1));
    if (!alone || alone->chunks.size() != 1 || alone->chunks[0] != chunk) std::abort();
  }
  const auto again = decode_manifest(encode_manifest(*scene, 1), "again", {});
  if (!again || *again != *scene) std::abort();
  return 0;
}
