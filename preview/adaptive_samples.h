// Adaptive sampling: the number of samples of each block of pixels, where a picture is rendered to a stated noise.
#pragma once

namespace citykiln::preview {

/// The two steps of adaptive sampling.
///
/// First every pixel gets `pilot` samples. They decide how many further samples each block of pixels gets. Further
/// samples use another seed, so they are independent of the pilot samples, and the weights of both means are fixed
/// beforehand. Therefore the expected value of every pixel is that of one sample, whatever the pilot samples are. An
/// estimate that stops as soon as it looks good is too dark, since rare bright paths make it go on (Kirk, Arvo,
/// "Unbiased Sampling Techniques for Image Synthesis", SIGGRAPH 1991).
struct SamplePlan {
  int pilot = 0;  ///< Pilot samples per pixel; 0: a pixel gets `most` samples at once.
  int most = 1;   ///< Most samples per pixel, pilot and further samples together.

  /// The weight of the mean of all pilot samples; the mean of further samples has the rest.
  double pilot_weight() const { return static_cast<double>(pilot) / most; }
};

/// Returns a plan with a quarter of the samples, at most 16, as pilot samples. Below 8 samples, or with a noise of 0,
/// there are none.
SamplePlan plan_samples(int most, double noise);

/// The pilot samples of a block of pixels.
struct PilotBlock {
  double luminance = 0;  ///< Mean over the block's pixels.
  double variance = 0;   ///< Variance of the luminance of one sample, mean over the block's pixels.
};

/// The number of further samples per pixel that brings the relative error of a block down to `noise`, from plan.pilot
/// to plan.most - plan.pilot. The relative error is the root of the pixels' mean variance over the block's mean
/// luminance, or over a fiftieth of the picture's where the block is darker than that.
///
/// The variance is that of independent samples. Sobol points are better, so the true error is smaller.
int further_samples(const SamplePlan& plan, const PilotBlock& block, double picture_luminance, double noise);

}  // namespace citykiln::preview
