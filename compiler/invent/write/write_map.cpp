#include "compiler/invent/write/write_map.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <map>
#include <osmium/builder/attr.hpp>
#include <osmium/io/pbf_output.hpp>
#include <osmium/io/writer.hpp>
#include <osmium/memory/buffer.hpp>
#include <unordered_map>
#include <vector>

namespace citykiln::invent {
namespace {

using NodeRefs = std::vector<osmium::object_id_type>;

struct MapNode {
  MapPlace place;
  Tags tags;
};

struct MapWay {
  NodeRefs nodes;
  const Tags* tags = nullptr;  ///< Null for rings of multipolygons.
};

struct MapRelation {
  std::vector<std::pair<osmium::object_id_type, const char*>> members;
  const Tags* tags = nullptr;
};

struct PlaceHash {
  std::size_t operator()(MapPlace p) const {
    const auto bits =
        static_cast<std::uint64_t>(static_cast<std::uint32_t>(p.lon)) << 32 | static_cast<std::uint32_t>(p.lat);
    return static_cast<std::size_t>(bits * 0x9e3779b97f4a7c15U >> 8);
  }
};

/// Collects nodes, ways and relations, whose ids are their places in the lists, from 1.
class Elements {
 public:
  explicit Elements(const WorldPlace& place) : place_(place) {}

  void add(const InventedPoint& point) {
    MapNode& node = nodes_[node_at(point.position) - 1];
    // two points of one place are one node, which has each key once
    for (const auto& tag : point.tags)
      if (std::ranges::find(node.tags, tag.first, &Tags::value_type::first) == node.tags.end())
        node.tags.push_back(tag);
    std::ranges::sort(node.tags);
  }

  void add(const InventedLine& line) {
    NodeRefs nodes = nodes_of(line.axis);
    if (nodes.size() >= 2) ways_.push_back({std::move(nodes), &line.tags});
  }

  void add(const InventedArea& area) {
    if (area.polygon.holes.empty()) {
      add_ring(area.polygon.outer, &area.tags);
      return;
    }
    MapRelation relation{{}, &area.tags};
    for (const Ring* ring : rings_of(area.polygon))
      if (add_ring(*ring, nullptr))
        relation.members.emplace_back(ways_.size(), ring == &area.polygon.outer ? "outer" : "inner");
    if (!relation.members.empty()) relations_.push_back(std::move(relation));
  }

  const std::vector<MapNode>& nodes() const { return nodes_; }
  const std::vector<MapWay>& ways() const { return ways_; }
  const std::vector<MapRelation>& relations() const { return relations_; }

 private:
  osmium::object_id_type node_at(Vec2 p) {
    const MapPlace place = place_.map_place_of(p);
    const auto [found, is_new] = ids_.try_emplace(place, static_cast<osmium::object_id_type>(nodes_.size() + 1));
    if (is_new) nodes_.push_back({place, {}});
    return found->second;
  }

  NodeRefs nodes_of(const Polyline& axis) {
    NodeRefs nodes;
    for (const Vec2 p : axis) {
      const auto node = node_at(p);
      if (nodes.empty() || nodes.back() != node) nodes.push_back(node);
    }
    return nodes;
  }

  bool add_ring(const Ring& ring, const Tags* tags) {
    NodeRefs nodes = nodes_of(ring);
    while (nodes.size() > 1 && nodes.front() == nodes.back()) nodes.pop_back();
    if (nodes.size() < 3) return false;
    nodes.push_back(nodes.front());
    ways_.push_back({std::move(nodes), tags});
    return true;
  }

  const WorldPlace& place_;
  std::unordered_map<MapPlace, osmium::object_id_type, PlaceHash> ids_;
  std::vector<MapNode> nodes_;
  std::vector<MapWay> ways_;
  std::vector<MapRelation> relations_;
};

/// Writes elements in the order in which they are given.
class PbfWriter {
 public:
  PbfWriter(const std::string& path, const std::array<MapPlace, 2>& box)
      : writer_(osmium::io::File(path, "pbf,add_metadata=version"), header_of(box), osmium::io::overwrite::allow) {}

  void write(osmium::object_id_type id, const MapNode& node) {
    using namespace osmium::builder::attr;
    osmium::builder::add_node(buffer_, _id(id), _version(1),
                              _location(osmium::Location{node.place.lon, node.place.lat}), _tags(node.tags));
    flush_if_full();
  }

  void write(osmium::object_id_type id, const MapWay& way) {
    using namespace osmium::builder::attr;
    osmium::builder::add_way(buffer_, _id(id), _version(1), _nodes(way.nodes), _tags(way.tags ? *way.tags : kNoTags));
    flush_if_full();
  }

  void write(osmium::object_id_type id, const MapRelation& relation) {
    using namespace osmium::builder::attr;
    Tags tags = *relation.tags;
    tags.emplace_back("type", "multipolygon");
    std::vector<member_type> members;
    for (const auto& [way, role] : relation.members) members.emplace_back(osmium::item_type::way, way, role);
    osmium::builder::add_relation(buffer_, _id(id), _version(1), _members(members), _tags(tags));
    flush_if_full();
  }

  void close() {
    flush();
    writer_.close();
  }

 private:
  inline static const Tags kNoTags;

  static osmium::io::Header header_of(const std::array<MapPlace, 2>& box) {
    osmium::io::Header header;
    header.set("generator", "citykiln invent");
    header.add_box({osmium::Location{box[0].lon, box[0].lat}, osmium::Location{box[1].lon, box[1].lat}});
    return header;
  }

  void flush_if_full() {
    if (buffer_.committed() > (std::size_t{1} << 20)) flush();
  }
  void flush() {
    osmium::memory::Buffer full(std::size_t{1} << 21, osmium::memory::Buffer::auto_grow::yes);
    std::swap(full, buffer_);
    writer_(std::move(full));
  }

  osmium::memory::Buffer buffer_{std::size_t{1} << 21, osmium::memory::Buffer::auto_grow::yes};
  osmium::io::Writer writer_;
};

template <typename List>
void write_all(const List& list, PbfWriter& writer) {
  for (std::size_t i = 0; i < list.size(); ++i) writer.write(static_cast<osmium::object_id_type>(i + 1), list[i]);
}

}  // namespace

Result<MapCounts> write_map(const InventedMap& map, const WorldPlace& place, double side_m, const std::string& path) {
  Elements elements(place);
  for (const InventedPoint& point : map.points) elements.add(point);
  for (const InventedLine& line : map.lines) elements.add(line);
  for (const InventedArea& area : map.areas) elements.add(area);
  const std::string part = path + ".part";
  std::error_code none;
  try {
    PbfWriter writer(part, place.box_inside(side_m));
    write_all(elements.nodes(), writer);
    write_all(elements.ways(), writer);
    write_all(elements.relations(), writer);
    writer.close();
    std::filesystem::rename(part, path);
  } catch (const std::exception& problem) {
    std::filesystem::remove(part, none);
    return Error{path, std::string("cannot be written: ") + problem.what()};
  }
  return MapCounts{elements.nodes().size(), elements.ways().size(), elements.relations().size()};
}

}  // namespace citykiln::invent
