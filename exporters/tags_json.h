// The tags of an element as the text of a JSON object, in files that have such texts.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "compiler/map/tag_list.h"

namespace citykiln::exporters {

/// Returns an object of strings, such as {"building":"yes"}, without spaces and in the order of the tags; "" without
/// tags. Texts of tags are valid UTF-8.
std::string tags_text(const map::TagList& tags);

/// Returns the tags, sorted by key; none for "". Nothing unless the text is an object of strings without zero bytes.
std::optional<map::TagList> tags_in(std::string_view json);

}  // namespace citykiln::exporters
