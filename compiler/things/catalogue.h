// The catalogue of things: the table's rows and their rule files. The shipped one is compiled into the program from
// grammars/things; a folder given at run time adds to it.
#pragma once

#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "compiler/buildings/styles/rulebook.h"
#include "compiler/contract/result.h"
#include "compiler/map/things/thing_table.h"
#include "compiler/things/recipe.h"
#include "compiler/things/yard_kinds.h"
#include "grammars/language/syntax.h"

namespace citykiln::things {

// Finds which attributes and random numbers the rules of a thing read.

/// The values that rules read.
struct UsedValues {
  std::set<std::string, std::less<>> attributes;
  bool draws = false;  ///< True if a random number is drawn.
};

/// Returns the values that may be read from a rule on: by it, and by all rules, functions and attributes that it leads
/// to. O(program).
UsedValues used_values(const grammars::Program& program, const std::string& start);

using buildings::RuleText;

/// The name of the table's file.
inline constexpr const char* kTableName = "things.txt";

/// A row of the table and its rules.
struct Kind {
  map::ThingRow row;
  grammars::Program rules;
  UsedValues used;  ///< The values that the rules read.
};

/// The kinds by name.
using Kinds = std::map<std::string, Kind, std::less<>>;

/// The table and all rule files. Rules are parsed by kinds_of().
struct Catalogue {
  map::ThingTable table;
  std::vector<RuleText> rules;  ///< Sorted by name.
};

/// Returns the files of grammars/things, which are compiled into the program. Sorted by name.
std::span<const RuleText> shipped_things();

/// Reads a catalogue of shipped files and files that come before them: rows and rules of the same name replace the
/// shipped ones.
/// @param own     Files of a folder: a things.txt, rule files, or both.
/// @param folder  The folder's name, for errors.
/// Errors: those of the table; with files of a folder also those of kinds_of() for all kinds.
Result<Catalogue> read_catalogue(std::span<const RuleText> own, const std::string& folder);

/// Parses the rules of kinds.
/// @param names  The kinds; empty: all of the table.
/// Errors: those of the rules, a row without a rule file, a rule file without the rule Thing.
Result<Kinds> kinds_of(const Catalogue& catalogue, const std::set<std::string>& names = {});

/// Returns what a manifest stores of the catalogue for these things: the rows of their kinds, and those
/// of cars and street furniture that `kinds` has, each under its name; and their rule files, imports included. Sorted
/// by name.
/// @param kinds  The kinds of the things.
/// @param uses   The uses of grounds whose things are drawn when tiles are baked (yard_kinds.h).
std::vector<RuleText> texts_for(const Catalogue& catalogue, const Kinds& kinds, std::span<const Thing> things,
                                std::span<const YardUse> uses = {});

/// Parses the texts of a manifest. Leaves out kinds whose texts are missing or do not parse.
Kinds parse_kinds(std::span<const RuleText> texts);

}  // namespace citykiln::things
