// Frees the buffers of a decoded file while its elements are copied, so that the file and the copy are never both
// complete in memory.
#pragma once

#include <cstddef>
#include <osmium/memory/buffer.hpp>
#include <vector>

#include "compiler/source/order_elements.h"

namespace citykiln::source {

/// Counts how many elements of each buffer are not yet copied. A buffer is freed when its count is 0, and memory goes
/// back to the system in steps of kGiveBack_bytes.
class PendingElements {
 public:
  static constexpr std::size_t kGiveBack_bytes = std::size_t{64} << 20;

  /// Starts with all nodes, ways and relations pending. Buffers without elements are freed at once.
  PendingElements(std::vector<osmium::memory::Buffer>& buffers, const Elements& elements);

  /// Marks a pending element as copied. It must not be read afterwards, since its buffer may be freed. O(1) if the
  /// element is in the same buffer as that of the last call, else O(log n) in buffers.
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
