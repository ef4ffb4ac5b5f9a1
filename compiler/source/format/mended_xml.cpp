#include "compiler/source/format/mended_xml.h"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iterator>
#include <osmium/io/bzip2_compression.hpp>
#include <osmium/io/gzip_compression.hpp>
#include <set>
#include <utility>

#include "compiler/source/format/mended_pbf.h"

namespace citykiln::source {
namespace {

void append_utf8(std::uint32_t code, std::string& text) {
  const auto byte = [&](std::uint32_t bits) { text += static_cast<char>(bits); };
  if (code < 0x80) return byte(code);
  if (code < 0x800) return byte(0xc0 | code >> 6), byte(0x80 | (code & 0x3f));
  if (code < 0x10000) return byte(0xe0 | code >> 12), byte(0x80 | (code >> 6 & 0x3f)), byte(0x80 | (code & 0x3f));
  byte(0xf0 | code >> 18), byte(0x80 | (code >> 12 & 0x3f));
  byte(0x80 | (code >> 6 & 0x3f)), byte(0x80 | (code & 0x3f));
}

// Removes encoding="…" from the XML declaration.
void drop_encoding(std::string& text) {
  const std::size_t end = text.find("?>"), at = text.find("encoding");
  if (!text.starts_with("<?xml") || at == std::string::npos || end == std::string::npos || at > end) return;
  text.erase(at, end - at);
}

// The value of an attribute in a start tag; empty if it is missing.
std::string_view attribute(std::string_view tag, std::string_view name) {
  for (std::size_t at = tag.find(name); at != std::string_view::npos; at = tag.find(name, at + 1)) {
    std::size_t quote = at + name.size();
    while (quote < tag.size() && tag[quote] == ' ') ++quote;
    if (tag[at - 1] > ' ' || quote + 1 >= tag.size() || tag[quote] != '=') continue;
    quote = tag.find_first_of("'\"", quote);
    if (quote == std::string_view::npos) return {};
    const std::size_t end = tag.find(tag[quote], quote + 1);
    return end == std::string_view::npos ? std::string_view{} : tag.substr(quote + 1, end - quote - 1);
  }
  return {};
}

// The position after the tag, comment or declaration that begins at `at`.
std::size_t end_of_tag(std::string_view text, std::size_t at) {
  const auto after = [&](std::string_view mark) {
    const std::size_t found = text.find(mark, at);
    return found == std::string_view::npos ? text.size() : found + mark.size();
  };
  if (text.substr(at).starts_with("<!--")) return after("-->");
  if (text.substr(at).starts_with("<![CDATA[")) return after("]]>");
  char quote = 0;
  for (std::size_t i = at; i < text.size(); ++i) {
    if (quote == 0 && text[i] == '>') return i + 1;
    if (quote == 0 && (text[i] == '\'' || text[i] == '"'))
      quote = text[i];
    else if (text[i] == quote)
      quote = 0;
  }
  return text.size();
}

std::string_view name_of_tag(std::string_view tag) {
  tag.remove_prefix(1);
  return tag.substr(0, tag.find_first_of(" \t\r\n/>", tag.starts_with('/') ? 1 : 0));
}

// Calls visit(tag, name, text between the tag before and it) for each tag.
template <typename Visit>
void for_each_xml_tag(std::string_view text, Visit visit) {
  std::size_t from = 0;
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', from)) {
    const std::size_t end = end_of_tag(text, at);
    const std::string_view tag = text.substr(at, end - at);
    visit(tag, name_of_tag(tag), text.substr(from, at - from));
    from = end;
  }
}

bool is_element(std::string_view name) { return name == "node" || name == "way" || name == "relation"; }

// True for the elements of the format that hold a map, and for comments and declarations. Others are skipped, with what
// they hold.
bool is_known(std::string_view name) {
  constexpr std::string_view kKnown[] = {"nd",       "tag",    "node", "way",  "member",
                                         "relation", "bounds", "osm",  "note", "meta"};
  return name.starts_with('!') || name.starts_with('?') || std::ranges::find(kKnown, name) != std::end(kKnown);
}

bool marks_deletion(std::string_view tag, std::string_view name) {
  return is_element(name) && attribute(tag, "action") == "delete";
}

std::string as_invisible(std::string_view tag) {
  std::string marked(tag);
  if (const std::string_view value = attribute(marked, "visible"); !value.empty())
    marked.replace(static_cast<std::size_t>(value.data() - marked.data()), value.size(), "false");
  else
    marked.insert(1 + name_of_tag(tag).size(), " visible=\"false\"");
  return marked;
}

// A number for a node of which only the place is known: equal places have equal numbers. Below all numbers of editors.
std::int64_t number_of_place(std::string_view lat, std::string_view lon) {
  const auto e7 = [](std::string_view degrees, double least) {
    const double value = std::strtod(std::string(degrees).c_str(), nullptr);
    return static_cast<std::int64_t>(std::llround(std::clamp(value - least, 0.0, 360.0) * 1e7));
  };
  return -((e7(lat, -90) << 32) + e7(lon, -180)) - (std::int64_t{1} << 48);
}

// Collects the parts of the new document.
class PlainElements {
 public:
  explicit PlainElements(std::string_view text) {
    for_each_xml_tag(text, [&](std::string_view tag, std::string_view name, std::string_view) {
      if (name == "node") known_nodes_.emplace(attribute(tag, "id"));
      if (name == "way") known_ways_.emplace(attribute(tag, "id"));
    });
    for_each_xml_tag(
        text, [&](std::string_view tag, std::string_view name, std::string_view before) { add(tag, name, before); });
  }
  std::string text() const { return head_ + nodes_ + elements_ + ways_ + relations_; }

