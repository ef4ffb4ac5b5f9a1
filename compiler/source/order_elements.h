// Sorts the elements of an extract by id and removes duplicates and deleted elements.
#pragma once

#include <osmium/memory/buffer.hpp>
#include <osmium/osm/node.hpp>
#include <osmium/osm/relation.hpp>
#include <osmium/osm/way.hpp>
#include <vector>

#include "compiler/contract/findings/report.h"

namespace citykiln::source {

/// Pointers to the elements in libosmium's buffers, each vector sorted by id.
struct Elements {
  std::vector<const osmium::Node*> nodes;  ///< With a valid location.
  std::vector<osmium::Way*> ways;
  std::vector<const osmium::Relation*> relations;
};

/// Sorts the elements and keeps the highest version of each; of equal versions the one with more
/// tags, then with more nodes or members, then with the smaller bytes. Drops
/// deleted elements, and nodes without a location. Opens the ledger accounts "source/node", "source/way" and
/// "source/relation". O(n), or O(n log n) for unsorted files. Memory: 8 bytes per element.
Elements order_elements(std::vector<osmium::memory::Buffer>& buffers, int threads, Report& report);

/// True if, of two elements with one id, the first is kept for its version or for what it says.
bool says_more(const osmium::OSMObject& a, const osmium::OSMObject& b);

/// Looks up the nodes of each way by id and writes their locations into the way. Locations of missing nodes stay
/// invalid.
void locate_way_nodes(const Elements& elements, int threads);

}  // namespace citykiln::source
