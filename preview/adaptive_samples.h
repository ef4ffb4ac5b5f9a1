// How many samples a block of pixels gets, where a picture is rendered to a stated noise.
#pragma once

namespace citykiln::preview {

/// The two steps of adaptive sampling.
///
/// Every pixel gets `pilot` samples, and after them each block of pixels gets a number of further samples, which
/// depends on pilot samples only. Further samples are independent of the pilot samples (another seed), and both means
/// are added with weights that are fixed beforehand. Therefore the expected value of every pixel is that of one sample,
/// whatever the pilot shows. Estimates that stop when they look good are too dark, since rare bright paths make them go
/// on (Kirk, Arvo, "Unbiased Sampling Techniques for Image Synthesis", SIGGRAPH 1991).
struct SamplePlan {
  int pilot = 0;  ///< 0: a pixel gets `most` samples at once.
  int most = 1;   ///< Pilot and further samples together.

  /// The weight of the mean of all pilot samples; that of further samples has the rest.
  double pilot_weight() const { return static_cast<double>(pilot) / most; }
};

/// A quarter of the samples, at most 16, are pilot samples. Below 8 samples, or with a noise of 0, there are none.
SamplePlan plan_samples(int most, double noise);

/// A block after its pilot samples.
struct PilotBlock {
  double luminance = 0;  ///< Mean of its pixels.
  double variance = 0;   ///< Of the luminance of one sample, mean of its pixels.
};

/// The number of further samples with which the error of a block's pixels becomes `noise`: the root of their mean
/// variance, relative to the block's mean luminance, or to a fiftieth of the picture's where the block is darker.
/// From plan.pilot to plan.most - plan.pilot.
///
/// The variance is that of independent samples; Sobol points are better, so that the true error is smaller.
int further_samples(const SamplePlan& plan, const PilotBlock& block, double picture_luminance, double noise);

}  // namespace citykiln::preview
