// The streams of a chunk, one per property. Their names are looked up at compile time.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace citykiln::exporters {

/// The names in the order of a chunk.
inline constexpr std::array kStreamNames = {
#define STREAM(name) name,
#include "exporters/kiln/chunk_streams.inc"
#undef STREAM
};

/// The number of a stream, made from its name, such as "knot height". An unknown name does not compile.
struct Stream {
  std::size_t number;
  consteval Stream(const char* name)  // NOLINT: implicit, so that names read as names
      : number(
            static_cast<std::size_t>(std::ranges::find(kStreamNames, std::string_view(name)) - kStreamNames.begin())) {
    if (number == kStreamNames.size()) throw "a name of the list";
  }
  const char* name() const { return kStreamNames[number]; }
};

}  // namespace citykiln::exporters
