// The index of places is libosmium's SparseFileArray: pairs of id and place in the order of the file, mapped into
// memory and searched by bisection.
#include "compiler/regions/cut_extract.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <osmium/handler/node_locations_for_ways.hpp>
#include <osmium/index/map/sparse_file_array.hpp>
#include <osmium/io/bzip2_compression.hpp>
#include <osmium/io/gzip_compression.hpp>
#include <osmium/io/pbf_input.hpp>
#include <osmium/io/pbf_output.hpp>
#include <osmium/io/reader.hpp>
#include <osmium/io/writer.hpp>
#include <osmium/io/xml_input.hpp>
#include <osmium/osm/object_comparisons.hpp>
#include <osmium/thread/pool.hpp>
#include <span>
#include <utility>

#include "compiler/contract/erase_repeated.h"
#include "compiler/regions/area_tags.h"
#include "compiler/regions/edit_watch.h"
#include "compiler/regions/spool.h"
#include "compiler/source/areas/close_cut_areas.h"
#include "compiler/source/closing_ring.h"
#include "compiler/source/format/mended_xml.h"
#include "compiler/source/format/osm_format.h"
#include "compiler/source/format/plain_words.h"

namespace citykiln::regions {

Vec2 place_near(const map::Plane& plane, const source::LonLatBox& extent, double lon, double lat) {
  constexpr double kNear_deg = 1;
  return plane.forward({std::clamp(lon, extent.west - kNear_deg, extent.east + kNear_deg),
                        std::clamp(lat, extent.south - kNear_deg, extent.north + kNear_deg)});
}

namespace {

namespace fs = std::filesystem;
namespace bits = osmium::osm_entity_bits;
using PlaceIndex = osmium::index::map::SparseFileArray<osmium::unsigned_object_id_type, osmium::Location>;
using PlacesForWays = osmium::handler::NodeLocationsForWays<PlaceIndex>;

osmium::io::File file_of(const std::string& path) { return osmium::io::File(fs::absolute(path).string()); }

// The map, or a file in `folder` that stands for it where libosmium cannot read it as it is meant. The passes read it
// several times, from the disk.
Result<std::string> readable_map(const std::string& map_path, source::OsmFormat format, const std::string& folder) {
  const Result<std::optional<std::string>> mended = source::mended_file(map_path, format);
  if (!mended) return mended.error();
  if (!*mended) return map_path;
  const std::string path = folder + (format == source::OsmFormat::kPbf ? "/.mended.osm.pbf" : "/.mended.osm");
  std::ofstream file(path, std::ios::binary);
  file << **mended;
  if (!file.flush()) return Error{path, "cannot be written"};
  return path;
}

template <typename Object>
void for_each(const std::string& path, bits::type what, osmium::thread::Pool& pool,
              const std::function<void(Object&)>& visit) {
  osmium::io::Reader reader(file_of(path), what, pool);
  while (osmium::memory::Buffer buffer = reader.read()) {
    source::make_words_plain(buffer);
    for (Object& object : buffer.select<Object>()) visit(object);
  }
  reader.close();
}

/// Opens a file in a folder for reading and writing. It is closed when the process ends.
int open_index(const std::string& folder) {
  const std::string path = folder + "/places";
  return ::open(path.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
}

/// A way that is a member of an area.
struct MemberWay {
  Box2 box;
  Vec2 first, last;  ///< The places of its first and last node that have one.
  bool describes_water = false;
};

/// The elements that a relation needs in the file of a region.
struct RelationContents {
  Box2 box;
  std::vector<std::uint32_t> ways;               ///< Indices in members_.
  std::vector<const osmium::OSMObject*> others;  ///< Areas that are members, and closing rings.
  bool has_water_ways = false;
};

class Cutter {
 public:
  Cutter(const CutRequest& cut, const map::Plane& plane, const RegionGrid& grid)
      : cut_(cut),
        plane_(plane),
        grid_(grid),
        keys_(regions_of(grid)),
        spools_(cut.folder + "/.cut", keys_.size() + 2),
        edits_(cut.edits),
        water_margin_m_(kCoastMargin_m + (cut.edits ? edits::longest_move_m(*cut.edits) : 0)),
        pool_(cut.threads > 0 ? cut.threads : 2) {}

  Result<CutFiles> run();

 private:
  // the spools after those of the regions
  std::size_t survey() const { return keys_.size(); }
  std::size_t coasts() const { return keys_.size() + 1; }

  void find_members();
  void find_nested_areas(std::vector<osmium::object_id_type> ids);
  Result<Done> spool_nodes_and_ways();
  void spool_node(const osmium::Node& node);
  void spool_way(const osmium::Way& way);
  /// Closes the areas that are cut by the box of the map, as read_osm() does with a whole map.
  void close_areas();
  std::optional<source::LocationBox> box_of_map() const;
  bool is_incomplete(const osmium::Relation& relation) const;
  osmium::memory::Buffer incomplete_relations();
  osmium::memory::Buffer ways_of_relations(const osmium::memory::Buffer& relations);
  std::vector<source::CutArea> find_cut_areas(const osmium::memory::Buffer& relations,
                                              const osmium::memory::Buffer& ways, const source::LocationBox& box) const;
  void collect_evidence(std::vector<source::CutArea>& areas);
  void index_closed();
  const osmium::Relation& closed_or_same(const osmium::Relation& relation) const;
  std::vector<const osmium::Way*> closing_rings_of(const osmium::Relation& relation) const;
  void collect(const osmium::Relation& relation, RelationContents& contents) const;
  void spool_relations();
  void spool_relation(const osmium::Relation& relation);
  void spool_members();
  void count(const osmium::OSMObject& object);
  std::uint32_t owner(Vec2 place) const;

  Vec2 in_plane(osmium::Location place) const;
  Box2 in_degrees(const Box2& box) const;
  /// Projects the nodes of a way that have places. Call it once per way, since projecting takes more time than all
  /// else.
  const std::vector<Vec2>& projected(const osmium::Way& way);
  std::vector<std::uint32_t> spools_of(const osmium::Way& way, std::span<const Vec2> line, const Box2& box,
                                       EditedAs edited) const;
  /// Returns the index of a way's id in members_; members_.size() if it is not there.
  std::size_t member(osmium::object_id_type id) const;

  /// Writes the elements of spools to a file. @param own  The region without its halo, in the plane.
  Result<RegionFile> write(const std::string& name, std::vector<std::size_t> spools, const Box2& own);

  const CutRequest& cut_;
  const map::Plane& plane_;
  const RegionGrid& grid_;
  std::vector<RegionKey> keys_;
  Spools spools_;
  EditWatch edits_;
  double water_margin_m_;
  osmium::thread::Pool pool_;
  std::vector<Vec2> line_;                                            // the projected nodes of the current way
  std::vector<osmium::object_id_type> members_;                       // sorted ids
  std::vector<MemberWay> member_ways_;                                // by index in members_
  std::vector<std::pair<std::uint32_t, std::uint32_t>> has_, wants_;  // member, spool
  std::unique_ptr<PlaceIndex> places_;
  osmium::memory::Buffer nested_{64 * 1024, osmium::memory::Buffer::auto_grow::yes};  // areas that are members
  std::map<osmium::object_id_type, const osmium::Relation*> nested_areas_;            // in nested_
  Box2 node_box_;                                                                     // of all nodes, in degrees
  osmium::memory::Buffer closed_{64 * 1024, osmium::memory::Buffer::auto_grow::yes};  // areas that were closed
  std::map<osmium::object_id_type, const osmium::Relation*> closed_areas_;            // in closed_
  std::map<osmium::object_id_type, const osmium::Way*> closing_rings_;                // in closed_
  Report report_;
};

std::size_t Cutter::member(osmium::object_id_type id) const {
  const auto found = std::ranges::lower_bound(members_, id);
  return found != members_.end() && *found == id ? static_cast<std::size_t>(found - members_.begin()) : members_.size();
}

Vec2 Cutter::in_plane(osmium::Location place) const {
  return place_near(plane_, cut_.extent, place.lon(), place.lat());
}

Box2 Cutter::in_degrees(const Box2& box) const {
  Box2 degrees;
  for (const Vec2 corner : {box.min, box.max}) {
    const LonLat place = plane_.backward(corner);
    degrees.grow({place.lon_deg, place.lat_deg});
  }
  return degrees;
}

const std::vector<Vec2>& Cutter::projected(const osmium::Way& way) {
  line_.clear();
  for (const osmium::NodeRef& node : way.nodes())
    if (node.location().valid()) line_.push_back(in_plane(node.location()));
  return line_;
}

// The spool of the region that owns a place.
std::uint32_t Cutter::owner(Vec2 place) const {
  return static_cast<std::uint32_t>(std::ranges::lower_bound(keys_, owner_of(grid_, place)) - keys_.begin());
}

std::vector<std::uint32_t> Cutter::spools_of(const osmium::Way& way, std::span<const Vec2> line, const Box2& box,
                                             EditedAs edited) const {
  std::vector<std::uint32_t> spools;
  const auto add = [&](std::uint32_t region) { spools.push_back(region); };
  if (line.empty()) return spools;
  if (line.size() == 1 || (way.is_closed() && (edited != EditedAs::kSame || describes_area(way.tags()))))
    for_each_region_near(grid_, box, add);
  else
    for (std::size_t i = 1; i < line.size(); ++i) {
      Box2 segment;
      segment.grow(line[i - 1]), segment.grow(line[i]);
      for_each_region_near(grid_, segment, add);
    }
  if (!spools.empty()) spools.push_back(owner(line.front()));
  const bool is_coast = edited == EditedAs::kCoastline || is_coastline(way.tags());
  const bool is_water = edited != EditedAs::kSame || describes_water(way.tags());
  if (is_water && box.touches(grid_.extent.widened(water_margin_m_)))
    spools.push_back(static_cast<std::uint32_t>(is_coast ? coasts() : survey()));
  sort_unique(spools);
  return spools;
}

// Counts an element in the accounts that read_osm() uses, except that duplicates count as well.
void Cutter::count(const osmium::OSMObject& object) {
  const bool is_node = object.type() == osmium::item_type::node, is_way = object.type() == osmium::item_type::way;
  Account& account = report_.account("source", is_node ? "node" : is_way ? "way" : "relation");
  ++account.in;
  const auto has_place = [](const osmium::NodeRef& node) { return node.location().valid(); };
  if (object.deleted())
    ++account.dropped[Code::kDeletedElement];
  else if (is_node && !static_cast<const osmium::Node&>(object).location().valid())
    ++account.dropped[Code::kNodeWithoutPlace];
  else if (is_way && std::ranges::count_if(static_cast<const osmium::Way&>(object).nodes(), has_place) < 2)
    ++account.dropped[Code::kWayTooShort];
  else if (!is_node && !is_way && object.tags().empty())
    ++account.dropped[Code::kRelationWithoutTags];
  else
    ++account.out;
}

void Cutter::find_members() {
  std::vector<osmium::object_id_type> nested;
  for_each<osmium::Relation>(cut_.map_path, bits::relation, pool_, [&](const osmium::Relation& relation) {
    count(relation);
    if (!is_kept_with_members(relation.tags())) return;
    for (const osmium::RelationMember& each : relation.members())
      if (each.type() == osmium::item_type::way)
        members_.push_back(each.ref());
      else if (each.type() == osmium::item_type::relation)
        nested.push_back(each.ref());
  });
  sort_unique(members_), sort_unique(nested);
  member_ways_.resize(members_.size());
  if (!nested.empty()) find_nested_areas(std::move(nested));
}

void Cutter::find_nested_areas(std::vector<osmium::object_id_type> ids) {
  for_each<osmium::Relation>(cut_.map_path, bits::relation, pool_, [&](const osmium::Relation& relation) {
    if (relation.deleted() || !is_area_relation(relation.tags()) || !std::ranges::binary_search(ids, relation.id()))
      return;
    nested_.add_item(relation);
    nested_.commit();
  });
  for (const osmium::Relation& relation : nested_.select<osmium::Relation>()) {
    const osmium::Relation*& known = nested_areas_[relation.id()];
    if (known == nullptr || source::says_more(relation, *known)) known = &relation;
  }
}

void Cutter::spool_node(const osmium::Node& node) {
  if (node.deleted() || !node.location().valid()) return;
  node_box_.grow({node.location().lon_without_check(), node.location().lat_without_check()});
  edits_.see(node);
  if (node.tags().empty()) return;
  Box2 box;
  box.grow(in_plane(node.location()));
  for_each_region_near(grid_, box, [&](std::uint32_t region) { spools_.add(region, node); });
}

void Cutter::spool_way(const osmium::Way& way) {
  const std::vector<Vec2>& line = projected(way);
  Box2 box;
  for (const Vec2 at : line) box.grow(at);
  const EditedAs edited = edits_.see(way);
  const std::vector<std::uint32_t> spools = spools_of(way, line, box, edited);
  for (const std::uint32_t spool : spools) spools_.add(spool, way);
  const std::size_t index = member(way.id());
  if (index == members_.size()) return;
  member_ways_[index] = {box, line.empty() ? Vec2{} : line.front(), line.empty() ? Vec2{} : line.back(),
                         edited != EditedAs::kSame || describes_water(way.tags())};
  for (const std::uint32_t spool : spools) has_.emplace_back(static_cast<std::uint32_t>(index), spool);
}

Result<Done> Cutter::spool_nodes_and_ways() {
  const int file = open_index(cut_.folder + "/.cut");
  if (file < 0) return Error{cut_.folder, "cannot be written"};
  places_ = std::make_unique<PlaceIndex>(file);
  PlacesForWays places(*places_);
  places.ignore_errors();
  osmium::io::Reader reader(file_of(cut_.map_path), bits::node | bits::way, pool_);
  bool has_ways = false;
  while (osmium::memory::Buffer buffer = reader.read()) {
    source::make_words_plain(buffer);
    for (osmium::OSMObject& object : buffer.select<osmium::OSMObject>()) {
      if (object.type() == osmium::item_type::node) {
        if (has_ways) return Error{cut_.map_path, "expected nodes before ways; sort the file with `osmium sort`"};
        count(object);
        if (!object.deleted()) places.node(static_cast<osmium::Node&>(object));
        spool_node(static_cast<osmium::Node&>(object));
      } else {
        has_ways = true;
        places.way(static_cast<osmium::Way&>(object));
        count(object);
        spool_way(static_cast<osmium::Way&>(object));
      }
    }
  }
  reader.close();
  return Done{};
}

std::optional<source::LocationBox> Cutter::box_of_map() const {
  osmium::io::Reader reader(file_of(cut_.map_path), bits::nothing);
  const osmium::Box box = reader.header().joined_boxes();
  reader.close();
  if (!box.valid() && node_box_.is_empty()) return std::nullopt;
  if (!box.valid()) return source::location_box({node_box_.min.x, node_box_.min.y, node_box_.max.x, node_box_.max.y});
  return source::location_box(
      {box.bottom_left().lon(), box.bottom_left().lat(), box.top_right().lon(), box.top_right().lat()});
}

// True if a member way is missing, or a line of the members ends at a place where none begins.
bool Cutter::is_incomplete(const osmium::Relation& relation) const {
  std::vector<std::pair<double, double>> ends;
  for (const osmium::RelationMember& each : relation.members()) {
    const std::size_t index = each.type() == osmium::item_type::way ? member(each.ref()) : members_.size();
    if (index == members_.size()) continue;
    if (member_ways_[index].box.is_empty()) return true;
    for (const Vec2 end : {member_ways_[index].first, member_ways_[index].last}) ends.emplace_back(end.x, end.y);
  }
  std::ranges::sort(ends);
  for (std::size_t i = 0; i < ends.size(); i += 2)
    if (i + 1 == ends.size() || ends[i] != ends[i + 1]) return true;
  return false;
}

osmium::memory::Buffer Cutter::incomplete_relations() {
  osmium::memory::Buffer found(64 * 1024, osmium::memory::Buffer::auto_grow::yes);
  for_each<osmium::Relation>(cut_.map_path, bits::relation, pool_, [&](const osmium::Relation& relation) {
    if (relation.deleted() || !source::cut_area_kind(relation.tags()) || !is_incomplete(relation)) return;
    found.add_item(relation);
    found.commit();
  });
  return found;
}

osmium::memory::Buffer Cutter::ways_of_relations(const osmium::memory::Buffer& relations) {
  std::vector<osmium::object_id_type> wanted;
  for (const osmium::Relation& relation : relations.select<osmium::Relation>())
    for (const osmium::RelationMember& each : relation.members())
      if (each.type() == osmium::item_type::way) wanted.push_back(each.ref());
  sort_unique(wanted);
  osmium::memory::Buffer found(64 * 1024, osmium::memory::Buffer::auto_grow::yes);
  PlacesForWays places(*places_);
  places.ignore_errors();
  for_each<osmium::Way>(cut_.map_path, bits::way, pool_, [&](osmium::Way& way) {
    if (way.deleted() || !std::ranges::binary_search(wanted, way.id())) return;
    places.way(way);
    found.add_item(way);
    found.commit();
  });
  return found;
}

std::vector<source::CutArea> Cutter::find_cut_areas(const osmium::memory::Buffer& relations,
                                                    const osmium::memory::Buffer& ways,
                                                    const source::LocationBox& box) const {
  std::map<osmium::object_id_type, const osmium::Way*> way_by_id;
  for (const osmium::Way& way : ways.select<osmium::Way>()) way_by_id[way.id()] = &way;
  std::vector<source::CutArea> areas;
  for (const osmium::Relation& relation : relations.select<osmium::Relation>()) {
    std::vector<const osmium::Way*> members;
    for (const osmium::RelationMember& each : relation.members()) {
      const auto way = each.type() == osmium::item_type::way ? way_by_id.find(each.ref()) : way_by_id.end();
      members.push_back(way == way_by_id.end() ? nullptr : way->second);
    }
    if (std::optional<source::CutArea> area = source::cut_area_of(relation, members, box))
      areas.push_back(std::move(*area));
  }
  return areas;
}

void Cutter::collect_evidence(std::vector<source::CutArea>& areas) {
  PlacesForWays places(*places_);
  places.ignore_errors();
  for_each<osmium::Way>(cut_.map_path, bits::way, pool_, [&](osmium::Way& way) {
    if (way.deleted() || way.tags().empty()) return;
    places.way(way);
    for (source::CutArea& area : areas) source::add_evidence(way, area);
  });
}

void Cutter::index_closed() {
  for (const osmium::OSMObject& object : closed_.select<osmium::OSMObject>())
    if (object.type() == osmium::item_type::way)
      closing_rings_[object.id()] = static_cast<const osmium::Way*>(&object);
    else
      closed_areas_[object.id()] = static_cast<const osmium::Relation*>(&object);
}

void Cutter::close_areas() {
  const std::optional<source::LocationBox> box = box_of_map();
  if (!box) return;
  const osmium::memory::Buffer relations = incomplete_relations();
  if (relations.committed() == 0) return;
  const osmium::memory::Buffer ways = ways_of_relations(relations);
  std::vector<source::CutArea> areas = find_cut_areas(relations, ways, *box);
  if (areas.empty()) return;
  collect_evidence(areas);
  std::int64_t next_ring = source::kFirstClosingRing;
  for (const source::CutArea& area : areas) source::add_closed(area, next_ring, closed_);
  index_closed();
}

const osmium::Relation& Cutter::closed_or_same(const osmium::Relation& relation) const {
  const auto closed = closed_areas_.find(relation.id());
  return closed == closed_areas_.end() ? relation : *closed->second;
}

std::vector<const osmium::Way*> Cutter::closing_rings_of(const osmium::Relation& relation) const {
  std::vector<const osmium::Way*> rings;
  for (const osmium::RelationMember& each : relation.members())
    if (source::is_closing_ring(each)) rings.push_back(closing_rings_.at(each.ref()));
  return rings;
}

// Adds the members of an area, its closing rings, and their box.
void Cutter::collect(const osmium::Relation& relation, RelationContents& contents) const {
  for (const osmium::RelationMember& each : relation.members()) {
    const std::size_t index = each.type() == osmium::item_type::way ? member(each.ref()) : members_.size();
    if (index == members_.size() || member_ways_[index].box.is_empty()) continue;
    const MemberWay& way = member_ways_[index];
    contents.ways.push_back(static_cast<std::uint32_t>(index));
    contents.box.grow(way.box.min), contents.box.grow(way.box.max);
    contents.has_water_ways = contents.has_water_ways || way.describes_water;
  }
  for (const osmium::Way* ring : closing_rings_of(relation)) {
    contents.others.push_back(ring);
    for (const osmium::NodeRef& node : ring->nodes()) contents.box.grow(in_plane(node.location()));
  }
}

void Cutter::spool_relation(const osmium::Relation& relation) {
  RelationContents contents;
  collect(relation, contents);
  for (const osmium::RelationMember& each : relation.members()) {
    const auto nested = nested_areas_.find(each.ref());
    if (each.type() != osmium::item_type::relation || nested == nested_areas_.end()) continue;
    contents.others.push_back(&closed_or_same(*nested->second));
    collect(closed_or_same(*nested->second), contents);
  }
  if (contents.box.is_empty()) return;
  std::vector<std::uint32_t> spools;
  for_each_region_near(grid_, contents.box, [&](std::uint32_t region) { spools.push_back(region); });
  if (!spools.empty() && !contents.ways.empty()) spools.push_back(owner(member_ways_[contents.ways.front()].first));
  sort_unique(spools);
  // a relation without tags of its own can have the tags of its outer ways
  const bool is_water = edits_.see(relation) != EditedAs::kSame || describes_water(relation.tags()) ||
                        (!describes_area(relation.tags()) && contents.has_water_ways);
  if (is_water && contents.box.touches(grid_.extent.widened(water_margin_m_)))
    spools.push_back(static_cast<std::uint32_t>(survey()));
  for (const std::uint32_t spool : spools) {
    spools_.add(spool, relation);
    for (const std::uint32_t way : contents.ways) wants_.emplace_back(way, spool);
    for (const osmium::OSMObject* other : contents.others) spools_.add(spool, *other);
  }
}

void Cutter::spool_relations() {
  for_each<osmium::Relation>(cut_.map_path, bits::relation, pool_, [&](const osmium::Relation& relation) {
    if (is_kept_with_members(relation.tags()))
      spool_relation(closed_or_same(relation));
    else
      edits_.see(relation);
  });
}

void Cutter::spool_members() {
  sort_unique(has_), sort_unique(wants_);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> missing;
  std::ranges::set_difference(wants_, has_, std::back_inserter(missing));
  if (missing.empty()) return;
  PlacesForWays places(*places_);
  places.ignore_errors();
  for_each<osmium::Way>(cut_.map_path, bits::way, pool_, [&](osmium::Way& way) {
    const std::size_t index = member(way.id());
    if (index == members_.size()) return;
    auto wanted = std::ranges::lower_bound(missing, std::pair(static_cast<std::uint32_t>(index), std::uint32_t{0}));
    if (wanted == missing.end() || wanted->first != index) return;
    places.way(way);
    for (; wanted != missing.end() && wanted->first == index; ++wanted) spools_.add(wanted->second, way);
  });
}

/// Orders elements by type and id; of equal ids the one to keep comes first.
bool is_before(const osmium::OSMObject* a, const osmium::OSMObject* b) {
  if (a->type() != b->type()) return a->type() < b->type();
  if (a->id() != b->id()) return a->id() < b->id();
  return source::says_more(*a, *b);
}

bool is_same(const osmium::OSMObject* a, const osmium::OSMObject* b) {
  return a->type() == b->type() && a->id() == b->id();
}

bool has_equal_bytes(const std::string& a, const std::string& b) {
  std::error_code none;
  if (!fs::exists(b, none) || fs::file_size(a, none) != fs::file_size(b, none)) return false;
  std::ifstream one(a, std::ios::binary), other(b, std::ios::binary);
  return std::equal(std::istreambuf_iterator<char>(one), {}, std::istreambuf_iterator<char>(other));
}

Result<RegionFile> Cutter::write(const std::string& name, std::vector<std::size_t> spools, const Box2& own) {
  std::vector<osmium::memory::Buffer> buffers;
  std::vector<const osmium::OSMObject*> objects;
  for (const std::size_t spool : spools) {
    Result<osmium::memory::Buffer> buffer = spools_.read(spool);
    if (!buffer) return buffer.error();
    buffers.push_back(std::move(*buffer));
    for (const osmium::OSMObject& object : buffers.back().select<osmium::OSMObject>()) objects.push_back(&object);
  }
  std::ranges::stable_sort(objects, is_before);
  objects.erase(std::unique(objects.begin(), objects.end(), is_same), objects.end());
  std::erase_if(objects, [](const osmium::OSMObject* object) { return object->deleted(); });

  const std::string path = cut_.folder + "/" + name, part = path + ".part";
  osmium::io::File file(part, "pbf");
  file.set("locations_on_ways", true);
  file.set("add_metadata", false);
  osmium::io::Header header;
  header.set("generator", source::kGeneratorOfRegions);
  header.add_box(
      {osmium::Location{cut_.extent.west, cut_.extent.south}, osmium::Location{cut_.extent.east, cut_.extent.north}});
  osmium::io::Writer writer(file, header, osmium::io::overwrite::allow, pool_);
  for (const osmium::OSMObject* object : objects) writer(*object);
  writer.close();
  RegionFile written = contents_of(objects, in_degrees(own), own.width() * own.height());
  written.bytes = fs::file_size(part);
  if (has_equal_bytes(part, path))
    fs::remove(part);
  else
    fs::rename(part, path);
  return written;
}

Result<CutFiles> Cutter::run() {
  fs::remove_all(cut_.folder + "/.cut");
  fs::create_directory(cut_.folder + "/.cut");
  for (const char* kind : {"node", "way", "relation"}) report_.account("source", kind);
  find_members();
  if (const Result<Done> done = spool_nodes_and_ways(); !done) return done.error();
  close_areas();
  spool_relations();
  spool_members();
  if (const Result<Done> done = spools_.flush(); !done) return done.error();
  CutFiles files;
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    const Result<RegionFile> file =
        write(to_string(keys_[i]) + ".osm.pbf", {i, coasts()}, regions::box_of(grid_, keys_[i]));
    if (!file) return file.error();
    files.regions.push_back(*file);
  }
  const Result<RegionFile> file = write("survey.osm.pbf", {survey(), coasts()}, grid_.extent);
  if (!file) return file.error();
  files.survey = *file;
  files.edits_had_effect = edits_.had_effect();
  files.report = std::move(report_);
  places_.reset();
  spools_.remove();
  return files;
}

}  // namespace

Result<CutFiles> cut_extract(const CutRequest& cut, const map::Plane& plane, const RegionGrid& grid) {
  const Result<source::OsmFormat> format = source::osm_format_of(cut.map_path);
  if (!format) return format.error();
  try {
    const Result<std::string> path = readable_map(cut.map_path, *format, cut.folder);
    if (!path) return path.error();
    CutRequest readable = cut;
    readable.map_path = *path;
    Result<CutFiles> files = Cutter(readable, plane, grid).run();
    if (*path != cut.map_path) fs::remove(*path);
    return files;
  } catch (const std::exception& error) {
    return Error{cut.map_path, source::reading_error(error.what())};
  }
}

Result<source::LonLatBox> header_box_of(const std::string& map_path) {
  const Result<source::OsmFormat> format = source::osm_format_of(map_path);
  if (!format) return format.error();
  const Result<std::optional<std::string>> mended = source::mended_file(map_path, *format);
  if (!mended) return mended.error();
  try {
    osmium::io::Reader reader(*mended ? osmium::io::File((*mended)->data(), (*mended)->size(),
                                                         *format == source::OsmFormat::kPbf ? "pbf" : "osm")
                                      : file_of(map_path),
                              bits::nothing);
    const osmium::Box box = reader.header().joined_boxes();
    reader.close();
    if (!box.valid()) return Error{map_path, "has no box in its header; give the area with --bbox W,S,E,N"};
    return source::LonLatBox{box.bottom_left().lon(), box.bottom_left().lat(), box.top_right().lon(),
                             box.top_right().lat()};
  } catch (const std::exception& error) {
    return Error{map_path, source::reading_error(error.what())};
  }
}

}  // namespace citykiln::regions
