#include "exporters/tags_json.h"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>

namespace citykiln::exporters {
namespace {

void append_json_string(std::string& out, std::string_view text) {
  out += '"';
  for (const char c : text) {
    if (c == '"' || c == '\\')
      out += '\\', out += c;
    else if (static_cast<unsigned char>(c) < 0x20)
      fmt::format_to(std::back_inserter(out), "\\u{:04x}", static_cast<unsigned>(c));
    else
      out += c;
  }
  out += '"';
}

bool has_zero(std::string_view text) { return text.find('\0') != std::string_view::npos; }

}  // namespace

std::string tags_text(const map::TagList& tags) {
  if (tags.empty()) return {};
  std::string out = "{";
  for (const map::TagView& tag : tags.views()) {
    if (out.size() > 1) out += ',';
    append_json_string(out, tag.key);
    out += ':';
    append_json_string(out, tag.value);
  }
  return out + "}";
}

std::optional<map::TagList> tags_in(std::string_view json) {
  map::TagList tags;
  if (json.empty()) return tags;
  const auto parsed = nlohmann::json::parse(json, nullptr, false);
  if (!parsed.is_object()) return std::nullopt;
  for (const auto& [key, value] : parsed.items()) {
    if (!value.is_string()) return std::nullopt;
    const std::string& text = value.get_ref<const std::string&>();
    if (has_zero(key) || has_zero(text)) return std::nullopt;
    tags.add(key, text);
  }
  return tags;
}

}  // namespace citykiln::exporters
