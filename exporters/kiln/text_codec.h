// Reads and writes the texts of OSM elements in a chunk (the recipes of one tile): names, each once per chunk, and
// tags. `io` is a Writer or a Reader (chunk_io.h).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "compiler/map/element_text.h"
#include "exporters/kiln/field_codecs.h"

namespace citykiln::exporters {

// The names of a chunk in the order in which they appear; the first one is empty.
struct NameList {
  std::vector<std::string> names = {""};
  std::map<std::string, std::size_t> numbers = {{"", 0}};

  std::size_t number_of(const std::string& name) const {
    const auto found = numbers.find(name);
    return found == numbers.end() ? names.size() : found->second;
  }
  void add(const std::string& name) { numbers.emplace(name, names.size()), names.push_back(name); }
};

// A name: its number in the list. The number after the last one means a new name, which follows.
void name(auto& io, NameList& list, std::string& value) {
  std::size_t number = list.number_of(value);
  io.number("name number", number);
  const bool is_new = number == list.names.size();
  if (is_new) io.text("name size", "name bytes", value);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (number > list.names.size() || value.size() > map::kMostNameBytes) return io.fail("name number");
  if (is_new) list.add(value);
  value = list.names[number];
}

/// The texts of all elements of a chunk, sorted by id.
void texts(auto& io, std::vector<map::ElementText>& all) {
  NameList names;
  std::optional<OsmId> before;
  list(io, "texts", all, 0, [&](map::ElementText& text) {
    enumerator(io, "id type", text.id.type, static_cast<OsmType>(kOsmTypeCount));
    io.delta("id", text.id.id);
    name(io, names, text.name);
    io.text("tags size", "tags bytes", text.tags);
    if constexpr (std::remove_reference_t<decltype(io)>::kReads)
      if (before && !(*before < text.id)) io.fail("id");
    before = text.id;
  });
}

}  // namespace citykiln::exporters
