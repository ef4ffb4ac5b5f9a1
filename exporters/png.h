// PNG: the texels of a sheet, as files hold them.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/materials/sheet.h"

namespace citykiln::exporters {

/// Row by row, 8 bit sRGB; with a palette where 256 colours do. Same texels, same bytes.
/// @param sheet  With texels, no more than a sheet may have.
std::vector<std::byte> encode_png(const materials::Sheet& sheet);

/// decode(encode(sheet)) == sheet, but for texel_m, which is 0. Takes any PNG: what shines through shows black.
/// Errors: what is no PNG, damaged, or has more texels than a sheet may; never a crash. Memory: at most kMostTexels,
/// and in proportion to the file.
Result<materials::Sheet> decode_png(std::span<const std::byte> bytes, const std::string& name);

}  // namespace citykiln::exporters
