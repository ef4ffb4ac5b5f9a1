// Removes the noise of path tracing from a picture, guided by what its pixels show.
#pragma once

#include "preview/picture/image.h"

namespace citykiln::preview {

/// The picture with less noise, in linear light; its guides stay. Needs guides.
///
/// Method: light is divided by albedo, so that textures are kept, and smoothed by five passes of an à-trous wavelet
/// whose taps are weighted by how much depth, normal, albedo and luminance differ (Dammertz, Sewtz, Hanika, Lensch,
/// "Edge-Avoiding À-Trous Wavelet Transform for fast Global Illumination Filtering", HPG 2010). Luminance counts in
/// units of its own error, which is known from the samples (Schied et al., "Spatiotemporal Variance-Guided Filtering",
/// HPG 2017): pixels with little noise stay as they are, and the filter vanishes as samples increase.
///
/// Guarantees: the same bits for any number of threads; a pixel that is not finite spreads to no other. Not unbiased:
/// detail of shadows and reflections below the noise is lost. Cost: 125 taps a pixel; 60 bytes a pixel.
Image denoise(const Image& image, int threads);

}  // namespace citykiln::preview
