// The living elements of an extract, each once, sorted by id, whatever the order of the file.
#pragma once

#include <osmium/memory/buffer.hpp>
#include <osmium/osm/node.hpp>
#include <osmium/osm/relation.hpp>
#include <osmium/osm/way.hpp>
#include <vector>

#include "compiler/contract/report.h"

namespace citykiln::source {

/// Pointers into the buffers; each sorted by id.
struct Elements {
  std::vector<const osmium::Node*> nodes;  ///< With a valid place.
  std::vector<osmium::Way*> ways;
  std::vector<const osmium::Relation*> relations;
};

/// Sorts the elements, keeps the highest version of each (of equal versions the one with the smaller bytes) and drops
/// deleted ones and nodes without a place. Opens the accounts "source/node", "source/way" and "source/relation": in,
/// merged, dropped. O(n), or O(n log n) if the file is not sorted; 8 bytes an element.
Elements order_elements(std::vector<osmium::memory::Buffer>& buffers, int threads, Report& report);

/// Writes each way node's place into the ways, by the nodes' ids; where the node is missing the place stays invalid.
void locate_way_nodes(const Elements& elements, int threads);

}  // namespace citykiln::source
