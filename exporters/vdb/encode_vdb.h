// Writes voxels as an OpenVDB file.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/sky/clouds/cloud_voxels.h"

namespace citykiln::exporters {

/// Returns a .vdb file with one fog volume, "density": the extinction per metre, in half precision. Its transform
/// places it in the plane, z up. The random id in the file's header is overwritten by zeros, so the same voxels give
/// the same bytes. Errors: the module citykiln_vdb.so, or OpenVDB, which the module needs, is missing.
Result<std::vector<std::byte>> encode_vdb(const sky::CloudVoxels& voxels);

}  // namespace citykiln::exporters
