#include "compiler/source/order_elements.h"

#include <algorithm>
#include <osmium/osm/object_comparisons.hpp>
#include <string_view>
#include <tuple>
#include <utility>

#include "compiler/contract/system/for_each_slot.h"
#include "compiler/source/closing_ring.h"

namespace citykiln::source {
namespace {

// ways per task: enough to hide the cost of scheduling
constexpr std::size_t kLocatedWaysPerSlot = 512;

OsmId id_of_element(const osmium::OSMObject& object) {
  const OsmType type = object.type() == osmium::item_type::node  ? OsmType::kNode
                       : object.type() == osmium::item_type::way ? OsmType::kWay
                                                                 : OsmType::kRelation;
  return {type, object.id()};
}

std::string_view bytes_of(const osmium::OSMObject& object) {
  return {reinterpret_cast<const char*>(object.data()), object.byte_size()};
}

// How much an element says: its tags, then its nodes or members, or whether it has a place.
std::pair<std::size_t, std::size_t> content_of(const osmium::OSMObject& object) {
  std::size_t parts = 0;
  if (object.type() == osmium::item_type::node)
    parts = static_cast<const osmium::Node&>(object).location().valid();
  else if (object.type() == osmium::item_type::way)
    parts = static_cast<const osmium::Way&>(object).nodes().size();
  else if (object.type() == osmium::item_type::relation)
    parts = static_cast<const osmium::Relation&>(object).members().size();
  return {object.tags().size(), parts};
}

// orders by id; of equal ids the element to keep comes first
bool is_before(const osmium::OSMObject* a, const osmium::OSMObject* b) {
  if (a->id() != b->id()) return a->id() < b->id();
  if (says_more(*a, *b) || says_more(*b, *a)) return says_more(*a, *b);
  return bytes_of(*a) < bytes_of(*b);
}

// Sorts the elements and keeps the first of each id.
template <typename Pointer>
void keep_one_each(std::vector<Pointer>& elements, Account& account, Report& report) {
  const auto not_rising = [](Pointer a, Pointer b) { return a->id() >= b->id(); };
  if (std::adjacent_find(elements.begin(), elements.end(), not_rising) == elements.end()) return;
  std::sort(elements.begin(), elements.end(), is_before);
  const auto same_id = [&](Pointer kept, Pointer next) {
    if (kept->id() != next->id()) return false;
    report.add(Code::kDuplicateElement, id_of_element(*next));
    ++account.merged;
    return true;
  };
  elements.erase(std::unique(elements.begin(), elements.end(), same_id), elements.end());
}

template <typename Pointer>
void drop_deleted(std::vector<Pointer>& elements, Account& account, Report& report) {
  const auto is_deleted = [&](Pointer element) {
    if (!element->deleted()) return false;
    report.drop(account, Code::kDeletedElement, id_of_element(*element));
    return true;
  };
  elements.erase(std::remove_if(elements.begin(), elements.end(), is_deleted), elements.end());
}

void drop_nodes_without_place(std::vector<const osmium::Node*>& nodes, Account& account, Report& report) {
  const auto has_no_place = [&](const osmium::Node* node) {
    if (node->location().valid()) return false;
    report.drop(account, Code::kNodeWithoutPlace, id_of_element(*node));
    return true;
  };
  nodes.erase(std::remove_if(nodes.begin(), nodes.end(), has_no_place), nodes.end());
}

// The elements of one buffer in file order, and what has to be done with them.
struct Collected {
  Elements elements;
  const osmium::OSMObject* first = nullptr;
  const osmium::OSMObject* last = nullptr;
  bool is_sorted = true;
  bool has_losses = false;  // deleted elements or nodes without a place
};

bool is_out_of_order(const osmium::OSMObject& a, const osmium::OSMObject& b) {
  return osmium::object_order_type_id_version{}(b, a);
}

Collected collect(osmium::memory::Buffer& buffer) {
  Collected all;
  for (osmium::OSMObject& object : buffer.select<osmium::OSMObject>()) {
    all.has_losses |= object.deleted();
    if (object.type() == osmium::item_type::node) {
      all.elements.nodes.push_back(static_cast<osmium::Node*>(&object));
      all.has_losses |= !all.elements.nodes.back()->location().valid();
    } else if (object.type() == osmium::item_type::way) {
      all.elements.ways.push_back(static_cast<osmium::Way*>(&object));
    } else if (object.type() == osmium::item_type::relation) {
      all.elements.relations.push_back(static_cast<osmium::Relation*>(&object));
    }
    if (!all.first) all.first = &object;
    if (all.last && is_out_of_order(*all.last, object)) all.is_sorted = false;
    all.last = &object;
  }
  return all;
}

template <typename Pointer>
void append_pointers(const std::vector<Pointer>& more, std::vector<Pointer>& all) {
  all.insert(all.end(), more.begin(), more.end());
}

// Concatenates the buffers. An OSM file is sorted if it lists nodes, ways and relations in turn, each by id.
Collected join(const std::vector<Collected>& parts) {
  Collected all;
  for (const Collected& part : parts) {
    if (!part.first) continue;
    append_pointers(part.elements.nodes, all.elements.nodes);
    append_pointers(part.elements.ways, all.elements.ways);
    append_pointers(part.elements.relations, all.elements.relations);
    all.is_sorted &= part.is_sorted && !(all.last && is_out_of_order(*all.last, *part.first));
    all.has_losses |= part.has_losses;
    all.last = part.last;
  }
  return all;
}

template <typename Pointer>
void clean(std::vector<Pointer>& elements, bool has_losses, Account& account, Report& report) {
  account.in += elements.size();
  keep_one_each(elements, account, report);
  if (has_losses) drop_deleted(elements, account, report);
}

// Node ids and places in contiguous vectors, so that the search does not touch the elements.
struct NodePlaces {
  std::vector<osmium::object_id_type> ids;
  std::vector<osmium::Location> places;
};

NodePlaces places_of(const std::vector<const osmium::Node*>& nodes) {
  NodePlaces result;
  result.ids.reserve(nodes.size());
  result.places.reserve(nodes.size());
  for (const osmium::Node* node : nodes) {
    result.ids.push_back(node->id());
    result.places.push_back(node->location());
  }
  return result;
}

void locate(osmium::Way& way, const NodePlaces& nodes) {
  std::size_t guess = nodes.ids.size();
  for (osmium::NodeRef& node_ref : way.nodes()) {
    // consecutive nodes of a way often have consecutive ids
    if (guess >= nodes.ids.size() || nodes.ids[guess] != node_ref.ref()) {
      guess = static_cast<std::size_t>(std::lower_bound(nodes.ids.begin(), nodes.ids.end(), node_ref.ref()) -
                                       nodes.ids.begin());
    }
    const bool is_there = guess < nodes.ids.size() && nodes.ids[guess] == node_ref.ref();
    node_ref.set_location(is_there ? nodes.places[guess] : osmium::Location{});
    guess += is_there ? 1 : 0;
  }
}

}  // namespace

bool says_more(const osmium::OSMObject& a, const osmium::OSMObject& b) {
  return std::tuple(a.version(), content_of(a)) > std::tuple(b.version(), content_of(b));
}

Elements order_elements(std::vector<osmium::memory::Buffer>& buffers, int threads, Report& report) {
  auto [elements, first, last, is_sorted, has_losses] =
      join(for_each_slot<Collected>(buffers.size(), threads, [&](std::size_t i) { return collect(buffers[i]); }));
  if (!is_sorted) report.add(Code::kUnsortedFile, OsmId{});
  Account& node_account = report.account("source", "node");
  clean(elements.nodes, has_losses, node_account, report);
  if (has_losses) drop_nodes_without_place(elements.nodes, node_account, report);
  node_account.out += elements.nodes.size();
  Account& way_account = report.account("source", "way");
  clean(elements.ways, has_losses, way_account, report);
  way_account.in -= static_cast<std::uint64_t>(
      std::ranges::count_if(elements.ways, [](const osmium::Way* way) { return is_closing_ring(*way); }));
  clean(elements.relations, has_losses, report.account("source", "relation"), report);
  return std::move(elements);
}

void locate_way_nodes(const Elements& elements, int threads) {
  const NodePlaces nodes = places_of(elements.nodes);
  const std::size_t slots = (elements.ways.size() + kLocatedWaysPerSlot - 1) / kLocatedWaysPerSlot;
  for_each_index(slots, threads, [&](std::size_t slot) {
    const std::size_t end = std::min(elements.ways.size(), (slot + 1) * kLocatedWaysPerSlot);
    for (std::size_t i = slot * kLocatedWaysPerSlot; i < end; ++i) locate(*elements.ways[i], nodes);
  });
}

}  // namespace citykiln::source
