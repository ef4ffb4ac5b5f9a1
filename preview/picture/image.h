// Rendered pictures and their files.
#pragma once

#include <string>
#include <vector>

#include "compiler/contract/result.h"

namespace citykiln::preview {

/// Linear RGB, row by row from the top.
struct Image {
  int width = 0, height = 0;
  std::vector<float> rgb;
};

/// Writes PNG (8 bit sRGB, filmic tone curve) or EXR (linear), by the name's extension, through OpenImageIO, which is
/// loaded only then.
Result<Done> write_image(const Image& image, const std::string& path);

}  // namespace citykiln::preview
