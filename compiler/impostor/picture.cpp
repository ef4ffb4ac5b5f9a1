#include "compiler/impostor/picture.h"

#include <lz4.h>

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <type_traits>

#include "compiler/materials/material.h"

namespace citykiln::impostor {

materials::TextureImage::Texel srgb_of(const std::array<std::uint16_t, 3>& linear) {
  materials::TextureImage::Texel srgb{};
  for (std::size_t c = 0; c < srgb.size(); ++c) srgb[c] = materials::srgb_of_linear(linear[c] / 65535.0);
  return srgb;
}

void TexelSum::add(const Texel& texel) {
  const std::uint64_t weight = texel.shown;
  for (std::size_t c = 0; c < light_.size(); ++c)
    light_[c] += weight * texel.light[c], emission_[c] += weight * texel.emission[c];
  for (std::size_t c = 0; c < slope_.size(); ++c) slope_[c] += std::int64_t{texel.shown} * texel.slope[c];
  roughness_ += weight * texel.roughness, metalness_ += weight * texel.metalness, shown_ += weight;
}

Texel TexelSum::mean(std::uint64_t texels) const {
  Texel mean;
  if (shown_ == 0) return mean;
  const auto share = [&](std::uint64_t sum) { return (2 * sum + shown_) / (2 * shown_); };
  for (std::size_t c = 0; c < light_.size(); ++c) {
    mean.light[c] = static_cast<std::uint16_t>(share(light_[c]));
    mean.emission[c] = static_cast<std::uint16_t>(share(emission_[c]));
  }
  for (std::size_t c = 0; c < slope_.size(); ++c) {
    const auto size = static_cast<std::int64_t>(share(static_cast<std::uint64_t>(std::abs(slope_[c]))));
    mean.slope[c] = static_cast<std::int16_t>(slope_[c] < 0 ? -size : size);
  }
  mean.roughness = static_cast<std::uint8_t>(share(roughness_));
  mean.metalness = static_cast<std::uint8_t>(share(metalness_));
  mean.shown = static_cast<std::uint16_t>((shown_ + texels - 1) / texels);
  return mean;
}

Texel mean(const Picture& picture) {
  TexelSum sum;
  for (const Texel& texel : picture.texels) sum.add(texel);
  return sum.mean(picture.texels.size());
}

Picture halved(const Picture& picture) {
  assert(picture.texels.size() == std::size_t{picture.columns} * picture.rows);
  Picture half{(picture.columns + 1) / 2, (picture.rows + 1) / 2, {}};
  for (std::size_t row = 0; row < half.rows; ++row)
    for (std::size_t column = 0; column < half.columns; ++column) {
      TexelSum sum;
      for (std::size_t y = 2 * row; y < std::min<std::size_t>(2 * row + 2, picture.rows); ++y)
        for (std::size_t x = 2 * column; x < std::min<std::size_t>(2 * column + 2, picture.columns); ++x)
          sum.add(picture.texels[y * picture.columns + x]);
      half.texels.push_back(sum.mean(4));
    }
  return half;
}

PackedPicture packed(const Picture& picture) {
  static_assert(std::has_unique_object_representations_v<Texel>, "equal pictures have equal bytes");
  const auto size = static_cast<int>(picture.texels.size() * sizeof(Texel));
  // by members: whole arrays are compared by a call of memcmp() for each texel
  const auto has_slope = [](const Texel& texel) { return texel.slope[0] != 0 || texel.slope[1] != 0; };
  PackedPicture small{picture.columns, picture.rows, std::ranges::any_of(picture.texels, emits),
                      std::ranges::any_of(picture.texels, has_slope),
                      std::vector<char>(static_cast<std::size_t>(LZ4_compressBound(size)))};
  const int packed_size = LZ4_compress_default(reinterpret_cast<const char*>(picture.texels.data()), small.bytes.data(),
                                               size, static_cast<int>(small.bytes.size()));
  small.bytes.resize(static_cast<std::size_t>(packed_size));
  small.bytes.shrink_to_fit();
  return small;
}

SharedPicture shared(const Picture& picture) { return std::make_shared<const PackedPicture>(packed(picture)); }

Picture unpacked(const PackedPicture& picture) {
  Picture whole{picture.columns, picture.rows, std::vector<Texel>(std::size_t{picture.columns} * picture.rows)};
  [[maybe_unused]] const int size = LZ4_decompress_safe(
      picture.bytes.data(), reinterpret_cast<char*>(whole.texels.data()), static_cast<int>(picture.bytes.size()),
      static_cast<int>(whole.texels.size() * sizeof(Texel)));
  assert(size == static_cast<int>(whole.texels.size() * sizeof(Texel)));
  return whole;
}

void fill_gaps(Picture& picture) {
  const Texel all = mean(picture);
  for (Texel& texel : picture.texels)
    if (texel.shown == 0) texel = all;
}

}  // namespace citykiln::impostor
