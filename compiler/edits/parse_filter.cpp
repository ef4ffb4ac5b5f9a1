#include "compiler/edits/parse_filter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/contract/texts/parse.h"
#include "compiler/edits/offsets.h"
#include "compiler/source/format/plain_words.h"

namespace citykiln::edits {
namespace {

constexpr std::string_view kPlaceForm = "longitude,latitude in degrees, such as 7.42,43.73";
constexpr std::string_view kTagForm =
    "key, key=value, key=value,value, key!=value or n/key (types n, w, r, a before the key)";

std::int32_t degrees_e7(double degrees) { return static_cast<std::int32_t>(std::floor(degrees * 1e7 + 0.5)); }

bool is_on_earth(double lon_deg, double lat_deg) {
  // a map across 180 degrees goes on to 200
  return lon_deg >= -180 && lon_deg <= 200 && lat_deg >= -90 && lat_deg <= 90;
}

std::optional<OsmId> id_in(std::string_view text) {
  if (text.size() < 2) return std::nullopt;
  const std::size_t type = std::string_view("nwr").find(text.front());
  if (type == std::string_view::npos) return std::nullopt;
  const auto number = number_in<std::int64_t>(text.substr(1));
  if (!number) return std::nullopt;
  constexpr OsmType kTypes[] = {OsmType::kNode, OsmType::kWay, OsmType::kRelation};
  return OsmId{kTypes[type], *number};
}

Result<Condition> parse_box(const Word& word) {
  const auto n = numbers_in<double>(word.text, ',', 4);
  if (!n || !is_on_earth((*n)[0], (*n)[1]) || !is_on_earth((*n)[2], (*n)[3]) || (*n)[0] >= (*n)[2] ||
      (*n)[1] >= (*n)[3])
    return expected_at(word, "west,south,east,north in degrees, such as box=7.41,43.72,7.43,43.74");
  Condition condition{.kind = ConditionKind::kBox};
  condition.box = {(*n)[0], (*n)[1], (*n)[2], (*n)[3]};
  return condition;
}

Result<Condition> parse_near(const Word& word) {
  const auto n = numbers_in<double>(word.text, ',', 3);
  if (!n || !is_on_earth((*n)[0], (*n)[1]) || !((*n)[2] > 0))
    return expected_at(word, "longitude,latitude,metres, such as near=7.42,43.73,200");
  Condition condition{.kind = ConditionKind::kNear};
  condition.circle = circle_about({degrees_e7((*n)[0]), degrees_e7((*n)[1])}, (*n)[2]);
  return condition;
}

// The types before "/", such as those of "nw/highway".
Result<ElementTypes> parse_types(const Word& word) {
  ElementTypes types = 0;
  for (const char letter : word.plain) {
    const std::size_t bit = std::string_view("nwra").find(letter);
    if (bit == std::string_view::npos) return expected_at(word, "types n, w, r or a before \"/\"");
    types |= static_cast<ElementTypes>(1U << bit);
  }
  return types == 0 ? Result<ElementTypes>(expected_at(word, "types n, w, r or a before \"/\"")) : types;
}

// The values after "=" or "!=".
Result<std::vector<std::string>> parse_filter_values(const std::string& key, const Word& word, bool is_other) {
  if (word.plain == "*" && !is_other) return std::vector<std::string>{};
  if (word.plain == "*") return expected_at(word, "a value after !=; elements without a key are !key");
  std::vector<std::string> values;
  for (const Word& part : parts_between(word, ',')) {
    if (part.text.empty()) return expected_at(part, "a value between = and , or after it");
    const std::size_t star = part.plain.find('*', 1);
    if (star != std::string::npos && star + 1 != part.plain.size())
      return expected_at(part, "* at the begin or the end of a value");
    values.push_back(source::plain_word(key, part.text));
  }
  return values;
}

Result<Condition> parse_tag(const Word& word) {
  Condition condition;
  Word rest = word;
  if (const std::size_t slash = word.plain.find('/'); slash < word.plain.find('=')) {
    const Result<ElementTypes> types = parse_types(part_of(word, 0, slash));
    if (!types) return types.error();
    condition.types = *types, rest = part_of(word, slash + 1);
  }
  const std::size_t equal = rest.plain.find('=');
  condition.is_other = equal != std::string::npos && equal > 0 && rest.plain[equal - 1] == '!';
  const Word key = part_of(rest, 0, equal == std::string::npos ? equal : equal - (condition.is_other ? 1 : 0));
  if (key.text.empty() || key.plain.find_first_of("!<>~|()[]*,") != std::string::npos)
    return expected_at(word, kTagForm);
  condition.key = key.text;
  if (equal == std::string::npos) return condition;
  Result<std::vector<std::string>> values = parse_filter_values(key.text, part_of(rest, equal + 1), condition.is_other);
  if (!values) return values.error();
  condition.values = std::move(*values);
  return condition;
}

}  // namespace

Error expected_at(const Word& word, std::string_view what) {
  return {fmt::format("{}", word.column), fmt::format("expected {}, found \"{}\"", what, word.text)};
}

Result<source::Location> parse_place(const Word& word) {
  const auto n = numbers_in<double>(word.text, ',', 2);
  if (!n || !is_on_earth((*n)[0], (*n)[1])) return expected_at(word, kPlaceForm);
  return source::Location{degrees_e7((*n)[0]), degrees_e7((*n)[1])};
}

bool begins_as_id(const Word& word) {
  const std::string& text = word.plain;
  return text.size() >= 2 && std::string_view("nwr").find(text[0]) != std::string_view::npos &&
         ((text[1] >= '0' && text[1] <= '9') || text[1] == '-');
}

Result<std::vector<OsmId>> parse_ids(const Word& word) {
  std::vector<OsmId> ids;
  for (const Word& part : parts_between(word, ',')) {
    const std::optional<OsmId> id = id_in(part.text);
    if (!id) return expected_at(part, "an id such as w123, n5 or r7, or several such as w123,w124");
    ids.push_back(*id);
  }
  std::ranges::sort(ids);
  return ids;
}

Result<Condition> parse_condition(const Word& word) {
  if (word.plain.starts_with('!')) {
    Result<Condition> negated = parse_condition(part_of(word, 1));
    if (negated) negated->is_negated = !negated->is_negated;
    return negated;
  }
  if (word.plain.starts_with("box=")) return parse_box(part_of(word, 4));
  if (word.plain.starts_with("near=")) return parse_near(part_of(word, 5));
  if (!begins_as_id(word)) return parse_tag(word);
  Result<std::vector<OsmId>> ids = parse_ids(word);
  if (!ids) return ids.error();
  Condition condition{.kind = ConditionKind::kIds};
  condition.ids = std::move(*ids);
  return condition;
}

}  // namespace citykiln::edits
