// Decodes any bytes to a picture or an error, as PNG, JPEG or WebP. A decoded picture that is encoded and decoded again
// is unchanged.
#include <cstdlib>

#include "exporters/gltf/pictures/picture_formats.h"
#include "tests/fuzz/unpacked.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace citykiln::exporters;
  static_cast<void>(decode_picture(std::as_bytes(std::span(data, size)), "picture"));
  const auto bytes = fuzz::packed_png({data, size});
  const auto sheet = decode_png(std::as_bytes(std::span(bytes)), "png");
  if (!sheet) return 0;
  const auto again = decode_png(encode_png(*sheet), "again");
  if (!again || *again != *sheet) std::abort();
  return 0;
}
