#include "compiler/map/ways/assumed_layers.h"

#include <gtest/gtest.h>

#include "tests/compiler/map/map_text.h"

namespace citykiln::map {
namespace {

// The layer of way 1 of an extract.
int layer_of_first(const std::string& text) { return features_of(text).tracks.at(0).layer; }

const std::string kTunnel = "w1 0:0 50:0 highway=service tunnel=yes";

TEST(AssumedLayers, ATunnelHasTheLayerOfThoseThatItContinues) {
  EXPECT_EQ(layer_of_first(kTunnel), 0);
  EXPECT_EQ(layer_of_first(kTunnel + "\nw2 50:0 90:0 highway=service tunnel=yes layer=-3"), -3);
  // in the middle of another way too
  EXPECT_EQ(layer_of_first(kTunnel + "\nw2 50:-40 50:0 50:40 highway=service tunnel=yes layer=-3"), -3);
  EXPECT_EQ(layer_of_first("w1 0:0 50:0 highway=path bridge=yes\nw2 50:0 90:0 highway=path bridge=yes layer=2"), 2);
}

TEST(AssumedLayers, ItsOwnLayerStays) {
  EXPECT_EQ(layer_of_first(kTunnel + " layer=-1\nw2 50:0 90:0 highway=service tunnel=yes layer=-3"), -1);
}

TEST(AssumedLayers, ThereIsNoneWhereThoseDisagree) {
  EXPECT_EQ(layer_of_first(kTunnel + "\nw2 50:0 90:0 highway=service tunnel=yes layer=-3"
                                     "\nw3 -40:0 0:0 highway=service tunnel=yes layer=-2"),
            0);
}

TEST(AssumedLayers, OnlyWaysOfTheSamePassageCountThatMeetTheEnd) {
  EXPECT_EQ(layer_of_first(kTunnel + "\nw2 50:0 90:0 highway=service bridge=yes layer=2"), 0);
  EXPECT_EQ(layer_of_first(kTunnel + "\nw2 50:0 90:0 highway=service layer=-1"), 0);
  EXPECT_EQ(layer_of_first("w1 0:0 25:0 50:0 highway=service tunnel=yes\n"
                           "w2 25:0 25:40 highway=service tunnel=yes layer=-3"),
            0);
}

TEST(AssumedLayers, APathInATunnelWithoutALayerStaysACorridor) {
  EXPECT_EQ(layer_of_first("w1 0:0 50:0 highway=path tunnel=yes\nw2 50:0 90:0 highway=path tunnel=yes layer=-3"), 0);
}

TEST(AssumedLayers, OfTwoBridgesThatCrossTheHigherClassIsAboveElseTheLonger) {
  const std::string across = "w2 25:-20 25:20 highway=residential bridge=yes";
  EXPECT_EQ(layer_of_first("w1 0:0 50:0 highway=residential bridge=yes\n" + across), 2);
  EXPECT_EQ(layer_of_first("w1 10:0 40:0 highway=residential bridge=yes\n" + across), 0);
  EXPECT_EQ(layer_of_first("w1 10:0 40:0 highway=primary bridge=yes\n" + across), 2);
  EXPECT_EQ(layer_of_first("w1 0:0 50:0 railway=rail bridge=yes\n" + across), 0);
  EXPECT_EQ(layer_of_first("w1 10:0 40:0 highway=footway bridge=yes\n" + across), 2);
}

TEST(AssumedLayers, LayersThatSayTheOrderStayAndSoDoBridgesThatShareANode) {
  const std::string across = "w2 25:-20 25:20 highway=residential bridge=yes layer=1";
  EXPECT_EQ(layer_of_first("w1 0:0 50:0 highway=residential bridge=yes layer=3\n" + across), 3);
  EXPECT_EQ(layer_of_first("w1 0:0 50:0 highway=residential bridge=yes layer=-1\n" + across), -1);
  EXPECT_EQ(layer_of_first("w1 0:0 25:0 50:0 highway=residential bridge=yes\n"
                           "w2 25:-20 25:0 25:20 highway=residential bridge=yes"),
            0);
}

TEST(AssumedLayers, ThreeBridgesThatCrossLieOnThreeLayers) {
  const Features features = features_of(
      "w1 -60:0 60:0 highway=residential bridge=yes\nw2 0:-50 0:50 highway=residential bridge=yes\n"
      "w3 -30:-30 30:30 highway=residential bridge=yes layer=1");
  EXPECT_EQ(features.tracks.at(0).layer, 3);
  EXPECT_EQ(features.tracks.at(1).layer, 2);
  EXPECT_EQ(features.tracks.at(2).layer, 1);
}

}  // namespace
}  // namespace citykiln::map
