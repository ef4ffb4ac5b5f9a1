#include "compiler/map/front_tags.h"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>
#include <vector>

#include "compiler/contract/texts/parse.h"
#include "compiler/map/tags/standing.h"
#include "compiler/map/tags/tag_values.h"

namespace citykiln::map {
namespace {

constexpr std::uint8_t quarters_of(double hours) { return static_cast<std::uint8_t>(hours * 4); }

constexpr FrontValues kFrontKinds[] = {
#define FRONT_KIND(name, text, open, close, saturday, saturday_end, sunday, sunday_end, lit_share, ...)            \
  {text,                                                                                                           \
   {{quarters_of(open), quarters_of(close), quarters_of(saturday), quarters_of(saturday_end), quarters_of(sunday), \
     quarters_of(sunday_end)}},                                                                                    \
   lit_share,                                                                                                      \
   {__VA_ARGS__}},
#define FRONT(...)
#include "compiler/map/fronts.inc"
#undef FRONT
#undef FRONT_KIND
};
static_assert(std::size(kFrontKinds) == static_cast<std::size_t>(FrontKind::kCount));

struct FrontRow {
  std::string_view key, value;
  FrontKind kind;
};
constexpr FrontRow kFronts[] = {
#define FRONT_KIND(...)
#define FRONT(key, value, kind) {key, value, FrontKind::kind},
#include "compiler/map/fronts.inc"
#undef FRONT
#undef FRONT_KIND
};

bool fits(std::string_view value, std::string_view wanted) {
  return wanted == "*" ? says_yes(value) && value != "vacant" : value == wanted;
}

constexpr std::string_view kDays[] = {"Mo", "Tu", "We", "Th", "Fr", "Sa", "Su"};

// The days of a text such as "Mo-Fr,Su", as bits; public holidays count as none. Nothing for other texts.
std::optional<unsigned> days_of(std::string_view text) {
  const auto day = [](std::string_view name) { return std::ranges::find(kDays, name) - std::begin(kDays); };
  unsigned days = 0;
  for (const std::string_view part : split(text, ',')) {
    if (part == "PH" || part == "SH") continue;
    const std::vector<std::string_view> ends = split(part, '-');
    const auto first = day(ends.front()), last = day(ends.back());
    if (ends.size() > 2 || first == 7 || last == 7) return std::nullopt;
    for (auto i = first;; i = (i + 1) % 7) {
      days |= 1u << i;
      if (i == last) break;
    }
  }
  return days;
}

// Quarter hours of a time such as "08:30".
std::optional<int> quarters_in(std::string_view text) {
  const std::optional<std::vector<int>> parts = numbers_in<int>(text, ':', 2);
  if (!parts || (*parts)[0] < 0 || (*parts)[0] > 30 || (*parts)[1] < 0 || (*parts)[1] > 59) return std::nullopt;
  return (*parts)[0] * 4 + (*parts)[1] / 15;
}

using Opening = std::pair<std::uint8_t, std::uint8_t>;

// The first opening and the last closing of a text such as "11:00-15:00,18:00-23:00".
std::optional<Opening> opening_of(std::string_view text) {
  if (text == "off" || text == "closed") return Opening{};
  std::optional<Opening> all;
  for (const std::string_view part : split(text, ',')) {
    const std::vector<std::string_view> ends = split(part, '-');
    const std::optional<int> open = quarters_in(ends.front());
    std::optional<int> close = ends.size() == 2 ? quarters_in(ends.back()) : std::nullopt;
    if (!open || !close) return std::nullopt;
    if (*close <= *open) *close += 96;
    close = std::min<int>(*close, kLatestClosing);
    if (*open >= *close) return std::nullopt;
    if (!all) all.emplace(static_cast<std::uint8_t>(*open), std::uint8_t{0});
    all->first = std::min(all->first, static_cast<std::uint8_t>(*open));
    all->second = std::max(all->second, static_cast<std::uint8_t>(*close));
  }
  return all;
}

}  // namespace

const FrontValues& values_of(FrontKind kind) { return kFrontKinds[static_cast<std::size_t>(kind)]; }

std::optional<FrontHours> front_hours_of(std::string_view text) {
  if (text == "24/7") return FrontHours{{0, 96, 0, 96, 0, 96}};
  std::array<Opening, 7> week{};
  for (std::string_view rule : split(text, ';')) {
    rule = trimmed(rule);
    if (rule.empty()) continue;
    const std::size_t space = rule.rfind(' ');
    const bool has_days = space != std::string_view::npos;
    const std::optional<unsigned> days = has_days ? days_of(trimmed(rule.substr(0, space))) : 0x7fu;
    const std::optional<Opening> opening = opening_of(has_days ? rule.substr(space + 1) : rule);
    if (!days || !opening) return std::nullopt;
    for (std::size_t i = 0; i < 7; ++i)
      if ((*days >> i & 1) != 0) week[i] = *opening;
  }
  // Wednesday stands for the weekdays
  const auto [weekday, saturday, sunday] = std::tuple(week[2], week[5], week[6]);
  const FrontHours hours{{weekday.first, weekday.second, saturday.first, saturday.second, sunday.first, sunday.second}};
  return hours == FrontHours{} ? std::nullopt : std::optional(hours);
}

std::optional<FrontTags> read_front_tags(const source::OsmData& osm, source::Range tags) {
  const auto value = [&](std::string_view key) { return osm.value_of(tags, key); };
  const auto row =
      std::ranges::find_if(kFronts, [&](const FrontRow& each) { return fits(value(each.key), each.value); });
  if (row == std::end(kFronts)) return std::nullopt;
  const Standing standing = standing_of_object(osm, tags, row->key);
  if (standing.presence != Presence::kStands || standing.storey != Storey::kGround) return std::nullopt;
  return FrontTags{row->kind, front_hours_of(osm.value_of(tags, "opening_hours"))};
}

}  // namespace citykiln::map