 private:
  std::string& part() { return has_relations_ ? relations_ : has_elements_ ? elements_ : head_; }

  void add(std::string_view tag, std::string_view name, std::string_view before) {
    has_elements_ |= is_element(name);
    has_relations_ |= name == "relation";
    if (unknown_depth_ > 0 || (!name.starts_with('/') && !is_known(name))) return skip(tag, name);
    if (in_member_) return add_in_member(tag, name);
    part() += before;
    if (name == "nd") add_node(attribute(tag, "ref"), tag);
    if (name == "member" && !tag.ends_with("/>")) return open_member(tag);
    if (marks_deletion(tag, name))
      part() += as_invisible(tag);
    else
      part() += tag;
  }
  // Skips an unknown element and all it holds.
  void skip(std::string_view tag, std::string_view name) {
    if (name.starts_with('!') || name.starts_with('?')) return;
    if (name.starts_with('/'))
      --unknown_depth_;
    else if (!tag.ends_with("/>"))
      ++unknown_depth_;
  }
  void add_node(std::string_view id, std::string_view tag) {
    const std::string_view lat = attribute(tag, "lat"), lon = attribute(tag, "lon");
    if (lat.empty() || lon.empty() || !known_nodes_.emplace(id).second) return;
    nodes_ += fmt::format("<node id=\"{}\" lat=\"{}\" lon=\"{}\"/>\n", id, lat, lon);
  }
  void open_member(std::string_view tag) {
    tag.remove_suffix(1);
    part() += std::string(tag) + "/>";
    in_member_ = true;
    const std::string_view ref = attribute(tag, "ref");
    is_new_way_ = attribute(tag, "type") == "way" && known_ways_.emplace(ref).second;
    if (is_new_way_) ways_ += fmt::format("<way id=\"{}\">", ref);
  }
  void add_in_member(std::string_view tag, std::string_view name) {
    if (name == "nd" && is_new_way_ && !attribute(tag, "lat").empty()) {
      const std::string id = std::to_string(number_of_place(attribute(tag, "lat"), attribute(tag, "lon")));
      add_node(id, tag);
      ways_ += fmt::format("<nd ref=\"{}\"/>", id);
    }
    if (name != "/member") return;
    if (is_new_way_) ways_ += "</way>\n";
    in_member_ = is_new_way_ = false;
  }

