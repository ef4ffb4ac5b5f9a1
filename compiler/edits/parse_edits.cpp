#include "compiler/edits/parse_edits.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <span>
#include <tuple>

#include "compiler/contract/texts/nearest_name.h"
#include "compiler/contract/texts/parse.h"
#include "compiler/contract/texts/utf8.h"
#include "compiler/edits/new_element_id.h"
#include "compiler/edits/parse_filter.h"
#include "compiler/edits/split_line.h"
#include "compiler/source/format/plain_words.h"
#include "compiler/source/read_texts.h"

namespace citykiln::edits {
namespace {

constexpr std::array<std::string_view, 5> kVerbs = {"drop", "set", "remove", "move", "place"};

bool is_verb(const Word& word) { return std::ranges::find(kVerbs, word.plain) != kVerbs.end(); }

Error expected_after(const Word& word, std::string_view what) {
  return {fmt::format("{}", word.column),
          fmt::format("expected {} after \"{}\", found the end of the line", what, word.text)};
}

using KeyAndValue = std::pair<std::string, std::string>;

Result<KeyAndValue> parse_set_tag(const Word& word) {
  const std::size_t equal = word.plain.find('=');
  if (equal == std::string::npos || equal == 0) return expected_at(word, "a tag such as height=12");
  const std::string key = word.text.substr(0, equal), value = word.text.substr(equal + 1);
  if (value.empty()) return expected_at(word, fmt::format("a value after = (\"remove {}\" takes a tag away)", key));
  return KeyAndValue{key, source::plain_word(key, value)};
}

Result<std::string> parse_removed_key(const Word& word) {
  if (word.plain.find('=') != std::string::npos)
    return expected_at(word, "the key of a tag without its value, such as height");
  return word.text;
}

Result<Vec2> parse_offset(const Word& word) {
  constexpr double kFarthest_m = 10000;
  const auto n = numbers_in<double>(word.text, ',', 2);
  if (!n || std::abs((*n)[0]) > kFarthest_m || std::abs((*n)[1]) > kFarthest_m)
    return expected_at(word, "east,north in metres, up to 10000, such as 2.5,-1");
  return Vec2{(*n)[0], (*n)[1]};
}

// Parses the tags or keys of one verb: all words up to the next verb.
template <typename Value, typename Parse>
Result<Done> parse_list(std::span<const Word>& words, std::string_view what, std::vector<Value>& list, Parse parse) {
  const Word verb = words.front();
  words = words.subspan(1);
  if (words.empty()) return expected_after(verb, what);
  if (is_verb(words.front())) return expected_at(words.front(), what);
  for (; !words.empty() && !is_verb(words.front()); words = words.subspan(1)) {
    Result<Value> value = parse(words.front());
    if (!value) return value.error();
    list.push_back(std::move(*value));
  }
  return Done{};
}

// Parses the one value of a verb.
template <typename Value, typename Parse>
Result<Done> parse_one(std::span<const Word>& words, std::string_view what, std::optional<Value>& target, Parse parse) {
  if (words.size() < 2) return expected_after(words.front(), what);
  Result<Value> value = parse(words[1]);
  if (!value) return value.error();
  target = *value, words = words.subspan(2);
  return Done{};
}

// "place" moves one node: the filter is its id.
bool is_one_node(const Filter& filter) {
  return filter.size() == 1 && !filter[0].is_negated && filter[0].ids.size() == 1 &&
         filter[0].ids[0].type == OsmType::kNode;
}

// Parses a tag of "set", whose key the line has not set before.
Result<KeyAndValue> parse_new_tag(const Word& word, const Changes& changes) {
  Result<KeyAndValue> tag = parse_set_tag(word);
  if (tag && std::ranges::find(changes.set, tag->first, &KeyAndValue::first) != changes.set.end())
    return expected_at(word, fmt::format("{} once in a line", tag->first));
  return tag;
}

Result<Done> parse_verb(std::span<const Word>& words, Edit& edit) {
  Changes& changes = edit.changes;
  const Word& verb = words.front();
  if (changes.is_dropped || (verb.plain == "drop" && (changes.changes_tags() || changes.changes_places())))
    return expected_at(verb, "drop as the only change of a line");
  if (verb.plain == "set")
    return parse_list(words, "a tag such as height=12", changes.set,
                      [&](const Word& word) { return parse_new_tag(word, changes); });
  if (verb.plain == "remove") return parse_list(words, "the key of a tag", changes.removed, parse_removed_key);
  if (verb.plain == "move") return parse_one(words, "east,north in metres", changes.moved_m, parse_offset);
  if (verb.plain == "place") {
    if (!is_one_node(edit.filter)) return expected_at(verb, "the id of one node alone before \"place\"");
    return parse_one(words, "longitude,latitude in degrees", changes.placed, parse_place);
  }
  changes.is_dropped = true, words = words.subspan(1);
  return Done{};
}

Error expected_verb(const Word& word) {
  const std::vector<std::string> verbs(kVerbs.begin(), kVerbs.end());
  Error error = expected_at(word, "drop, set, remove, move or place");
  error.message += did_you_mean(word.text, verbs);
  return error;
}

// The error of the first word that is almost a verb, such as "sets"; nothing if there is none. Filters have keys alone,
// so that a mistyped verb is only found by what follows it.
std::optional<Error> mistyped_verb(std::span<const Word> words) {
  const std::vector<std::string> verbs(kVerbs.begin(), kVerbs.end());
  for (const Word& word : words)
    if (!nearest_name(word.text, verbs).empty()) return expected_verb(word);
  return std::nullopt;
}

Error without_verb(std::span<const Word> words) {
  if (const std::optional<Error> mistyped = mistyped_verb(words)) return *mistyped;
  const Word& last = words.back();
  return {fmt::format("{}", last.column),
          fmt::format("expected drop, set, remove, move or place after the filter, found \"{}\" at the end of the line",
                      last.text)};
}

Result<Edit> parse_change(std::span<const Word> words) {
  Edit edit;
  const std::span<const Word> all = words;
  for (; !words.empty() && !is_verb(words.front()); words = words.subspan(1)) {
    if (words.front().plain == "and" || words.front().plain == "or")
      return expected_at(words.front(), "words of a filter side by side, all of which must fit (\"a,b\" lists values)");
    Result<Condition> condition = parse_condition(words.front());
    if (!condition) return mistyped_verb(all.first(edit.filter.size())).value_or(condition.error());
    edit.filter.push_back(std::move(*condition));
  }
  if (words.empty()) return without_verb(all);
  if (edit.filter.empty()) return expected_at(words.front(), "a filter, such as w123 or building=garage, or add");
  while (!words.empty()) {
    if (!is_verb(words.front())) return expected_verb(words.front());
    if (const Result<Done> done = parse_verb(words, edit); !done) return done.error();
  }
  return edit;
}

bool is_point(const Word& word) { return word.plain.find('=') == std::string::npos; }

Result<NewPoint> parse_point(const Word& word) {
  if (begins_as_id(word)) {
    const Result<std::vector<OsmId>> ids = parse_ids(word);
    if (!ids) return ids.error();
    if (ids->size() != 1 || ids->front().type != OsmType::kNode)
      return expected_at(word, "a place such as 7.42,43.73 or a node such as n5");
    return NewPoint{ids->front().id, {}};
  }
  const Result<source::Location> at = parse_place(word);
  if (!at) return expected_at(word, "a place such as 7.42,43.73, a node such as n5, or a tag such as highway=footway");
  return NewPoint{std::nullopt, *at};
}

bool is_same_point(const NewPoint& a, const NewPoint& b) { return a.node == b.node && a.at == b.at; }

// The kind of a new element after "add", and its fewest points.
struct NewKind {
  std::string_view letter;
  OsmType type;
  bool is_area;
  std::size_t fewest;
  std::string_view points;
};
constexpr std::array kNewKinds = {NewKind{"n", OsmType::kNode, false, 1, "one place such as 7.42,43.73"},
                                  NewKind{"w", OsmType::kWay, false, 2, "at least two points"},
                                  NewKind{"a", OsmType::kWay, true, 3, "at least three points"}};

Result<Done> check_points(const NewKind& kind, const NewElement& added, const Word& after) {
  const bool has_too_many = kind.letter == "n" && added.points.size() > 1;
  if (added.points.size() < kind.fewest || has_too_many)
    return Error{fmt::format("{}", after.column),
                 fmt::format("expected {} of \"add {}\", found {}", kind.points, kind.letter, added.points.size())};
  if (kind.letter == "n" && added.points[0].node)
    return expected_at(after,
                       "a place of the new node, such as 7.42,43.73 (a node of the map is changed by \"n5 set\")");
  return Done{};
}

Result<Edit> parse_add(std::span<const Word> words) {
  if (words.size() < 2) return expected_after(words.front(), "n, w or a (a node, a line, an area)");
  const auto kind = std::ranges::find(kNewKinds, std::string_view(words[1].plain), &NewKind::letter);
  if (kind == kNewKinds.end()) return expected_at(words[1], "n, w or a (a node, a line, an area) after \"add\"");
  NewElement added{.id = {}, .is_area = kind->is_area};
  std::size_t i = 2;
  for (; i < words.size() && is_point(words[i]); ++i) {
    Result<NewPoint> point = parse_point(words[i]);
    if (!point) return point.error();
    added.points.push_back(*point);
  }
  if (kind->is_area && added.points.size() > 3 && is_same_point(added.points.front(), added.points.back()))
    added.points.pop_back();
  if (const Result<Done> done = check_points(*kind, added, words[added.points.empty() ? 1 : 2]); !done)
    return done.error();
  if (i == words.size()) return expected_after(words.back(), "tags such as highway=footway");
  for (; i < words.size(); ++i) {
    Result<KeyAndValue> tag = parse_set_tag(words[i]);
    if (!tag) return tag.error();
    added.tags.push_back(std::move(*tag));
  }
  added.id.type = kind->type;
  Edit edit;
  edit.added = std::move(added);
  return edit;
}

// Gives new elements their ids. Elements with equal points differ by their order.
void number_new_elements(Edits& edits) {
  std::map<OsmId, std::uint32_t> equals;
  for (Edit& edit : edits.lines) {
    if (!edit.added) continue;
    NewElement& added = *edit.added;
    const std::uint32_t ordinal = equals[new_element_id(added.id.type, added.is_area, added.points, 0)]++;
    added.id = new_element_id(added.id.type, added.is_area, added.points, ordinal);
  }
}

// FNV-1a, 64 bits.
std::uint64_t hash_of_text(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

Result<std::optional<Edit>> parse_line(std::string_view line) {
  if (!is_utf8(line)) return Error{"1", "expected text in UTF-8, found other bytes"};
  const Result<std::vector<Word>> words = split_line(line);
  if (!words) return words.error();
  if (words->empty()) return std::optional<Edit>{};
  Result<Edit> edit = words->front().plain == "add" ? parse_add(*words) : parse_change(*words);
  if (!edit) return edit.error();
  edit->column = words->front().column;
  return std::optional(std::move(*edit));
}

}  // namespace

Result<Edits> parse_edits(std::string_view text, const std::string& file) {
  Edits edits{.name = std::filesystem::path(file).filename().string(), .hash = hash_of_text(text), .lines = {}};
  std::uint32_t number = 0;
  for (const std::string_view line : split(source::without_byte_order_mark(text), '\n')) {
    ++number;
    Result<std::optional<Edit>> edit = parse_line(line);
    if (!edit) return Error{fmt::format("{}:{}:{}", file, number, edit.error().where), edit.error().message};
    if (!*edit) continue;
    (*edit)->line = number;
    edits.lines.push_back(std::move(**edit));
  }
  number_new_elements(edits);
  return edits;
}

Result<Edits> read_edits(const std::string& path) {
  std::error_code none;
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path, none)) return Error{path, "the file cannot be read"};
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  return parse_edits(text, path);
}

}  // namespace citykiln::edits
