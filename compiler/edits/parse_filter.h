// Parses the words of a filter, which are those of osmium tags-filter, with ids and places besides (edits.md).
#pragma once

#include "compiler/contract/result.h"
#include "compiler/edits/edit.h"
#include "compiler/edits/split_line.h"

namespace citykiln::edits {

/// Returns the error of a word that is not of the expected form; `where` is its column.
Error expected_at(const Word& word, std::string_view what);

/// Returns a place such as "7.42,43.73", or an error that says that one is expected.
Result<source::Location> parse_place(const Word& word);

/// Returns the ids of elements such as "w123,n5"; an error if a part of it is no id.
Result<std::vector<OsmId>> parse_ids(const Word& word);

/// True for words that begin as ids do: n, w or r, then a digit or "-".
bool begins_as_id(const Word& word);

/// Parses one condition: ids, a tag, box=W,S,E,N or near=LON,LAT,M. "!" before it negates it. Values of keys in
/// source/format/word_keys.inc are brought into the spelling in which maps are read. Errors: all other words.
Result<Condition> parse_condition(const Word& word);

}  // namespace citykiln::edits
