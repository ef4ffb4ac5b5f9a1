// Rewrites OSM files that libosmium would not read as intended. In XML: text in UTF-16; elements that JOSM marks with
// action="delete"; coordinates inside ways and members of relations, as Overpass writes them with `out geom`; elements
// that are not part of the format. In PBF: blobs that mended_pbf.h rewrites.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "compiler/contract/result.h"
#include "compiler/source/format/osm_format.h"

namespace citykiln::source {

/// Returns the text in UTF-8 if it is in UTF-16, else nothing. UTF-16 begins with a byte order mark, or with "<" in two
/// bytes. A surrogate without its other half becomes U+FFFD. The encoding is removed from the XML declaration.
/// O(bytes).
std::optional<std::string> utf8_of_utf16(std::string_view bytes);

/// Returns the document as plain nodes, ways and relations; nothing if it needs no change. It does not validate the
/// XML.
///
/// - An element with action="delete" gets visible="false".
/// - A node reference of a way with lat and lon becomes a node, unless the document contains that node.
/// - A member of a relation with nodes of its own becomes a way, unless the document contains that way. Its nodes get
///   ids that follow from their coordinates.
/// - Centres of elements (`out center`), and elements that the format does not have, such as <count> and <remark> of
///   Overpass, are removed with all they hold.
///
/// The new nodes come before all elements, and the new ways before the relations. O(text).
std::optional<std::string> mended_elements(std::string_view text);

/// Reads a file and returns the bytes to decode instead of it; nothing if the file can be decoded as it is. XML may be
/// plain or packed with gzip or bzip2; the whole unpacked text is held in memory, and the result is unpacked. A PBF
/// file is left to mended_pbf().
///
/// @param format  The result of osm_format_of() for this file.
///
/// Errors: a file that cannot be read, be it plain or packed; a file of changes (.osc); for PBF the errors of
/// mended_pbf().
Result<std::optional<std::string>> mended_file(const std::string& path, OsmFormat format);

}  // namespace citykiln::source
