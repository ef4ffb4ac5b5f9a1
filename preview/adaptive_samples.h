// Adaptive sampling: the number of samples of each block of pixels, where a picture is rendered to a stated noise.
#pragma once

namespace citykiln::preview {

/// The two steps of adaptive sampling.
///
/// First every pixel gets `pilot` samples. The variance of the pilot samples decides how many further samples each
/// block of pixels gets. Further samples use another seed, so they are independent of the pilot samples, and the
/// weights of both means are fixed beforehand. Therefore pixels are unbiased, as an estimate that stops as soon as its
/// noise is low is not (Kirk, Arvo, "Unbiased Sampling Techniques for Image Synthesis", SIGGRAPH 1991).
struct SamplePlan {
  int pilot = 0;  ///< Pilot samples per pixel; 0: a pixel gets `most` samples at once.
  int most = 1;   ///< Most samples per pixel, pilot and further samples together.

  /// The weight of the mean of all pilot samples; the mean of further samples has the rest.
  double pilot_weight() const { return static_cast<double>(pilot) / most; }
};

/// Returns a plan with a quarter of the samples, at most 16, as pilot samples. Below 8 samples, or with a noise of 0,
/// there are no pilot samples.
/// @param most   The largest number of samples per pixel.
/// @param noise  The wanted relative error; 0: every pixel gets `most` samples.
SamplePlan plan_samples(int most, double noise);

/// The pilot samples of a block of pixels.
struct PilotBlock {
  double luminance = 0;  ///< Mean over the block's pixels.
  double variance = 0;   ///< Variance of the luminance of one sample, mean over the block's pixels.
};

/// Returns the number of further samples per pixel that brings the relative error of a block down to `noise`, from
/// plan.pilot to plan.most - plan.pilot. The relative error is the root of the pixels' mean variance, divided by the
/// block's mean luminance or, if this is larger, by a fiftieth of `picture_luminance`. Samples are assumed to be
/// independent; Sobol points are better, so the true error is smaller.
/// @param picture_luminance  The mean luminance of the picture.
/// @param noise              The wanted relative error, > 0.
int further_samples(const SamplePlan& plan, const PilotBlock& block, double picture_luminance, double noise);

}  // namespace citykiln::preview
