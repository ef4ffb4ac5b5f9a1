// Rewrites XML that libosmium cannot read as it is meant: UTF-16; elements that JOSM marks action="delete"; places in
// the nodes of ways and in the members of relations, as Overpass writes them with `out geom`.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "compiler/contract/result.h"
#include "compiler/source/osm_format.h"

namespace citykiln::source {

/// Returns UTF-8 of a text in UTF-16 with a byte order mark, or one whose first character is "<" in two bytes; else
/// nothing. Halves of pairs without the other half become U+FFFD. An encoding in the XML declaration is left out.
std::optional<std::string> utf8_of_utf16(std::string_view bytes);

/// Returns an .osm document of plain elements; nothing if the text is one already.
///
/// - An element with action="delete" has visible="false".
/// - A node of a way with lat and lon is a node of the document, unless the document contains it.
/// - A member of a relation with nodes of its own is a way, unless the document contains it. Its nodes have numbers
/// made
///   of their places.
/// - Centres of elements (`out center`) are left out.
/// The new nodes come before all elements, and the new ways before the relations. O(text).
std::optional<std::string> mended_elements(std::string_view text);

/// Returns the text to decode instead of the file's; nothing if the file can be decoded as it is, or is no XML. Reads
/// the file once. Errors: a compressed file that cannot be read.
Result<std::optional<std::string>> mended_xml(const std::string& path, OsmFormat format);

}  // namespace citykiln::source
