#include "contact_shapelets/core/preparation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace contact_shapelets::core {
namespace {

Episode EpisodeOf(double duration, float peak) {
  Episode episode;
  episode.sample_period = 0.01;
  episode.force = Eigen::VectorXf::Zero(static_cast<Eigen::Index>(std::lround(duration / episode.sample_period)));
  episode.force[1] = peak;
  return episode;
}

Preparation Trained() {
  Preparation preparation;
  preparation.SetRanges({EpisodeOf(6.0, 20.0F), EpisodeOf(7.5, 30.0F)});
  return preparation;
}

TEST(PreparationTest, RangesAreThoseOfTheEpisodes) {
  const Preparation preparation = Trained();
  EXPECT_DOUBLE_EQ(preparation.least_duration, 6.0);
  EXPECT_DOUBLE_EQ(preparation.greatest_duration, 7.5);
  EXPECT_DOUBLE_EQ(preparation.least_peak, 20.0);
  EXPECT_DOUBLE_EQ(preparation.greatest_peak, 30.0);
  EXPECT_EQ(preparation.Faults(), "");
}

TEST(PreparationTest, SaysInWordsWhatIsFarFromTheTraining) {
  const Preparation preparation = Trained();
  EXPECT_EQ(preparation.FarFrom(EpisodeOf(6.0, 20.0F), 0.01), "");
  EXPECT_EQ(preparation.FarFrom(EpisodeOf(4.1, 11.0F), 0.01), "") << "near to the ranges";
  EXPECT_EQ(preparation.FarFrom(EpisodeOf(1.8, 20.0F), 0.01), "it lasts 1.8 s, in training 6 to 7.5 s");
  EXPECT_EQ(preparation.FarFrom(EpisodeOf(12.0, 20.0F), 0.01), "it lasts 12 s, in training 6 to 7.5 s");
  EXPECT_EQ(preparation.FarFrom(EpisodeOf(6.0, 90.0F), 0.01), "its greatest force is 90 N, in training 20 to 30 N");
  EXPECT_EQ(preparation.FarFrom(EpisodeOf(6.0, 9.0F), 0.01), "its greatest force is 9 N, in training 20 to 30 N");
  EXPECT_EQ(preparation.FarFrom(EpisodeOf(6.0, 20.0F), 0.001), "its sample period is 0.01 s, in training 0.001 s");
}

TEST(PreparationTest, UnknownRangesAreFarFromNothing) {
  EXPECT_EQ(Preparation().FarFrom(EpisodeOf(1.8, 90.0F), 0.01), "");
}

TEST(PreparationTest, NamesEachParameterThatDiffers) {
  SegmentationOptions trained;
  SegmentationOptions used = trained;
  EXPECT_EQ(DifferencesOf(used, trained), "");
  used.contact_on = 6.0;
  EXPECT_EQ(DifferencesOf(used, trained), "") << "a trigger does not read it";
  used.segmentation = SegmentationMode::kContact;
  used.tare = TareSource::kFreeAir;
  used.max_gap = 0.5;
  EXPECT_EQ(DifferencesOf(used, trained),
            "segmentation contact (trained with trigger), tare free_air (trained with episode_start), max_gap 0.5 "
            "(trained with 0.2), contact_on 6 (trained with 8)");
}

TEST(PreparationTest, WhatBagsDoNotHaveInCommonIsUnknown) {
  Preparation first;
  first.segmentation.emplace();
  first.topic = "/wrench";
  first.rate = 100.0;
  Preparation second = first;
  EXPECT_TRUE(InCommon(first, second).segmentation);
  EXPECT_EQ(InCommon(first, second).topic, "/wrench");
  second.segmentation->tare = TareSource::kService;
  second.topic = "/other";
  second.rate = 0.0;
  const Preparation common = InCommon(first, second);
  EXPECT_FALSE(common.segmentation);
  EXPECT_EQ(common.topic, "");
  EXPECT_EQ(common.rate, 0.0);
}

TEST(PreparationTest, FaultsNameWhatIsOutOfRange) {
  Preparation preparation = Trained();
  preparation.least_peak = -1.0;
  preparation.rate = 2e6;
  preparation.segmentation.emplace().max_gap = -1.0;
  const std::string faults = preparation.Faults();
  for (const char* const word : {"least peak", "rate", "max_gap"}) EXPECT_NE(faults.find(word), std::string::npos);
}

}  // namespace
}  // namespace contact_shapelets::core
