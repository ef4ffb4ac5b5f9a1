// Reads any bytes as a layer of USD, text or crate, to a layer or an error. The tables of a crate are compressed, so
// the bytes are its values and the unpacked numbers of a table, too.
#include "exporters/usd/crate_coding.h"
#include "exporters/usd/read_layer.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace citykiln::exporters;
  const auto input = std::as_bytes(std::span(data, size));
  (void)read_usd_layer(input, "layer");
  if (size > 2) (void)decompress_integers(compress_bytes(input.subspan(2)), std::size_t{data[0]} << 8 | data[1]);
  return 0;
}
