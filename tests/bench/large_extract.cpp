// Writes a large PBF extract: copies of small ones, side by side on a square grid, with ids in the ranges of the
// planet.
//
//     large_extract OUT.osm.pbf COPIES SIDE_M MAP…
//
// Each copy is moved so that its first node lies in a cell of the grid; a copy has the next of the maps. Nodes of all
// copies come before all ways, and ids grow, as in common extracts. Used with `citykiln plan` and `osmium cat` to
// measure memory and speed.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <osmium/builder/osm_object_builder.hpp>
#include <osmium/io/any_input.hpp>
#include <osmium/io/pbf_output.hpp>
#include <osmium/io/writer.hpp>
#include <osmium/osm/object_comparisons.hpp>
#include <string>
#include <unordered_map>
#include <vector>

namespace {

constexpr std::int64_t kLargestId = 10'000'000'000;
constexpr double kWest_deg = 8, kSouth_deg = 47, kMetresPerDegree = 111'200;

struct Map {
  osmium::memory::Buffer buffer;
  std::vector<const osmium::OSMObject*> objects;  // by type, then id
  std::unordered_map<osmium::object_id_type, std::int64_t>
      number[4];  // of an id of a type, from 1, in the order of ids
  osmium::Location first;
};

Map read_map(const std::string& path) {
  Map map{.buffer = osmium::io::read_file(path), .objects = {}, .number = {}, .first = osmium::Location()};
  for (const osmium::OSMObject& object : map.buffer.select<osmium::OSMObject>()) map.objects.push_back(&object);
  std::sort(map.objects.begin(), map.objects.end(), [](const auto* a, const auto* b) {
    return a->type() != b->type() ? a->type() < b->type() : a->id() < b->id();
  });
  for (const osmium::OSMObject* object : map.objects) {
    auto& number = map.number[static_cast<int>(object->type())];
    number.emplace(object->id(), static_cast<std::int64_t>(number.size()) + 1);
    if (object->type() == osmium::item_type::node && !map.first)
      map.first = static_cast<const osmium::Node*>(object)->location();
  }
  return map;
}

/// Where a copy is, and what is added to its ids.
struct Copy {
  double east_deg, north_deg;
  std::int64_t first_id;
};

Copy copy_of(const Map& map, int index, int copies, double side_m) {
  const int columns = static_cast<int>(std::ceil(std::sqrt(copies)));
  const double step_deg = side_m / columns / kMetresPerDegree;
  const double north_deg = kSouth_deg + step_deg * (index / columns + 0.5),
               east_deg = kWest_deg + step_deg * (index % columns + 0.5) / std::cos(kSouth_deg * 3.14159265 / 180);
  return {east_deg - map.first.lon(), north_deg - map.first.lat(), kLargestId / copies * index};
}

std::int64_t id_in(const Map& map, const Copy& copy, osmium::item_type type, osmium::object_id_type id) {
  const auto& number = map.number[static_cast<int>(type)];
  const auto found = number.find(id);
  // ways and relations have fewer and smaller ids than nodes
  const std::int64_t first = type == osmium::item_type::node ? copy.first_id : copy.first_id / 8;
  return first + (found == number.end() ? kLargestId / 100'000 : found->second);
}

template <typename Builder, typename Object>
void add_attributes(Builder& builder, const Object& object, std::int64_t id) {
  builder.set_id(id).set_version(object.version()).set_timestamp(object.timestamp());
  builder.set_changeset(object.changeset()).set_uid(object.uid()).set_visible(true);
  builder.set_user(object.user());
  if (!object.tags().empty()) builder.add_item(object.tags());
}

void add(const osmium::OSMObject& object, const Map& map, const Copy& copy, osmium::memory::Buffer& out) {
  const std::int64_t id = id_in(map, copy, object.type(), object.id());
  if (object.type() == osmium::item_type::node) {
    const osmium::Location at = static_cast<const osmium::Node&>(object).location();
    osmium::builder::NodeBuilder builder(out);
    builder.set_location(osmium::Location(at.lon() + copy.east_deg, at.lat() + copy.north_deg));
    add_attributes(builder, static_cast<const osmium::Node&>(object), id);
  } else if (object.type() == osmium::item_type::way) {
    osmium::builder::WayBuilder builder(out);
    add_attributes(builder, static_cast<const osmium::Way&>(object), id);
    osmium::builder::WayNodeListBuilder nodes(builder);
    for (const osmium::NodeRef& node : static_cast<const osmium::Way&>(object).nodes())
      nodes.add_node_ref(id_in(map, copy, osmium::item_type::node, node.ref()));
  } else {
    osmium::builder::RelationBuilder builder(out);
    add_attributes(builder, static_cast<const osmium::Relation&>(object), id);
    osmium::builder::RelationMemberListBuilder members(builder);
    for (const osmium::RelationMember& each : static_cast<const osmium::Relation&>(object).members())
      members.add_member(each.type(), id_in(map, copy, each.type(), each.ref()), each.role());
  }
  out.commit();
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 5) {
    std::fprintf(stderr, "usage: large_extract OUT.osm.pbf COPIES SIDE_M MAP…\n");
    return 2;
  }
  const int copies = std::atoi(arguments[2]);
  const double side_m = std::atof(arguments[3]), side_deg = side_m / kMetresPerDegree;
  std::vector<Map> maps;
  for (int i = 4; i < count; ++i) maps.push_back(read_map(arguments[i]));
  osmium::io::Header header;
  header.add_box(
      {osmium::Location{kWest_deg, kSouth_deg},
       osmium::Location{kWest_deg + side_deg / std::cos(kSouth_deg * 3.14159265 / 180), kSouth_deg + side_deg}});
  osmium::io::Writer writer(osmium::io::File(arguments[1], "pbf"), header, osmium::io::overwrite::allow);
  for (const osmium::item_type type : {osmium::item_type::node, osmium::item_type::way, osmium::item_type::relation}) {
    for (int i = 0; i < copies; ++i) {
      const Map& map = maps[static_cast<std::size_t>(i) % maps.size()];
      const Copy copy = copy_of(map, i, copies, side_m);
      osmium::memory::Buffer out(1 << 20, osmium::memory::Buffer::auto_grow::yes);
      for (const osmium::OSMObject* object : map.objects)
        if (object->type() == type) add(*object, map, copy, out);
      writer(std::move(out));
    }
  }
  writer.close();
  return 0;
}
