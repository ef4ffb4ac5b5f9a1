// Reads any text as a tileset: every text gives results, and none ends the program.
#include <string>

#include "compiler/verify/check_tileset.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  citykiln::verify::CheckResults results;
  (void)citykiln::verify::check_tileset_file(std::string(reinterpret_cast<const char*>(data), size), "raw", results);
  return 0;
}
