// Test fixtures: extracts drawn as text in metres of the plane, and features printed for comparison.
#pragma once

#include <fmt/format.h>

#include <charconv>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "compiler/map/locate.h"
#include "compiler/source/osm_data.h"

namespace citykiln::map {

inline const LonLat kTestOrigin{7.42, 43.73};

/// A small extract, written by hand. Each line is one element:
///
///     n5 3:4 natural=tree                               a node
///     w12 0:0 10:0 highway=residential width=12~m       a way; ~ stands for a space
///     a20 0:0 4:0 4:3 building=yes                      a closed way: in ways and in areas; counter-clockwise
///     r30 0:0 9:0 9:9 / 2:2 2:4 4:4 ; 20:0 22:0 22:2 natural=water
///                                                       a multipolygon: / begins a hole, ; a further polygon
///
/// Places are metres from kTestOrigin; OSM's grid moves them by up to 6 mm. Nodes in one place are one node.
class MapText {
 public:
  explicit MapText(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) read_line(line);
    finish_strings();
    const auto by_id = [](const auto& a, const auto& b) { return a.id < b.id; };
    std::sort(data_.nodes.begin(), data_.nodes.end(), by_id);
    std::sort(data_.ways.begin(), data_.ways.end(), by_id);
    std::sort(data_.areas.begin(), data_.areas.end(), [](const auto& a, const auto& b) { return a.from < b.from; });
  }
  source::OsmData take() { return std::move(data_); }

 private:
  source::Location place(std::string_view text) const {
    const std::size_t colon = text.find(':');
    const LonLat p = plane_.backward(
        {std::stod(std::string(text.substr(0, colon))), std::stod(std::string(text.substr(colon + 1)))});
    return {static_cast<std::int32_t>(std::lround(p.lon_deg * 1e7)),
            static_cast<std::int32_t>(std::lround(p.lat_deg * 1e7))};
  }
  static std::int64_t node_id(source::Location at) { return std::int64_t{at.lon_e7} * 4294967296 + at.lat_e7; }

  // Strings are numbered as they come and put in order at the end.
  std::uint32_t string_index(std::string text) {
    std::replace(text.begin(), text.end(), '~', ' ');
    const auto [it, is_new] = numbers_.emplace(text, static_cast<std::uint32_t>(numbers_.size()));
    return it->second;
  }
  void finish_strings() {
    std::vector<std::uint32_t> rank(numbers_.size());
    for (const auto& [text, number] : numbers_)
      rank[number] = static_cast<std::uint32_t>(data_.strings.size()), data_.strings.push_back(text);
    for (source::Tag& tag : data_.tags) tag = {rank[tag.key], rank[tag.value]};
  }

  void read_line(const std::string& line) {
    std::istringstream words(line);
    std::string head;
    if (!(words >> head)) return;
    std::vector<std::vector<source::Location>> rings(1);
    std::vector<bool> is_outer = {true};
    const source::Range tags = read_words(words, rings, is_outer);
    const std::int64_t id = std::stoll(head.substr(1));
    if (head[0] == 'n') data_.nodes.push_back({id, rings[0][0], tags});
    if (head[0] == 'w') add_way(id, rings[0], tags);
    if (head[0] == 'a') {
      rings[0].push_back(rings[0][0]);
      add_way(id, rings[0], tags);
      rings[0].pop_back();
      add_area({OsmType::kWay, id}, rings, is_outer, tags);
    }
    if (head[0] == 'r') add_area({OsmType::kRelation, id}, rings, is_outer, tags);
  }
  source::Range read_words(std::istream& words, std::vector<std::vector<source::Location>>& rings,
                           std::vector<bool>& is_outer) {
    std::map<std::string, std::string> tags;
    for (std::string word; words >> word;) {
      const std::size_t equals = word.find('=');
      if (word == "/" || word == ";")
        rings.emplace_back(), is_outer.push_back(word == ";");
      else if (equals != std::string::npos)
        tags[word.substr(0, equals)] = word.substr(equals + 1);
      else
        rings.back().push_back(place(word));
    }
    const source::Range range{static_cast<std::uint32_t>(data_.tags.size()), static_cast<std::uint32_t>(tags.size())};
    for (const auto& [key, value] : tags) data_.tags.push_back({string_index(key), string_index(value)});
    return range;
  }
  void add_way(std::int64_t id, const std::vector<source::Location>& places, source::Range tags) {
    const source::Range nodes{static_cast<std::uint32_t>(data_.way_nodes.size()),
                              static_cast<std::uint32_t>(places.size())};
    for (const source::Location at : places) data_.way_nodes.push_back({node_id(at), at});
    data_.ways.push_back({id, nodes, tags});
  }
  void add_area(OsmId id, const std::vector<std::vector<source::Location>>& rings, const std::vector<bool>& is_outer,
                source::Range tags) {
    const std::uint32_t first = static_cast<std::uint32_t>(data_.rings.size());
    std::uint32_t part = 0;
    for (std::size_t i = 0; i < rings.size(); ++i) {
      if (i > 0 && is_outer[i]) ++part;
      const source::Range points{static_cast<std::uint32_t>(data_.ring_points.size()),
                                 static_cast<std::uint32_t>(rings[i].size())};
      data_.ring_points.insert(data_.ring_points.end(), rings[i].begin(), rings[i].end());
      data_.rings.push_back({points, part, is_outer[i]});
    }
    data_.areas.push_back({id, {first, static_cast<std::uint32_t>(rings.size())}, tags});
  }

