// Reads any bytes as an extract of OpenStreetMap: elements, or one error line.
#include <cstdlib>
#include <iostream>

#include "tests/fuzz/read_extract.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string fault = citykiln::source::fault_of_bytes({reinterpret_cast<const char*>(data), size});
  if (fault.empty()) return 0;
  std::cerr << fault << '\n';
  std::abort();
}
