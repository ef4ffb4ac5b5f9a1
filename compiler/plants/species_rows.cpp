#include "compiler/plants/species_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "compiler/contract/texts/parse.h"
#include "compiler/map/plants/plant_kind.h"
#include "compiler/materials/material.h"
#include "compiler/plants/season.h"

namespace citykiln::plants {
namespace {

constexpr std::array<std::string_view, 4> kLeafForms = {"broad", "needle", "palm", "blade"};
constexpr double kLeastHeight_m = 0.05, kMostHeight_m = 40, kLeastCrown = 0.02;
constexpr std::size_t kLongestName = 40;

Error expected(std::string_view key, std::string_view what, std::string_view found) {
  return {"", fmt::format("{}: expected {}, found \"{}\"", key, what, found)};
}

Result<Done> put_number(std::string_view key, std::string_view text, double least, double most,
                        std::optional<double>& value) {
  value = number_in<double>(text);
  if (value && *value >= least && *value <= most) return Done{};
  return expected(key, fmt::format("{} to {}", least, most), text);
}

// "#rrggbb".
std::optional<Thousandths> thousandths_of_srgb(std::string_view text) {
  if (text.size() != 7) return std::nullopt;
  Thousandths colour{};
  for (std::size_t c = 0; c < 3; ++c) {
    std::uint8_t byte = 0;
    const std::string_view digits = text.substr(1 + 2 * c, 2);
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + 2, byte, 16);
    if (problem != std::errc() || end != digits.data() + 2) return std::nullopt;
    colour[c] = static_cast<int>(1000 * materials::linear_of_srgb(byte) + 0.5f);
  }
  return colour;
}

Result<Done> put_colour(std::string_view key, std::string_view text, std::optional<Thousandths>& value) {
  if (text.starts_with('#')) value = thousandths_of_srgb(text);
  if (const auto parts = numbers_in<int>(text, ',', 3);
      parts && std::ranges::all_of(*parts, [](int part) { return part >= 0 && part <= 1000; }))
    value = Thousandths{(*parts)[0], (*parts)[1], (*parts)[2]};
  if (value) return Done{};
  return expected(key, "#rrggbb, or the reflectance of red, green and blue in thousandths, such as 84,165,46", text);
}

Result<Done> put_names(std::string_view text, SpeciesRow& row) {
  for (const std::string_view part : split(text, ',')) {
    row.names.push_back(map::lower_words(part));
    if (row.names.back().empty()) return expected("names", "words of tags, such as populus_tremula,aspen", text);
  }
  return Done{};
}

Result<Done> put_leaf_form(std::string_view text, SpeciesRow& row) {
  const auto found = std::ranges::find(kLeafForms, text);
  if (found == kLeafForms.end()) return expected("leaves", "broad, needle, palm or blade", text);
  row.leaf_form = static_cast<LeafForm>(found - kLeafForms.begin());
  return Done{};
}

Result<Done> put_months(std::string_view text, SpeciesRow& row) {
  if (!are_months(text))
    return expected("months", "12 letters of y s t d l g m h . -, with s in June, such as ...yssssstl.", text);
  row.months = text;
  return Done{};
}

Result<Done> put_like(std::string_view text, SpeciesRow& row) {
  if (std::ranges::find(kSpecies, text, &SpeciesValues::file) == std::end(kSpecies))
    return expected("like", "a shipped species, such as poplar", text);
  row.like = text;
  return Done{};
}

Result<Done> put_value(std::string_view key, std::string_view text, SpeciesRow& row) {
  if (key == "names") return put_names(text, row);
  if (key == "like") return put_like(text, row);
  if (key == "height") return put_number(key, text, kLeastHeight_m, kMostHeight_m, row.height_m);
  if (key == "tallest") return put_number(key, text, kLeastHeight_m, kMostHeight_m, row.tallest_m);
  if (key == "crown") return put_number(key, text, kLeastCrown, kWidestCrown, row.crown_share);
  if (key == "leaves") return put_leaf_form(text, row);
  if (key == "leaf") return put_colour(key, text, row.leaf);
  if (key == "bark") return put_colour(key, text, row.bark);
  if (key == "young_leaf") return put_colour(key, text, row.young_leaf);
  if (key == "turned_leaf") return put_colour(key, text, row.turned_leaf);
  if (key == "months") return put_months(text, row);
  return Error{"", fmt::format("expected names, like, height, tallest, crown, leaves, leaf, bark, young_leaf, "
                               "turned_leaf or months, found \"{}\"",
                               key)};
}

Result<SpeciesRow> species_row_of(const std::vector<std::string_view>& words) {
  SpeciesRow row{.name = std::string(words[0])};
  if (!is_species_name(row.name)) return expected("name", "small letters, digits and _, a letter first", words[0]);
  for (const std::string_view word : std::span(words).subspan(1)) {
    const std::size_t at = word.find('=');
    if (at == std::string_view::npos) return Error{"", fmt::format("expected key=value, found \"{}\"", word)};
    if (const Result<Done> done = put_value(word.substr(0, at), word.substr(at + 1), row); !done) return done.error();
  }
  if (row.height_m && row.tallest_m && *row.tallest_m < *row.height_m)
    return expected("tallest", fmt::format("at least the height, {}", *row.height_m),
                    fmt::format("{}", *row.tallest_m));
  return row;
}

std::string colour_text(std::string_view key, const std::optional<Thousandths>& colour) {
  return colour ? fmt::format(" {}={},{},{}", key, (*colour)[0], (*colour)[1], (*colour)[2]) : "";
}

std::string number_text(std::string_view key, const std::optional<double>& number) {
  return number ? fmt::format(" {}={}", key, *number) : "";
}

}  // namespace

bool is_species_name(std::string_view text) {
  const auto is_small = [](char c) { return c >= 'a' && c <= 'z'; };
  return !text.empty() && text.size() <= kLongestName && is_small(text[0]) &&
         std::ranges::all_of(text, [&](char c) { return is_small(c) || (c >= '0' && c <= '9') || c == '_'; });
}

Result<std::vector<SpeciesRow>> read_species_rows(std::string_view text, const std::string& file) {
  std::vector<SpeciesRow> rows;
  std::size_t number = 0;
  for (const std::string_view line : split(text, '\n')) {
    ++number;
    // a colour begins with # too
    const std::size_t comment = line.starts_with('#') ? 0 : line.find(" #");
    const std::vector<std::string_view> words = words_in(line.substr(0, comment));
    if (words.empty()) continue;
    const std::string place = fmt::format("{}:{}", file, number);
    Result<SpeciesRow> row = species_row_of(words);
    if (!row) return Error{place, row.error().message};
    if (std::ranges::find(rows, row->name, &SpeciesRow::name) != rows.end())
      return Error{place, fmt::format("the name \"{}\" is used twice", row->name)};
    row->place = place;
    rows.push_back(std::move(*row));
  }
  return rows;
}

std::string to_text(const SpeciesRow& row) {
  std::string text = row.name;
  if (!row.like.empty()) text += " like=" + row.like;
  text += number_text("height", row.height_m) + number_text("tallest", row.tallest_m) +
          number_text("crown", row.crown_share);
  if (row.leaf_form) text += fmt::format(" leaves={}", kLeafForms[static_cast<std::size_t>(*row.leaf_form)]);
  text += colour_text("leaf", row.leaf) + colour_text("bark", row.bark) + colour_text("young_leaf", row.young_leaf) +
          colour_text("turned_leaf", row.turned_leaf);
  return row.months.empty() ? text : text + " months=" + row.months;
}

}  // namespace citykiln::plants
