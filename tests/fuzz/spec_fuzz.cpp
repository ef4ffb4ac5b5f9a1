// Reads any text as a spec.json: settings, or one error line.
#include <cstdint>
#include <cstdlib>
#include <iostream>

#include "tests/fuzz/read_any_spec.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string fault = citykiln::fault_of_spec({reinterpret_cast<const char*>(data), size});
  if (fault.empty()) return 0;
  std::cerr << fault << '\n';
  std::abort();
}
