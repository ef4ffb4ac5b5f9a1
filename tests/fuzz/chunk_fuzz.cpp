// Decodes any streams to a chunk or to the name of the wrong stream. A decoded chunk that is encoded and decoded again
// is unchanged.
#include <cstdlib>

#include "tests/fuzz/unpacked.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace citykiln;
  using namespace citykiln::exporters;
  const Streams streams = fuzz::packed_streams({data, size});
  std::string wrong;
  const auto chunk = decode_chunk(streams, {1, 2}, 7, wrong);
  if (chunk.has_value() != wrong.empty()) std::abort();
  if (!chunk) return 0;
  Streams written = encode_chunk(*chunk, 7);
  for (const char* name : stream_names()) written[name];
  const auto again = decode_chunk(written, {1, 2}, 7, wrong);
  if (!again || *again != *chunk) std::abort();
  return 0;
}
