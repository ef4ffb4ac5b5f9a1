// Detects the format of an OSM file and truncated PBF files before decoding, to report clear errors.
#pragma once

#include <string>

#include "compiler/contract/result.h"

namespace citykiln::source {

enum class OsmFormat { kXml, kXmlGzip, kXmlBzip2, kPbf };

/// Returns the format by the file's suffix (.osm, .xml, also with .gz or .bz2; .pbf), after comparing it with the
/// file's first bytes and, for PBF, with the sizes in its blob headers. Errors: a missing, unreadable or empty file, an
/// unknown suffix, contents of another format, a truncated PBF file (with the byte). Cost: one read of 64 bytes; for
/// PBF a seek and a short read for each blob.
Result<OsmFormat> osm_format_of(const std::string& path);

}  // namespace citykiln::source
