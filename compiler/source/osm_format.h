// Which kind of OSM file this is, and whether it is whole, before any decoder looks at it: so that a wrong file ends in
// one clear line.
#pragma once

#include <string>

#include "compiler/contract/result.h"

namespace citykiln::source {

enum class OsmFormat { kXml, kXmlGzip, kXmlBzip2, kPbf };

/// The format that the name promises (.osm, .xml, also with .gz or .bz2; .pbf), checked against the file's first bytes,
/// and for PBF against the sizes that its blob headers state. Errors: a missing, unreadable or empty file, an unknown
/// suffix, contents of another kind, a PBF file cut short (with the byte). Cost: one read of 64 bytes; for PBF one seek
/// and one short read a blob.
Result<OsmFormat> osm_format_of(const std::string& path);

}  // namespace citykiln::source
