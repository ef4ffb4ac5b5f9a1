#include "compiler/map/tags/standing.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <string>

#include "compiler/map/tags/tag_values.h"

namespace citykiln::map {
namespace {

struct LifecycleRow {
  std::string_view value;
  Presence presence;
};
constexpr LifecycleRow kLifecycle[] = {
#define LIFECYCLE(key, presence) {key, Presence::presence},
#include "compiler/map/tags/lifecycle.inc"
#undef LIFECYCLE
};

constexpr std::string_view kUndergroundPlaces[] = {"underground", "underwater"};
constexpr std::string_view kIndoorPlaces[] = {"indoor", "inside"};
constexpr std::string_view kUpperPlaces[] = {"roof", "rooftop", "roof_top"};

bool is_one_of(const auto& words, std::string_view word) { return std::ranges::find(words, word) != std::end(words); }

// Takes one storey off the front of the text, such as "-1" or "0.5".
std::optional<double> take_storey(std::string_view& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
  if (error != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

void skip_spaces(std::string_view& text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
}

// Storeys of an element by level=*, else by the number of its lowest storey among others.
std::optional<Levels> tagged_storeys(const source::OsmData& osm, source::Range tags) {
  const std::string_view level = osm.value_of(tags, "level");
  return levels_of(level.empty() ? osm.value_of(tags, "building:level") : level);
}

Storey storey_by_place(const source::OsmData& osm, source::Range tags) {
  const std::string_view location = osm.value_of(tags, "location"), parking = osm.value_of(tags, "parking");
  if (is_one_of(kUndergroundPlaces, location) || parking == "underground") return Storey::kUnderground;
  if (is_one_of(kIndoorPlaces, location)) return Storey::kIndoor;
  return is_one_of(kUpperPlaces, location) || parking == "rooftop" ? Storey::kAbove : Storey::kGround;
}

// By location, level and indoor, which hold for objects of every kind.
Storey storey_of(const source::OsmData& osm, source::Range tags) {
  if (const Storey storey = storey_by_place(osm, tags); storey != Storey::kGround) return storey;
  const std::optional<Levels> levels = tagged_storeys(osm, tags);
  if (levels && levels->highest < 0) return Storey::kUnderground;
  if (says_yes(osm.value_of(tags, "indoor"))) return Storey::kIndoor;
  return levels && levels->lowest > 0 ? Storey::kAbove : Storey::kGround;
}

std::optional<double> stated(const source::OsmData& osm, source::Range tags, std::string_view key) {
  return number_of(osm.value_of(tags, key));
}

// True if all that tags state of a building is below the ground.
bool ends_below_ground(const source::OsmData& osm, source::Range tags) {
  const auto levels = stated(osm, tags, "building:levels"), lowest = stated(osm, tags, "building:min_level"),
             below = stated(osm, tags, "building:levels:underground"), layer = stated(osm, tags, "layer");
  if (length_m_of(osm.value_of(tags, "height")).value_or(0) > 0) return false;
  if (lowest && levels && *lowest < 0 && *lowest + *levels <= 0) return true;
  if (levels && *levels == 0 && below && *below > 0 && !says_yes(osm.value_of(tags, "roof:levels"))) return true;
  // a roof with a negative layer is below a bridge
  const bool is_roof = osm.value_of(tags, "building") == "roof";
  return layer && *layer < 0 && !is_roof && !states_height(osm, tags);
}

struct BodyPrefix {
  std::string_view text;
  Presence presence;
};
// Prefixes of keys of objects that have a body, though they are not used.
constexpr BodyPrefix kBodyPrefixes[] = {{"disused:", Presence::kStands},
                                        {"abandoned:", Presence::kStands},
                                        {"ruins:", Presence::kShell},
                                        {"construction:", Presence::kShell}};

std::string_view prefixed_value(const source::OsmData& osm, source::Range tags, const BodyPrefix& prefix,
                                std::string_view key) {
  return osm.value_of(tags, std::string(prefix.text).append(key));
}

struct SurfaceRow {
  std::string_view key, value;
};
// Surfaces made by people that a layer alone puts on another storey. Water, woods and squares have layers for the order
// of drawing.
constexpr SurfaceRow kOnLayers[] = {
    {"railway", "platform"},   {"public_transport", "platform"}, {"highway", "platform"}, {"leisure", "pitch"},
    {"leisure", "track"},      {"leisure", "swimming_pool"},     {"amenity", "parking"},  {"amenity", "swimming_pool"},
    {"amenity", "bus_station"}};

bool is_on_its_layer(const source::OsmData& osm, source::Range tags) {
  return std::ranges::any_of(kOnLayers,
                             [&](const SurfaceRow& row) { return osm.value_of(tags, row.key) == row.value; });
}

bool is_covered_pool(const source::OsmData& osm, source::Range tags) {
  const bool is_pool =
      osm.value_of(tags, "leisure") == "swimming_pool" || osm.value_of(tags, "amenity") == "swimming_pool";
  return is_pool && says_yes(osm.value_of(tags, "covered"));
}

}  // namespace

std::optional<Levels> levels_of(std::string_view text) {
  std::optional<Levels> all;
  while (!text.empty()) {
    skip_spaces(text);
    const auto from = take_storey(text);
    if (!from) return std::nullopt;
    std::optional<double> to = from;
    if (text.starts_with('-')) text.remove_prefix(1), to = take_storey(text);
    if (!to) return std::nullopt;
    const auto [low, high] = std::minmax(*from, *to);
    all = all ? Levels{std::min(all->lowest, low), std::max(all->highest, high)} : Levels{low, high};
    skip_spaces(text);
    if (text.empty()) return all;
    if (text.front() != ';' && text.front() != ',') return std::nullopt;
    text.remove_prefix(1);
  }
  return all;
}

Presence presence_of(const source::OsmData& osm, source::Range tags, std::string_view key) {
  if (const LifecycleRow* row = row_with(kLifecycle, osm.value_of(tags, key))) return row->presence;
  Presence presence = Presence::kStands;
  if (osm.value_of(tags, key).empty())
    for (const BodyPrefix& prefix : kBodyPrefixes)
      if (!prefixed_value(osm, tags, prefix, key).empty()) presence = std::max(presence, prefix.presence);
  for (const LifecycleRow& row : kLifecycle)
    if (osm.value_of(tags, row.value) == "yes") presence = std::max(presence, row.presence);
  const bool is_building = key.starts_with("building");
  if (is_building && osm.value_of(tags, "historic") == "ruins") presence = std::max(presence, Presence::kShell);
  const auto start = year_of(osm.value_of(tags, "start_date")), end = year_of(osm.value_of(tags, "end_date"));
  const bool is_planned = start && *start >= kFirstFutureYear, is_past = end && *end <= kLastPastYear;
  return is_planned || is_past ? Presence::kGone : presence;
}

Standing standing_of_building(const source::OsmData& osm, source::Range tags, std::string_view key) {
  Standing standing{presence_of(osm, tags, key), storey_of(osm, tags)};
  const bool is_part = key == "building:part";
  // a house on a roof, or a part on an upper storey, is a body of its own; a shop on one is inside
  if (standing.storey == Storey::kAbove) standing.storey = Storey::kGround;
  if (standing.storey == Storey::kIndoor && !is_part) standing.storey = Storey::kGround;
  const bool is_tunnel = says_yes(osm.value_of(tags, "tunnel")) && osm.value_of(tags, "tunnel") != "building_passage";
  if (is_tunnel || ends_below_ground(osm, tags)) standing.storey = Storey::kUnderground;
  return standing;
}

Standing standing_of_area(const source::OsmData& osm, source::Range tags, std::string_view key) {
  Standing standing{presence_of(osm, tags, key), storey_of(osm, tags)};
  const std::optional<Levels> levels = tagged_storeys(osm, tags);
  const bool is_ground_floor = levels && levels->lowest <= 0 && levels->highest >= 0;
  if (standing.storey == Storey::kIndoor && is_ground_floor) standing.storey = Storey::kGround;
  if (standing.storey != Storey::kGround) return standing;
  const double layer = is_on_its_layer(osm, tags) ? stated(osm, tags, "layer").value_or(0) : 0;
  if (says_yes(osm.value_of(tags, "tunnel")) || layer < 0)
    standing.storey = Storey::kUnderground;
  else if (osm.value_of(tags, "parking") == "multi-storey" || is_covered_pool(osm, tags))
    standing.storey = Storey::kIndoor;
  else if (says_yes(osm.value_of(tags, "bridge")) || layer > 0)
    standing.storey = Storey::kAbove;
  return standing;
}

Standing standing_of_object(const source::OsmData& osm, source::Range tags, std::string_view key) {
  Standing standing{presence_of(osm, tags, key), storey_of(osm, tags)};
  if (standing.storey != Storey::kGround || !(key == "barrier" || key == "wall")) return standing;
  const double layer = stated(osm, tags, "layer").value_or(0);
  if (layer != 0) standing.storey = layer < 0 ? Storey::kUnderground : Storey::kAbove;
  return standing;
}

std::string_view standing_value(const source::OsmData& osm, source::Range tags, std::string_view key) {
  if (const std::string_view value = osm.value_of(tags, key); !value.empty()) return value;
  for (const BodyPrefix& prefix : kBodyPrefixes)
    if (const std::string_view value = prefixed_value(osm, tags, prefix, key); !value.empty()) return value;
  return {};
}

bool states_height(const source::OsmData& osm, source::Range tags) {
  return length_m_of(osm.value_of(tags, "height")).value_or(0) > 0 ||
         stated(osm, tags, "building:levels").value_or(0) > 0;
}

bool is_ruin(const source::OsmData& osm, source::Range tags) {
  const std::string_view value = osm.value_of(tags, "building");
  const auto is_yes = [&](std::string_view key) { return says_yes(osm.value_of(tags, key)); };
  return value.starts_with("ruin") || is_yes("ruins") || is_yes("ruined") || is_yes("ruins:building") ||
         osm.value_of(tags, "historic") == "ruins";
}

bool is_located_on_roof(const source::OsmData& osm, source::Range tags) {
  return is_one_of(kUpperPlaces, osm.value_of(tags, "location"));
}

std::optional<Code> reason_to_drop(Standing standing) {
  if (standing.presence == Presence::kGone) return Code::kNotThere;
  if (standing.storey == Storey::kUnderground) return Code::kUnderground;
  if (standing.storey == Storey::kIndoor) return Code::kInsideBuilding;
  return standing.storey == Storey::kAbove ? std::optional(Code::kAboveGround) : std::nullopt;
}

}  // namespace citykiln::map
