// Buffers that are freed while their elements are copied.
#include "compiler/source/pending_elements.h"

#include <gtest/gtest.h>

#include <osmium/builder/attr.hpp>

namespace citykiln::source {
namespace {

using osmium::builder::add_node;
using osmium::builder::add_way;
using namespace osmium::builder::attr;

osmium::memory::Buffer buffer_of_nodes(std::initializer_list<std::int64_t> ids) {
  osmium::memory::Buffer buffer{1024, osmium::memory::Buffer::auto_grow::yes};
  for (const std::int64_t id : ids) add_node(buffer, _id(id), _location(1.0, 2.0));
  return buffer;
}

TEST(PendingElements, FreesABufferWithItsLastElement) {
  std::vector<osmium::memory::Buffer> buffers;
  buffers.push_back(buffer_of_nodes({3, 1}));
  buffers.push_back(buffer_of_nodes({2}));
  add_way(buffers.back(), _id(7), _nodes({1, 2}));
  Report report;
  const Elements elements = order_elements(buffers, 1, report);
  PendingElements pending(buffers, elements);
  pending.done(*elements.nodes[0]);
  pending.done(*elements.nodes[1]);
  EXPECT_TRUE(buffers[0]);
  pending.done(*elements.nodes[2]);
  EXPECT_FALSE(buffers[0]);
  EXPECT_TRUE(buffers[1]);
  pending.done(*elements.ways[0]);
  EXPECT_FALSE(buffers[1]);
}

TEST(PendingElements, FreesBuffersOfWhichNothingIsKept) {
  std::vector<osmium::memory::Buffer> buffers;
  buffers.push_back(buffer_of_nodes({1}));
  buffers.push_back(buffer_of_nodes({1}));
  Report report;
  const Elements elements = order_elements(buffers, 1, report);
  ASSERT_EQ(elements.nodes.size(), 1u);
  const PendingElements pending(buffers, elements);
  EXPECT_NE(static_cast<bool>(buffers[0]), static_cast<bool>(buffers[1]));
}

}  // namespace
}  // namespace citykiln::source