  Plane plane_{kTestOrigin};
  source::OsmData data_;
  std::map<std::string, std::uint32_t> numbers_;
};

inline source::OsmData extract(const std::string& text) { return MapText(text).take(); }

/// A box in degrees that extends `half_m` from the origin to each side.
inline source::LonLatBox box_around(double half_m) {
  const Plane plane(kTestOrigin);
  const LonLat low = plane.backward({-half_m, -half_m}), high = plane.backward({half_m, half_m});
  return {low.lon_deg, low.lat_deg, high.lon_deg, high.lat_deg};
}

/// Returns the features of an extract, located about kTestOrigin, with an extent of about 1 km.
inline Features features_of(const source::OsmData& osm, Report& report) {
  return locate(osm, Plane(kTestOrigin), box_around(500), {}, report);
}
inline Features features_of(const std::string& text, Report& report) { return features_of(extract(text), report); }
inline Features features_of(const std::string& text) {
  Report report;
  return features_of(text, report);
}

/// Returns a text of all members, with coordinates to the last bit: equal texts mean equal features.
inline std::string text_of(const Features& f) {
  std::string text;
  const auto id = [](ObjectId object) { return fmt::format("{}.{}", to_string(object.osm), object.part); };
  const auto line = [](const Polyline& points) {
    std::string all;
    for (const Vec2 p : points) all += fmt::format(" {:a}:{:a}", p.x, p.y);
    return all;
  };
  const auto polygon = [&](const Polygon& p) {
    std::string all = line(p.outer);
    for (const Ring& hole : p.holes) all += " /" + line(hole);
    return all;
  };
  const auto colour = [](const std::optional<Srgb>& c) {
    return c ? fmt::format("{}.{}.{}", (*c)[0], (*c)[1], (*c)[2]) : std::string("-");
  };
  const auto material = [](const std::optional<materials::Material>& m) { return m ? static_cast<int>(*m) : -1; };
  text += fmt::format("region {:a}:{:a} {:a}:{:a}\n", f.extent.min.x, f.extent.min.y, f.extent.max.x, f.extent.max.y);
  for (const Track& t : f.tracks) {
    text += fmt::format("track {} {} {:a} {} {} {}{}{}{}", id(t.id), values_of(t.surface).name,
                        carriageway_width_m(t.section), t.layer, static_cast<int>(t.passage), t.is_oneway, t.is_lit,
                        t.is_rail, line(t.axis));
    for (const std::int64_t node : t.node_ids) text += fmt::format(" n{}", node);
    text += fmt::format(" {}{} side {} {} {:a}", t.is_roundabout, t.is_link, static_cast<int>(t.side),
                        to_string(t.section), t.section.axis_offset_m);
    for (const TrackPoint& p : t.points)
      text += fmt::format(" p{}.{}.{}", p.vertex, static_cast<int>(p.kind), p.facing);
    text += '\n';
  }
  for (const Footprint& p : f.footprints)
    text += fmt::format("footprint {} {}{} {:a} {:a} {} {} {} {} {}{}\n", id(p.id), p.is_part, p.has_parts, p.height_m,
                        p.min_height_m, colour(p.wall_colour), colour(p.roof_colour), material(p.wall_material),
                        material(p.roof_material), p.building_class, polygon(p.polygon));
  for (const AreaFeature& a : f.areas)
    text += fmt::format("area {} {} {:a}{}\n", id(a.id), values_of(a.surface).name, a.area_m2, polygon(a.polygon));
  for (const Waterway& w : f.waterways)
    text += fmt::format("waterway {} {:a} {} {}{}\n", id(w.id), w.width_m, w.layer, static_cast<int>(w.passage),
                        line(w.axis));
  for (const Barrier& b : f.barriers)
    text += fmt::format("barrier {} {} {:a} {:a}{}\n", id(b.id), static_cast<int>(b.kind), b.height_m, b.width_m,
                        line(b.axis));
  for (const PointFeature& p : f.points)
    text += fmt::format("point {} {} {:a}:{:a} {:a} {}\n", id(p.id), static_cast<int>(p.kind), p.at.x, p.at.y,
                        p.height_m, static_cast<int>(p.plant_tags.leaves));
  return text;
}

}  // namespace citykiln::map
