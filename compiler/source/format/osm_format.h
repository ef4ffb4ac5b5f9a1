// Detects the format of an OSM file, and PBF files that are cut off, before decoding, so that errors are clear.
#pragma once

#include <string>

#include "compiler/contract/result.h"

namespace citykiln::source {

enum class OsmFormat { kXml, kXmlGzip, kXmlBzip2, kPbf };

/// Returns the format by the file's suffix (.osm, .xml, each also with .gz or .bz2; .pbf). The file's first bytes must
/// have this format, and a PBF file must be as long as its blob headers state. Errors: a missing, unreadable or empty
/// file, an unknown suffix, contents of another format, a PBF file that is cut off (with the byte). Cost: one read of
/// 64 bytes; for PBF also a seek and a short read per blob.
Result<OsmFormat> osm_format_of(const std::string& path);

/// Returns the message of a library's error while a file is read; of one at the end of a file, also what to do:
/// "unclosed token; the file is cut off: load it again".
std::string reading_error(const std::string& message);

/// Returns the error of a file that holds changes of a map (.osc), with what to do.
Error change_file_error(const std::string& path);

}  // namespace citykiln::source
