// Decodes a whole OSM file into libosmium's memory buffers. All later steps of reading work on these buffers.
#pragma once

#include <optional>
#include <osmium/memory/buffer.hpp>
#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/source/osm_data.h"

namespace citykiln::source {

/// The elements of a file, in the order of the file.
struct DecodedOsm {
  std::vector<osmium::memory::Buffer> buffers;
  std::optional<LonLatBox> header_box;
  bool is_of_region = false;        ///< The file is one that cut_extract() wrote.
  bool has_places_in_ways = false;  ///< Ways hold the locations of their nodes (LocationsOnWays in the header).
};

/// Reads and decodes a file. Errors: those of read_osm(). Memory: about 25 times the size of a PBF file, or about the
/// size of plain XML.
Result<DecodedOsm> decode_osm(const std::string& path, int threads);

}  // namespace citykiln::source
