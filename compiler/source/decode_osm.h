// A whole OSM file decoded into memory by libosmium, once; all later steps work on these buffers.
#pragma once

#include <optional>
#include <osmium/memory/buffer.hpp>
#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/source/osm_data.h"

namespace citykiln::source {

/// Elements in the order of the file.
struct DecodedOsm {
  std::vector<osmium::memory::Buffer> buffers;
  std::optional<LonLatBox> header_box;
};

/// Errors as read_osm's. Memory: about 25 times a PBF file's size, about the size of plain XML.
Result<DecodedOsm> decode_osm(const std::string& path, int threads);

}  // namespace citykiln::source
