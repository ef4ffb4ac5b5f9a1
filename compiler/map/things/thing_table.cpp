#include "compiler/map/things/thing_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "compiler/contract/texts/parse.h"

namespace citykiln::map {
namespace {

constexpr std::array<std::string_view, 9> kColumns = {"name",  "tags",   "rule",   "size", "stands",
                                                      "faces", "clears", "detail", "class"};
constexpr std::array<std::string_view, 7> kStandWords = {"ground", "pole",    "wall",        "over_road",
                                                         "in_way", "on_roof", "through_roof"};
constexpr std::array<std::string_view, 6> kFacingWords = {"tag", "street", "along", "platform", "arms", "any"};
constexpr double kLargest_m = 500;

Error wrong_column(std::string_view column, std::string_view expected, std::string_view found) {
  return {"", fmt::format("{}: expected {}, found \"{}\"", column, expected, found)};
}

bool is_word(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
}

std::optional<TaggedLength> length_of(std::string_view text) {
  const std::size_t colon = text.rfind(':');
  const bool has_key = colon != std::string_view::npos;
  const auto default_m = number_in<double>(has_key ? text.substr(colon + 1) : text);
  if (!default_m || !(*default_m > 0) || *default_m > kLargest_m || (has_key && colon == 0)) return std::nullopt;
  return TaggedLength{std::string(has_key ? text.substr(0, colon) : ""), *default_m};
}

// Splits "1.6x0.5xheight:0.8" at each x after a digit.
std::vector<std::string_view> lengths_in(std::string_view text) {
  std::vector<std::string_view> parts;
  std::size_t begin = 0;
  for (std::size_t i = 1; i < text.size(); ++i)
    if (text[i] == 'x' && text[i - 1] >= '0' && text[i - 1] <= '9')
      parts.push_back(text.substr(begin, i - begin)), begin = i + 1;
  parts.push_back(text.substr(begin));
  return parts;
}

Result<Done> read_size(std::string_view text, ThingRow& row) {
  const std::vector<std::string_view> parts = lengths_in(text);
  std::array<TaggedLength*, 3> lengths = {&row.width, &row.depth, &row.height};
  bool is_good = parts.size() == lengths.size();
  for (std::size_t i = 0; is_good && i < lengths.size(); ++i) {
    const std::optional<TaggedLength> length = length_of(parts[i]);
    is_good = length.has_value();
    if (length) *lengths[i] = *length;
  }
  if (is_good) return Done{};
  return wrong_column("size", "width x depth x height in metres, such as 1.6x0.5x0.8 or 0.3x0.3xheight:4", text);
}

template <typename Enum, std::size_t n>
Result<Enum> enum_of(std::string_view column, const std::array<std::string_view, n>& words, std::string_view text) {
  const auto found = std::ranges::find(words, text);
  if (found == words.end()) return wrong_column(column, fmt::format("{}", fmt::join(words, ", ")), text);
  return static_cast<Enum>(found - words.begin());
}

Result<double> metres_of(std::string_view column, std::string_view text) {
  const auto metres = number_in<double>(text);
  if (metres && *metres >= 0 && *metres <= kLargest_m) return *metres;
  return wrong_column(column, "metres, such as 0.5", text);
}

Result<ThingRow> thing_row_of(const std::vector<std::string_view>& words) {
  if (words.size() != kColumns.size())
    return Error{"", fmt::format("expected {} columns ({}), found {}", kColumns.size(), fmt::join(kColumns, ", "),
                                 words.size())};
  ThingRow row{.name = std::string(words[0]), .rule = std::string(words[2]), .class_name = std::string(words[8])};
  if (!is_word(row.name)) return wrong_column("name", "letters, digits and _", row.name);
  if (!is_word(row.rule)) return wrong_column("rule", "the name of a rule file without .cga", row.rule);
  if (!is_word(row.class_name)) return wrong_column("class", "letters, digits and _", row.class_name);
  Result<std::vector<std::vector<TagTest>>> tags = words[1] == kNoTags ? TagTests{} : read_tag_tests(words[1]);
  if (!tags) return tags.error();
  row.tags = std::move(*tags);
  if (const Result<Done> done = read_size(words[3], row); !done) return done.error();
  const Result<Stand> stand = enum_of<Stand>("stands", kStandWords, words[4]);
  if (!stand) return stand.error();
  const Result<Facing> facing = enum_of<Facing>("faces", kFacingWords, words[5]);
  if (!facing) return facing.error();
  const Result<double> clear_m = metres_of("clears", words[6]);
  if (!clear_m) return clear_m.error();
  row.stand = *stand, row.facing = *facing, row.clear_m = *clear_m;
  if (words[7] == "size") return row;
  const Result<double> detail_m = metres_of("detail", words[7]);
  if (!detail_m) return wrong_column("detail", "metres, such as 2.5, or size", words[7]);
  row.detail_m = *detail_m;
  return row;
}

}  // namespace

Result<ThingTable> read_thing_table(std::string_view text, const std::string& file) {
  ThingTable table;
  std::size_t number = 0;
  for (const std::string_view line : split(text, '\n')) {
    ++number;
    const std::vector<std::string_view> words = words_in(line.substr(0, line.find('#')));
    if (words.empty()) continue;
    const std::string place = fmt::format("{}:{}", file, number);
    Result<ThingRow> row = thing_row_of(words);
    if (!row) return Error{place, row.error().message};
    if (std::ranges::find(table, row->name, &ThingRow::name) != table.end())
      return Error{place, fmt::format("the name \"{}\" is used twice", row->name)};
    row->line = fmt::format("{}", fmt::join(words, " "));
    table.push_back(std::move(*row));
  }
  return table;
}

ThingTable merged(ThingTable own, const ThingTable& shipped) {
  for (const ThingRow& row : shipped)
    if (std::ranges::find(own, row.name, &ThingRow::name) == own.end()) own.push_back(row);
  return own;
}

std::optional<std::string_view> matched_value(const ThingRow& row,
                                              const std::function<std::string_view(std::string_view)>& value_of) {
  return fitting_value(row.tags, value_of);
}

}  // namespace citykiln::map
