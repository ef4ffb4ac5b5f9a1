#include "compiler/invent/tiles/street_names.h"

#include <array>

#include "compiler/contract/random_sequence.h"

namespace citykiln::invent {
namespace {

constexpr std::array kStems = {
    "Ahorn",  "Birken",   "Buchen", "Eichen",    "Erlen",   "Eschen",  "Linden",  "Ulmen",   "Wiesen",  "Garten",
    "Mühl",   "Berg",     "Tal",    "Brunnen",   "Kirsch",  "Apfel",   "Rosen",   "Feld",    "Wald",    "Bach",
    "Stein",  "Sand",     "Weiden", "Kastanien", "Amsel",   "Drossel", "Finken",  "Lerchen", "Meisen",  "Schwalben",
    "Falken", "Storchen", "Hasel",  "Holunder",  "Ginster", "Tannen",  "Fichten", "Kiefern", "Lärchen", "Pappel"};
constexpr std::array kSmall = {"weg", "gasse", "steig", "winkel", "ring"};
constexpr std::array kMain = {"straße", "allee", "damm", "chaussee", "promenade"};

}  // namespace

std::string street_name(std::uint32_t number, bool is_main, std::uint64_t seed) {
  // a walk through all pairs of stem and ending, begun at a place that the seed draws
  constexpr std::uint32_t kPairs = kStems.size() * kSmall.size();
  const std::uint32_t first = RandomSequence(seed, {}, "street names").below(kPairs, 0);
  // 77 has no divisor in common with the 200 pairs
  const std::uint32_t pair = (first + number * 77) % kPairs;
  const std::string stem = kStems[pair % kStems.size()];
  const std::uint32_t ending = pair / kStems.size();
  return stem + (is_main ? kMain[ending] : kSmall[ending]);
}

}  // namespace citykiln::invent
