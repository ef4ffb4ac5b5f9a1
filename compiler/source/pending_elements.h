// Frees the buffers of a decoded file while their elements are copied.
#pragma once

#include <cstddef>
#include <osmium/memory/buffer.hpp>
#include <vector>

#include "compiler/source/order_elements.h"

namespace citykiln::source {

/// Counts the elements of each buffer that are still to be read. A buffer without any is freed, and memory goes back to
/// the system in steps of kGiveBack_bytes: the copy of a file replaces its buffers instead of standing beside them.
class PendingElements {
 public:
  static constexpr std::size_t kGiveBack_bytes = std::size_t{64} << 20;

  /// All nodes, ways and relations are pending. Buffers without elements are freed at once.
  PendingElements(std::vector<osmium::memory::Buffer>& buffers, const Elements& elements);

  /// The element, which must be pending, is not read again: it may be gone when this returns. O(1) for the buffer of
  /// the last call, else O(log n) in buffers.
  void done(const osmium::OSMObject& element);

 private:
  struct Part {
    const unsigned char* begin;
    osmium::memory::Buffer* buffer;
    std::size_t pending;
  };

  Part& part_of(const osmium::OSMObject& element);
  void free_buffer(Part& part);

  std::vector<Part> parts_;  // sorted by address
  std::size_t last_ = 0;     // the part of the last element
  std::size_t freed_bytes_ = 0;
};

}  // namespace citykiln::source
