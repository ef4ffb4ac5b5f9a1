#include "compiler/map/lanes/lane_tags.h"

#include <algorithm>
#include <cassert>

#include "compiler/map/tags/tag_values.h"

namespace citykiln::map {
namespace {

std::optional<double> readable_width_m(std::string_view text) {
  const auto length = length_m_of(text);
  return length && *length >= 0.1 && *length <= 20 ? length : std::nullopt;
}

// True for "left", "right" and "both".
bool is_side(std::string_view text) { return text == "left" || text == "right" || text == "both"; }

// True for keys like "sidewalk:left:width" and "verge:width".
bool is_width_beside(std::string_view key) {
  if (key == "verge:width") return true;
  const std::size_t first = key.find(':'), last = key.rfind(':');
  if (first == last || key.substr(last) != ":width" || !is_side(key.substr(first + 1, last - first - 1))) return false;
  const std::string_view what = key.substr(0, first);
  return what == "cycleway" || what == "parking" || what == "shoulder" || what == "sidewalk" || what == "verge";
}

// True for keys like "cycleway:buffer" and "cycleway:both:buffer".
bool is_buffer(std::string_view key) {
  const std::size_t first = key.find(':'), last = key.rfind(':');
  if (first == std::string_view::npos || key.substr(0, first) != "cycleway" || key.substr(last) != ":buffer")
    return false;
  return first == last || is_side(key.substr(first + 1, last - first - 1));
}

bool is_readable_buffer(std::string_view value) {
  return value == "yes" || value == "no" || value == "none" || length_m_of(value).value_or(-1) >= 0;
}

}  // namespace

void LaneTags::add_bad_count() const {
  for (const char* key : {"lanes", "lanes:forward", "lanes:backward", "lanes:both_ways"})
    if (!(*this)(key).empty()) return add_bad_value(key);
  add_bad_value("lanes");
}

std::string_view LaneTags::roadside(Flow flow) const {
  return (flow == Flow::kForward) == (side == DrivingSide::kRight) ? "right" : "left";
}

std::string_view LaneTags::beside(Flow flow, std::string_view key, std::string_view suffix) const {
  for (const std::string_view where : {roadside(flow), std::string_view("both")}) {
    std::string full(key);
    full.append(":").append(where).append(suffix);
    if (const std::string_view value = (*this)(full); !value.empty()) return value;
  }
  return {};
}

std::string LaneTags::key_along(Flow flow, const std::string& key) const {
  std::string directed = key + std::string(suffix(flow));
  const bool is_stated_for_all = is_one_way() && flow == only_flow();
  return is_stated_for_all && (*this)(directed).empty() ? key : directed;
}

std::vector<std::string_view> LaneTags::list_along(Flow flow, const std::string& key) const {
  std::string_view text = (*this)(key_along(flow, key));
  if (text.empty()) return {};
  std::vector<std::string_view> entries;
  for (std::size_t bar = text.find('|'); bar != std::string_view::npos; bar = text.find('|')) {
    entries.push_back(text.substr(0, bar));
    text.remove_prefix(bar + 1);
  }
  entries.push_back(text);
  // lists run left to right as drivers see them; with traffic on the left the middle is on the right
  if (side == DrivingSide::kLeft) std::reverse(entries.begin(), entries.end());
  return entries;
}

std::optional<double> LaneTags::count(const std::string& key, double least) const {
  assert(0 <= least && least <= kMaxLanes);
  const std::string_view text = (*this)(key);
  if (text.empty()) return std::nullopt;
  const auto number = number_of(text);
  if (number && *number >= least && *number <= kMaxLanes) return number;
  add_bad_value(key);
  return std::nullopt;
}

std::optional<double> LaneTags::width_beside(Flow flow, std::string_view key) const {
  const std::string_view text = beside(flow, key, ":width");
  return readable_width_m(text.empty() && key == "verge" ? (*this)("verge:width") : text);
}

std::optional<Traffic> tagged_traffic(std::string_view oneway) {
  if (oneway == "yes" || oneway == "1" || oneway == "true") return Traffic::kForward;
  if (oneway == "no" || oneway == "0" || oneway == "false") return Traffic::kTwoWay;
  if (oneway == "-1" || oneway == "reverse") return Traffic::kBackward;
  if (oneway == "reversible" || oneway == "alternating") return Traffic::kInTurns;
  return std::nullopt;
}

Traffic traffic_of(const LaneTags& tags) {
  const std::string_view oneway = tags("oneway"), junction = tags("junction"), highway = tags("highway");
  if (const auto tagged = tagged_traffic(oneway)) return *tagged;
  if (!oneway.empty()) tags.add_bad_value("oneway");
  const bool is_implied =
      junction == "roundabout" || junction == "circular" || highway == "motorway" || highway == "motorway_link";
  return is_implied ? Traffic::kForward : Traffic::kTwoWay;
}

void diagnose_widths_beside(const LaneTags& tags) {
  const source::OsmData& osm = tags.context.osm;
  for (const source::Tag& tag : osm.tags_of(tags.tags)) {
    const std::string_view key = osm.strings[tag.key], value = osm.strings[tag.value];
    const bool is_bad_width = is_width_beside(key) && !readable_width_m(value);
    const bool is_bad_buffer = is_buffer(key) && !is_readable_buffer(value);
    if (!value.empty() && (is_bad_width || is_bad_buffer)) tags.add_bad_value(key);
  }
}

}  // namespace citykiln::map
