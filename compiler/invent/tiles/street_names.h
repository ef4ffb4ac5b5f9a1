// Names of streets of tile cities.
#pragma once

#include <cstdint>
#include <string>

namespace citykiln::invent {

/// Returns a name for the `number`-th street of a world; names of 200 numbers in turn differ. Main streets have other
/// names than small ones.
std::string street_name(std::uint32_t number, bool is_main, std::uint64_t seed);

}  // namespace citykiln::invent
