// Vectors with inline storage for lists that usually have few entries.
#pragma once

#include <boost/container/small_vector.hpp>
#include <cstddef>
#include <span>

namespace citykiln::grammars {

/// A vector with inline storage for `count` entries.
template <typename Entry, std::size_t count>
using SmallVector = boost::container::small_vector<Entry, count>;

/// Returns a span over all entries. Boost's iterators are not contiguous iterators in the sense of std::span.
template <typename Entry, std::size_t count>
std::span<const Entry> span_of(const SmallVector<Entry, count>& entries) {
  return {entries.data(), entries.size()};
}

}  // namespace citykiln::grammars
