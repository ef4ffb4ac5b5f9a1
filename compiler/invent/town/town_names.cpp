#include "compiler/invent/town/town_names.h"

#include <array>
#include <set>

#include "compiler/invent/town/draws.h"

namespace citykiln::invent {
namespace {

constexpr std::array kPlaceHeads = {"Har", "Wel",  "Mor", "Lan", "Bre", "Tor", "Gru", "Kess",
                                    "Dor", "Fal",  "Rin", "Sel", "Ost", "Ven", "Alt", "Bor",
                                    "Cam", "Dres", "Ell", "Gol", "Hei", "Jar", "Kal", "Lub"};
constexpr std::array kPlaceMiddles = {"", "", "", "en", "er", "el", "ing", "ols", "in", "um"};
constexpr std::array kPlaceTails = {"ow",   "au",   "itz",   "berg", "stedt", "hain", "dorf", "beck",
                                    "furt", "wald", "hagen", "rode", "see",   "thal", "feld", "bach"};
constexpr std::array kStreetStems = {
    "Linden", "Ahorn",   "Birken",   "Eichen",  "Ulmen",  "Eschen",  "Buchen",   "Kastanien", "Weiden",    "Erlen",
    "Rosen",  "Garten",  "Wiesen",   "Feld",    "Mühlen", "Brunnen", "Berg",     "Tal",       "Schul",     "Kirch",
    "Markt",  "Post",    "Schmiede", "Weber",   "Gerber", "Bäcker",  "Töpfer",   "Fischer",   "Jäger",     "Gärtner",
    "Amsel",  "Drossel", "Finken",   "Lerchen", "Meisen", "Falken",  "Storchen", "Kranich",   "Schwalben", "Sperber",
    "Nord",   "Süd",     "Ost",      "West",    "Ring",   "Wall",    "Tor",      "Turm",      "Hof",       "Anger",
    "Sonnen", "Stern",   "Morgen",   "Abend",   "Sand",   "Stein",   "Lehm",     "Kiesel",    "Hasel",     "Holunder"};
constexpr std::array kSmallEndings = {"weg", "straße", "gasse", "straße", "steig", "pfad"};
constexpr std::array kLargeEndings = {"straße", "allee", "damm", "straße"};

template <std::size_t N>
std::string one_of(const std::array<const char*, N>& words, Draws& draws) {
  return words[draws.below(static_cast<std::uint32_t>(N))];
}

std::string draw_name(StreetClass c, std::uint64_t seed, Draws& draws) {
  if (draws.chance(is_main(c) ? 0.5 : 0.3)) return place_name(seed, 1000 + draws.below(100000)) + "er Straße";
  const std::string stem = one_of(kStreetStems, draws);
  return stem + (is_main(c) ? one_of(kLargeEndings, draws) : one_of(kSmallEndings, draws));
}

}  // namespace

std::string place_name(std::uint64_t seed, std::uint64_t ordinal) {
  Draws draws(seed, "place name", ordinal);
  const std::string head = one_of(kPlaceHeads, draws), middle = one_of(kPlaceMiddles, draws);
  return head + middle + one_of(kPlaceTails, draws);
}

void name_streets(const TownPlan& plan, StreetGraph& graph) {
  std::set<std::string> used;
  for (std::size_t i = 0; i < graph.streets.size(); ++i) {
    Draws draws(plan.settings.seed, "street name", i);
    std::string name = draw_name(graph.streets[i].street_class, plan.settings.seed, draws);
    for (int tries = 0; tries < 12 && used.contains(name); ++tries)
      name = draw_name(StreetClass::kResidential, plan.settings.seed, draws);
    used.insert(name);
    if (graph.streets[i].name.empty()) graph.streets[i].name = std::move(name);
  }
}

}  // namespace citykiln::invent
