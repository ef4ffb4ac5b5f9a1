#include "compiler/map/tags/tag_values.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <string>

namespace citykiln::map {
namespace {

struct Colour {
  std::string_view name;
  Srgb srgb;
};

constexpr Colour kNamedColours[] = {
#define COLOUR(name, red, green, blue) {name, {red, green, blue}},
#include "compiler/map/tags/colours.inc"
#undef COLOUR
};

std::string_view first_value(std::string_view text) {
  text = text.substr(0, text.find(';'));
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

// Takes a number off the front of the text.
std::optional<double> take_number(std::string_view& text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  std::string digits(text.substr(0, text.find_first_not_of("0123456789.,-+")));
  const std::size_t taken = digits.size();
  for (char& c : digits) c = c == ',' ? '.' : c;
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value)) return std::nullopt;
  text = first_value(text.substr(taken));
  return value;
}

std::optional<std::uint8_t> hex_byte(std::string_view digits) {
  unsigned value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return static_cast<std::uint8_t>(digits.size() == 1 ? value * 17 : value);
}

// Digits of "rgb", "rgba", "rrggbb" or "rrggbbaa"; the opacity must be readable, and is ignored.
std::optional<Srgb> hex_colour(std::string_view digits) {
  const std::size_t width = digits.size() < 6 ? 1 : 2, count = digits.size() / width;
  if (digits.size() % width != 0 || count < 3 || count > 4) return std::nullopt;
  std::optional<std::uint8_t> bytes[4];
  for (std::size_t i = 0; i < count; ++i) {
    bytes[i] = hex_byte(digits.substr(i * width, width));
    if (!bytes[i]) return std::nullopt;
  }
  return Srgb{*bytes[0], *bytes[1], *bytes[2]};
}

bool is_between_channels(char c) { return c == ' ' || c == ',' || c == '/'; }

// Takes "178", "70%" or "0.5" off the front of the text, and the spaces and commas before it. Percent are of `whole`.
std::optional<double> take_channel(std::string_view& text, double whole) {
  while (!text.empty() && is_between_channels(text.front())) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
  if (error != std::errc() || !(value >= 0)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  const bool is_percent = text.starts_with('%');
  if (is_percent) text.remove_prefix(1);
  return std::min(is_percent ? value / 100 * whole : value, whole);
}

// "rgb(178, 50, 40)" or "rgba(70% 20% 16% / 0.5)", in small letters.
std::optional<Srgb> function_colour(std::string_view text) {
  text.remove_prefix(text.starts_with("rgba(") ? 5 : 4);
  if (!text.ends_with(')')) return std::nullopt;
  text.remove_suffix(1);
  const auto r = take_channel(text, 255), g = take_channel(text, 255), b = take_channel(text, 255);
  while (!text.empty() && is_between_channels(text.front())) text.remove_prefix(1);
  if (!r || !g || !b || (!text.empty() && !take_channel(text, 1)) || !text.empty()) return std::nullopt;
  const auto byte = [](double channel) { return static_cast<std::uint8_t>(channel + 0.5); };
  return Srgb{byte(*r), byte(*g), byte(*b)};
}

// "south-west" becomes "SW"; texts of up to three letters are initials already.
std::string initials_of(std::string_view value) {
  std::string wind;
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto upper = [](char c) { return static_cast<char>(c >= 'a' ? c - 'a' + 'A' : c); };
  std::string letters;
  for (const char c : value)
    if (is_letter(c)) letters += upper(c);
  if (letters.size() <= 3) return letters;
  for (std::string_view rest = letters; !rest.empty();) {
    const std::string_view word = rest.starts_with("NORTH")   ? "NORTH"
                                  : rest.starts_with("SOUTH") ? "SOUTH"
                                  : rest.starts_with("EAST")  ? "EAST"
                                  : rest.starts_with("WEST")  ? "WEST"
                                                              : "";
    if (word.empty()) return "";
    wind += word.front();
    rest.remove_prefix(word.size());
  }
  return wind;
}

constexpr double kFoot_m = 0.3048, kInch_m = 0.0254, kLongest_m = 10000;

struct UnitRow {
  std::string_view value;
  double length_m;
};
constexpr UnitRow kUnits[] = {{"m", 1},        {"metre", 1},      {"metres", 1},      {"meter", 1},
                              {"meters", 1},   {"mts", 1},        {"mtr", 1},         {"mt", 1},
                              {"m.", 1},       {"km", 1000},      {"cm", 0.01},       {"mm", 0.001},
                              {"ft", kFoot_m}, {"ft.", kFoot_m},  {"feet", kFoot_m},  {"foot", kFoot_m},
                              {"in", kInch_m}, {"inch", kInch_m}, {"inches", kInch_m}};

// Apostrophe, prime and closing quotation mark; two of them, or their double forms, are inches.
constexpr std::string_view kFeetMarks[] = {"'", "\xe2\x80\xb2", "\xe2\x80\x99"};
constexpr std::string_view kInchMarks[] = {"\"", "''", "\xe2\x80\xb3", "\xe2\x80\x9d"};

// The length of the mark with which the text begins; 0 if there is none.
template <std::size_t n>
std::size_t mark_at_front(const std::string_view (&marks)[n], std::string_view text) {
  for (const std::string_view mark : marks)
    if (text.starts_with(mark)) return mark.size();
  return 0;
}

// The text without a sign or word for degrees at its end.
std::string_view without_degrees(std::string_view text) {
  for (const std::string_view unit : {"\xc2\xb0", "degrees", "deg"})
    if (text.ends_with(unit)) text.remove_suffix(unit.size());
  return first_value(text);
}

}  // namespace

std::optional<double> number_of(std::string_view value) {
  value = first_value(value);
  const auto number = take_number(value);
  return value.empty() ? number : std::nullopt;
}

std::optional<double> length_m_of(std::string_view value) {
  value = first_value(value);
  auto number = take_number(value);
  if (!number) return std::nullopt;
  const bool is_inches = !value.empty() && mark_at_front(kInchMarks, value) == value.size();
  if (const std::size_t mark = mark_at_front(kFeetMarks, value); mark > 0 && !is_inches) {
    value = first_value(value.substr(mark));
    const auto inches = take_number(value);
    *number = *number * kFoot_m + inches.value_or(0) * kInch_m;
  } else if (is_inches) {
    *number *= kInch_m;
  } else if (const UnitRow* row = row_with(kUnits, in_lower_case(value))) {
    *number *= row->length_m;
  } else if (!value.empty()) {
    return std::nullopt;
  }
  if (!(std::abs(*number) < kLongest_m)) return std::nullopt;
  return number;
}

std::optional<Srgb> colour_of(std::string_view value) {
  value = first_value(value);
  const std::string lower = in_lower_case(value);
  if (lower.starts_with("rgb(") || lower.starts_with("rgba(")) return function_colour(lower);
  value = first_value(value.substr(0, value.find_first_of("/,")));
  if (!value.empty() && value.front() == '#') return hex_colour(value.substr(1));
  std::string name;
  for (const char c : in_lower_case(value))
    if (c != ' ' && c != '_' && c != '-') name += c;
  for (const Colour& colour : kNamedColours)
    if (colour.name == name) return colour.srgb;
  // four or eight digits without # are more often a number of some catalogue
  return name.size() == 3 || name.size() == 6 ? hex_colour(name) : std::nullopt;
}

std::optional<double> bearing_deg_of(std::string_view value) {
  constexpr std::string_view kWinds[] = {"N", "NNE", "NE", "ENE", "E", "ESE", "SE", "SSE",
                                         "S", "SSW", "SW", "WSW", "W", "WNW", "NW", "NNW"};
  const std::string wind = initials_of(first_value(value));
  for (std::size_t i = 0; i < std::size(kWinds); ++i)
    if (kWinds[i] == wind) return 22.5 * static_cast<double>(i);
  const auto number = number_of(without_degrees(first_value(value)));
  if (!number || !(std::abs(*number) <= 360)) return std::nullopt;
  return *number < 0 ? *number + 360 : *number == 360 ? 0 : *number;
}

std::optional<std::uint16_t> year_of(std::string_view value) {
  value = first_value(value);
  const std::size_t first = value.find_first_of("0123456789");
  if (first == std::string_view::npos) return std::nullopt;
  const bool is_century = first > 0 && (value[first - 1] == 'C' || value[first - 1] == 'c');
  const std::string_view digits = value.substr(first, value.find_first_not_of("0123456789", first) - first);
  unsigned number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  if (is_century) return number >= 1 && number <= 29 ? std::optional<std::uint16_t>(number * 100 - 50) : std::nullopt;
  if (digits.size() < 3 || number < 1 || number > 2999) return std::nullopt;
  const bool is_decade = value.substr(first + digits.size()).starts_with('s');
  return static_cast<std::uint16_t>(is_decade ? number + 5 : number);
}

std::string in_lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return lower;
}

std::vector<std::string> words_of(std::string_view value) {
  std::vector<std::string> words(1);
  for (const char c : in_lower_case(value)) {
    std::string& word = words.back();
    if (c == ';' || c == ',' || c == '/')
      words.emplace_back();
    else if (c != '-' && c != '_' && c != ' ' && c != '\t' && c != '\n')
      word += c;
    else if (!word.empty() && word.back() != '_')
      word += '_';
  }
  for (std::string& word : words)
    if (word.ends_with('_')) word.pop_back();
  std::erase(words, "");
  return words;
}

bool is_indefinite(std::string_view word) {
  constexpr std::string_view kIndefinite[] = {"yes",      "no",    "none",        "many",    "mixed",
                                              "multiple", "other", "unspecified", "unknown", "various"};
  return std::ranges::find(kIndefinite, word) != std::end(kIndefinite);
}

bool says_yes(std::string_view value) { return !value.empty() && value != "no" && value != "0" && value != "false"; }

}  // namespace citykiln::map
