#include "compiler/source/pending_elements.h"

#include <algorithm>
#include <cassert>
#include <functional>

#include "compiler/contract/system/give_back_memory.h"

namespace citykiln::source {

PendingElements::PendingElements(std::vector<osmium::memory::Buffer>& buffers, const Elements& elements) {
  for (osmium::memory::Buffer& buffer : buffers)
    if (buffer && buffer.committed() > 0) parts_.push_back({buffer.data(), &buffer, 0});
  std::ranges::sort(parts_, std::less<>(), &Part::begin);
  for (const osmium::Node* node : elements.nodes) ++part_of(*node).pending;
  for (const osmium::Way* way : elements.ways) ++part_of(*way).pending;
  for (const osmium::Relation* relation : elements.relations) ++part_of(*relation).pending;
  for (Part& part : parts_)
    if (part.pending == 0) free_buffer(part);
}

void PendingElements::done(const osmium::OSMObject& element) {
  Part& part = part_of(element);
  assert(part.pending > 0);
  if (--part.pending == 0) free_buffer(part);
}

PendingElements::Part& PendingElements::part_of(const osmium::OSMObject& element) {
  const unsigned char* at = element.data();
  const auto contains = [&](const Part& part) {
    return part.begin <= at && at < part.begin + part.buffer->committed();
  };
  if (!contains(parts_[last_])) {
    const auto after = std::ranges::upper_bound(parts_, at, std::less<>(), &Part::begin);
    last_ = static_cast<std::size_t>(after - parts_.begin()) - 1;
  }
  assert(contains(parts_[last_]));
  return parts_[last_];
}

void PendingElements::free_buffer(Part& part) {
  freed_bytes_ += part.buffer->capacity();
  *part.buffer = {};
  if (freed_bytes_ < kGiveBack_bytes) return;
  freed_bytes_ = 0;
  give_back_memory();
}

}  // namespace citykiln::source
