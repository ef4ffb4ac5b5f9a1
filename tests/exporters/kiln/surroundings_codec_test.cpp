#include "exporters/kiln/surroundings_codec.h"

#include <gtest/gtest.h>

#include "exporters/kiln/streams.h"

namespace citykiln::exporters {
namespace {

using surroundings::Cover;
using surroundings::Surroundings;

Surroundings grid() {
  Surroundings around{.x_m = {-9000, -64, 0, 70, 8000}, .y_m = {-5, 40, 60000}, .heights_m = {}, .covers = {}};
  for (int i = 0; i < 15; ++i) {
    around.heights_m.push_back(i % 4 == 0 ? 0 : 311 * i - 900);
    around.covers.push_back(i % 4 == 0 ? Cover::kSea : i % 5 == 2 ? Cover::kLake : Cover::kLand);
  }
  return around;
}

std::optional<Surroundings> decoded_surroundings(const SurroundingsStreams& s) {
  return decode_surroundings(s.x, s.y, s.heights, s.covers);
}

TEST(SurroundingsCodec, ReadsWhatItWrote) {
  const Surroundings around = grid();
  ASSERT_TRUE(is_sound(around));
  const auto read = decoded_surroundings(encode_surroundings(around));
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, around);
}

TEST(SurroundingsCodec, RefusesStreamsThatEndEarlyOrLate) {
  for (std::vector<std::uint8_t> SurroundingsStreams::*stream :
       {&SurroundingsStreams::x, &SurroundingsStreams::y, &SurroundingsStreams::heights,
        &SurroundingsStreams::covers}) {
    SurroundingsStreams early = encode_surroundings(grid()), late = early;
    (early.*stream).pop_back(), (late.*stream).push_back(1);
    EXPECT_FALSE(decoded_surroundings(early));
    EXPECT_FALSE(decoded_surroundings(late));
  }
}

TEST(SurroundingsCodec, TrustsNoCountBeforeTheBytesAreThere) {
  // 4,096 lines each way claim 16 million heights
  StreamWriter lines, one, run;
  for (int i = 0; i < 4096; ++i) lines.put_delta(i);
  one.put_signed(7), run.put(std::uint64_t{1} << 60);
  EXPECT_FALSE(decode_surroundings(lines.bytes(), lines.bytes(), one.bytes(), run.bytes()));
  SurroundingsStreams long_run = encode_surroundings(grid());
  long_run.covers = run.bytes();
  EXPECT_FALSE(decoded_surroundings(long_run));
}

}  // namespace
}  // namespace citykiln::exporters
