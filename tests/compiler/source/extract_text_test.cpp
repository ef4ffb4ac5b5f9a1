#include "tests/compiler/source/extract_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace citykiln::source {

std::string osm(std::string_view elements) {
  return fmt::format("<?xml version='1.0' encoding='UTF-8'?>\n<osm version=\"0.6\">\n{}\n</osm>\n", elements);
}

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

double size_sum(const Report& report, Code code) {
  double sum = 0;
  for (const Diagnosis& diagnosis : report.diagnoses()) sum += diagnosis.code == code ? diagnosis.size : 0;
  return sum;
}

namespace {

std::string text_of_tags(const OsmData& data, Range tags) {
  std::string text;
  for (const Tag& tag : data.tags_of(tags))
    text += fmt::format(" {}={}", data.strings[tag.key], data.strings[tag.value]);
  return text;
}

std::string text_of_rings(const OsmData& data, const Area& area) {
  std::string text;
  for (const AreaRing& ring : data.rings_of(area)) {
    text += fmt::format(" {}{}:", ring.part, ring.is_outer ? "o" : "i");
    for (const Location at : data.points_of(ring)) text += fmt::format(" {},{}", at.lon_e7, at.lat_e7);
  }
  return text;
}

}  // namespace

std::string text_of(const OsmData& data) {
  std::string text;
  for (const Node& n : data.nodes)
    text += fmt::format("n{} {},{}{}\n", n.id, n.at.lon_e7, n.at.lat_e7, text_of_tags(data, n.tags));
  for (const Way& way : data.ways) {
    text += fmt::format("w{}{}:", way.id, text_of_tags(data, way.tags));
    for (const NodeRef& n : data.nodes_of(way)) text += fmt::format(" {} {},{}", n.id, n.at.lon_e7, n.at.lat_e7);
    text += "\n";
  }
  for (const Area& area : data.areas) {
    text +=
        fmt::format("area {}{}{}\n", to_string(area.from), text_of_tags(data, area.tags), text_of_rings(data, area));
  }
  for (const Relation& relation : data.relations) {
    text += fmt::format("r{}{}:", relation.id, text_of_tags(data, relation.tags));
    for (std::uint32_t i = 0; i < relation.members.count; ++i) {
      const Member& member = data.members[relation.members.first + i];
      text += fmt::format(" {} {}", to_string(member.object), data.strings[member.role]);
    }
    text += "\n";
  }
  const LonLatBox& box = data.node_box;
  return text +
         fmt::format("{} strings, box {} {} {} {}\n", data.strings.size(), box.west, box.south, box.east, box.north);
}

OsmData read(std::string_view elements, Report& report, int threads) {
  const ScratchFolder folder;
  Result<OsmData> data = read_osm(folder.write("map.osm", osm(elements)), threads, report);
  if (!data) {
    ADD_FAILURE() << to_string(data.error());
    return {};
  }
  return std::move(*data);
}

}  // namespace citykiln::source
