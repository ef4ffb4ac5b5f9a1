// Lists that nearly always have few entries: those need no memory of their own.
#pragma once

#include <boost/container/small_vector.hpp>
#include <cstddef>
#include <span>

namespace citykiln::grammars {

/// As std::vector, with room for `count` entries in itself.
template <typename Entry, std::size_t count>
using SmallVector = boost::container::small_vector<Entry, count>;

/// Its iterators do not tell std::span that they are pointers.
template <typename Entry, std::size_t count>
std::span<const Entry> all_of(const SmallVector<Entry, count>& few) {
  return {few.data(), few.size()};
}

}  // namespace citykiln::grammars
