#include "core/clustering/latent_class.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "core/numerics/random.h"

namespace contact_shapelets::core {
namespace {

/// Returns the classes of 90 series of class 0 and 10 of class 1.
Eigen::VectorXi OneInTen() {
  Eigen::VectorXi classes(100);
  for (Eigen::Index series = 0; series < classes.size(); ++series) classes[series] = series % 10 == 0 ? 1 : 0;
  return classes;
}

/// Returns a vote that puts each series into the part of its class, or with probability `wrong` into the other part.
Eigen::VectorXi Vote(const Eigen::Ref<const Eigen::VectorXi>& classes, double wrong, Random* random) {
  Eigen::VectorXi vote = classes;
  for (Eigen::Index series = 0; series < vote.size(); ++series) {
    if (random->Uniform(0.0, 1.0) < wrong) vote[series] = 1 - vote[series];
  }
  return vote;
}

TEST(LatentClasses, AreThoseOfVotersThatAgree) {
  const Eigen::VectorXi classes = OneInTen();
  EXPECT_EQ(LatentClasses({classes, classes, classes}, classes, 2), classes);
}

TEST(LatentClasses, RepairWrongLabelsOfTheStart) {
  const Eigen::VectorXi classes = OneInTen();
  Eigen::VectorXi start = classes;
  for (const int series : {10, 20, 31, 41, 51, 61}) start[series] = 1 - start[series];
  EXPECT_EQ(LatentClasses({classes, classes, classes}, start, 2), classes);
}

TEST(LatentClasses, FollowAFewReliableVotersAgainstManyThatGuess) {
  const Eigen::VectorXi classes = OneInTen();
  Random random(3);
  std::vector<Eigen::VectorXi> votes;
  for (int voter = 0; voter < 5; ++voter) votes.push_back(Vote(classes, 0.02, &random));
  for (int voter = 0; voter < 15; ++voter) votes.push_back(Vote(classes, 0.5, &random));
  Eigen::VectorXi counts = Eigen::VectorXi::Zero(classes.size());
  for (const Eigen::VectorXi& vote : votes) counts += vote;
  const Eigen::VectorXi majority = (counts.array() > 10).cast<int>();
  ASSERT_GT((majority - classes).cwiseAbs().sum(), 0);
  EXPECT_EQ(LatentClasses(votes, Vote(classes, 0.1, &random), 2), classes);
}

TEST(LatentClasses, TakeThePartsOfAVoterByWhatTheyHoldAndNotByTheirNumbers) {
  const Eigen::VectorXi classes = OneInTen();
  const Eigen::VectorXi swapped = 1 - classes.array();
  Eigen::VectorXi finer = classes;
  for (Eigen::Index series = 0; series < finer.size(); series += 3) finer[series] += 2;
  EXPECT_EQ(LatentClasses({swapped, finer, swapped}, classes, 2), classes);
}

TEST(LatentClasses, ReturnTheStartIfAClassWouldHoldNoSeries) {
  // The votes have one part, which the larger class takes as a whole.
  const Eigen::VectorXi one_part = Eigen::VectorXi::Zero(100);
  EXPECT_EQ(LatentClasses({one_part, one_part}, OneInTen(), 2), OneInTen());
}

TEST(LatentClasses, RefuseVotesAndLabelsThatDoNotMatch) {
  const Eigen::VectorXi classes = OneInTen();
  EXPECT_THROW(LatentClasses({}, classes, 2), std::invalid_argument);
  EXPECT_THROW(LatentClasses({classes}, classes, 1), std::invalid_argument);
  EXPECT_THROW(LatentClasses({classes.head(99)}, classes, 2), std::invalid_argument);
  EXPECT_THROW(LatentClasses({classes.array() - 1}, classes, 2), std::invalid_argument);
}

}  // namespace
}  // namespace contact_shapelets::core