  std::set<std::string, std::less<>> known_nodes_, known_ways_;
  std::string head_, nodes_, elements_, ways_, relations_;
  int unknown_depth_ = 0;  // the number of open elements from an unknown one on
  bool has_elements_ = false, has_relations_ = false, in_member_ = false, is_new_way_ = false;
};

bool holds_places_in_ways(std::string_view text) {
  const std::size_t at = text.find("<nd ");
  return at != std::string_view::npos && !attribute(text.substr(at, end_of_tag(text, at) - at), "lat").empty();
}

// False for other documents and where the text is cut off, of which libosmium says what is wrong.
bool holds_unknown_elements(std::string_view text) {
  if (text.substr(0, 4096).find("<osm") == std::string_view::npos) return false;
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at + 1)) {
    const std::string_view rest = text.substr(at + 1, 32);
    if (rest.starts_with('/')) continue;
    if (rest.starts_with("!--") || rest.starts_with("![CDATA[")) at = end_of_tag(text, at) - 1;
    if (rest.starts_with('!') || rest.starts_with('?')) continue;
    const bool is_whole = text.find('>', at) != std::string_view::npos;
    if (!is_known(rest.substr(0, rest.find_first_of(" \t\r\n/>")))) return is_whole;
  }
  return false;
}

// True for a document of osmChange, which lists the differences between two maps.
bool holds_changes(std::string_view text) { return text.substr(0, 4096).find("<osmChange") != std::string_view::npos; }

bool holds_deletions(std::string_view text) {
  return text.find("action=\"delete\"") != std::string_view::npos ||
         text.find("action='delete'") != std::string_view::npos;
}

std::string read_all(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string unpacked(const std::string& path, OsmFormat format) {
  const auto packing =
      format == OsmFormat::kXmlGzip ? osmium::io::file_compression::gzip : osmium::io::file_compression::bzip2;
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const auto reader = osmium::io::CompressionFactory::instance().create_decompressor(packing, file);
  std::string text;
  for (std::string part = reader->read(); !part.empty(); part = reader->read()) text += part;
  reader->close();
  return text;
}

}  // namespace

std::optional<std::string> utf8_of_utf16(std::string_view bytes) {
  if (bytes.size() < 4) return std::nullopt;
  const bool is_little = bytes.starts_with("\xff\xfe") || bytes.starts_with(std::string_view("<\0", 2));
  const bool is_big = bytes.starts_with("\xfe\xff") || bytes.starts_with(std::string_view("\0<", 2));
  if (!is_little && !is_big) return std::nullopt;
  const auto unit = [&](std::size_t at) {
    const auto low = static_cast<unsigned char>(bytes[at + is_big]),
               high = static_cast<unsigned char>(bytes[at + !is_big]);
    return std::uint32_t{high} << 8 | low;
  };
  std::string text;
  for (std::size_t at = 0; at + 1 < bytes.size(); at += 2) {
    std::uint32_t code = unit(at);
    if (code == 0xfeff && at == 0) continue;
    const std::uint32_t next = at + 3 < bytes.size() ? unit(at + 2) : 0;
    if ((code & 0xfc00) == 0xd800 && (next & 0xfc00) == 0xdc00)
      code = 0x10000 + ((code & 0x3ff) << 10) + (next & 0x3ff), at += 2;
    append_utf8((code & 0xf800) == 0xd800 ? 0xfffd : code, text);
  }
  drop_encoding(text);
  return text;
}

std::optional<std::string> mended_elements(std::string_view text) {
  const bool has_geometry = holds_places_in_ways(text) || text.find("</member>") != std::string_view::npos;
  if (!has_geometry && !holds_deletions(text) && !holds_unknown_elements(text)) return std::nullopt;
  return PlainElements(text).text();
}

Result<std::optional<std::string>> mended_file(const std::string& path, OsmFormat format) {
  if (format == OsmFormat::kPbf) return mended_pbf(path);
  try {
    std::string bytes = format == OsmFormat::kXml ? read_all(path) : unpacked(path, format);
    std::optional<std::string> text = utf8_of_utf16(bytes);
    if (holds_changes(text ? *text : bytes)) return change_file_error(path);
    std::optional<std::string> mended = mended_elements(text ? *text : bytes);
    return mended ? std::move(mended) : std::move(text);
  } catch (const std::exception& error) {
    return Error{path, reading_error(error.what())};
  }
}

}  // namespace citykiln::source
