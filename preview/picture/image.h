// Rendered pictures and their files.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "compiler/contract/result.h"
#include "compiler/contract/stable_id.h"

namespace citykiln::preview {

/// Numbers about the rendering of a picture.
struct RenderStatistics {
  std::uint64_t paths = 0;
  double seconds = 0;
  int least_samples = 0, most_samples = 0;  ///< Least and most samples of a pixel.
  bool is_complete = true;                  ///< False if rendering was stopped before all samples were taken.
};

/// The first surfaces in a picture, which guide filters and compositing. Row by row from the top, as the picture.
/// Albedo, normal and depth are means over the samples of a pixel, weighted like its colour.
struct Guides {
  std::vector<float> albedo;  ///< 3 a pixel, linear; 0 for the sky.
  std::vector<float> normal;  ///< 3 a pixel: x east, y north, z up; shorter than 1 where surfaces differ.
  /// Mean distance from the viewer over the samples that meet a surface; infinity if none does.
  std::vector<float> depth_m;
  std::vector<float> variance;  ///< Estimated variance of the pixel's mean luminance.
  /// The OSM object of more than half of the samples; if there is none, one of the objects that they meet.
  std::vector<OsmId> feature;
};

/// Linear RGB, row by row from the top.
struct Image {
  int width = 0, height = 0;
  std::vector<float> rgb{};
  Guides guides{};                       ///< Empty unless Options::has_guides.
  std::vector<std::uint32_t> samples{};  ///< Samples of each pixel; empty if guides are.
  RenderStatistics statistics{};
};

/// A fact that is written into a picture's file.
struct Metadata {
  std::string name, value;
};

/// Writes PNG (8 bit sRGB, filmic tone curve) or EXR (linear), by the name's extension, through OpenImageIO, which is
/// loaded only then. An EXR of a picture with guides has them as channels (preview/options.md). Both formats state
/// OSM's credit and the metadata. Equal pictures and metadata give equal bytes. Errors: another extension; OpenImageIO
/// cannot be loaded; a file that cannot be written.
Result<Done> write_image(const Image& image, const std::string& path, const std::vector<Metadata>& metadata = {});

}  // namespace citykiln::preview
