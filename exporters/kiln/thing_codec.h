// Reads and writes the things of a chunk (the recipes of one tile): the forms of all things, each once, then the
// things. `io` is a Writer, a Reader or a probe (chunk_io.h).
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

#include "compiler/contract/erase_repeated.h"
#include "compiler/things/recipe.h"
#include "exporters/kiln/member_codecs.h"

namespace citykiln::exporters {

/// The words of a chunk's forms in the order in which they appear; the first one is empty.
struct WordList {
  std::vector<std::string> words = {""};
  std::map<std::string, std::size_t> numbers = {{"", 0}};
};

/// The largest size of a word, and of a thing.
inline constexpr std::size_t kMostWordBytes = 255;
inline constexpr double kLargestThing_m = 1024;

/// A word: its number in the list. The number after the last one means a new word, which follows.
void word(auto& io, WordList& list, std::string& value) {
  const auto found = list.numbers.find(value);
  std::size_t number = found == list.numbers.end() ? list.words.size() : found->second;
  io.number("thing word", number);
  const bool is_new = number == list.words.size();
  if (is_new) io.text("thing word size", "thing word bytes", value);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (number > list.words.size() || value.size() > kMostWordBytes) return io.fail("thing word");
  if (is_new) list.numbers.emplace(value, list.words.size()), list.words.push_back(value);
  value = list.words[number];
}

/// Reads or writes a colour: 0 for none, else 1 + its 24 bits.
void thing_colour(auto& io, std::optional<map::Srgb>& colour) {
  std::uint32_t number = colour ? 1 + ((*colour)[0] << 16 | (*colour)[1] << 8 | (*colour)[2]) : 0;
  io.number("thing colour", number);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads) {
    if (number > 1u << 24) io.fail("thing colour"), number = 0;
    const std::uint32_t bits = number - 1;
    colour.reset();
    if (number > 0)
      colour = map::Srgb{static_cast<std::uint8_t>(bits >> 16), static_cast<std::uint8_t>(bits >> 8 & 255),
                         static_cast<std::uint8_t>(bits & 255)};
  }
}

void thing_length(auto& io, double& length_m) {
  io.metres("thing size", length_m);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (!(length_m > 0 && length_m <= kLargestThing_m)) io.fail("thing size"), length_m = 1;
}

void serialise(auto& io, things::Form& form, WordList& words) {
  word(io, words, form.kind);
  thing_length(io, form.width_m), thing_length(io, form.depth_m), thing_length(io, form.height_m);
  word(io, words, form.value), word(io, words, form.material), word(io, words, form.text);
  thing_colour(io, form.colour);
  io.number("thing capacity", form.capacity);
  enumerator(io, "thing country", form.country, map::CountryGroup::kCount);
  io.number("thing variant", form.variant);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (form.variant >= things::kVariants) io.fail("thing variant"), form.variant = 0;
}

/// The things of a chunk.
void things(auto& io, std::vector<things::Thing>& all) {
  constexpr bool kReads = std::remove_reference_t<decltype(io)>::kReads;
  std::vector<things::Form> forms;
  for (const things::Thing& thing : all) forms.push_back(thing.form);
  sort_unique(forms);
  WordList words;
  list(io, "thing forms", forms, 0, [&](things::Form& form) { serialise(io, form, words); });
  list(io, "things", all, 0, [&](things::Thing& thing) {
    id(io, thing.id);
    io.point(thing.at);
    auto number = static_cast<std::size_t>(std::ranges::lower_bound(forms, thing.form) - forms.begin());
    io.number("thing form", number);
    io.number("thing direction", thing.direction);
    bool is_on_roof = thing.foot_m.has_value();
    flags(io, "thing traits", thing.is_in_way, is_on_roof);
    if constexpr (kReads) thing.foot_m = is_on_roof ? std::optional(0.0) : std::nullopt;
    if (is_on_roof) io.metres("thing size", *thing.foot_m);
    if constexpr (kReads) {
      if (thing.direction >= things::kDirections) io.fail("thing direction"), thing.direction = 0;
      if (number >= forms.size()) return io.fail("thing form");
      thing.form = forms[number];
    }
  });
}

}  // namespace citykiln::exporters
