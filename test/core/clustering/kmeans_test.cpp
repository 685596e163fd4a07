#include "core/clustering/kmeans.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <stdexcept>

#include "core/numerics/random.h"
#include "core/same_partition.h"

namespace contact_shapelets::core {
namespace {

struct Blobs {
  Eigen::MatrixXf points;
  Eigen::VectorXi classes;
};

/// Returns blobs with a standard deviation of 0.3 about the corners of a square of side 5, `offset` from the origin.
Blobs CornerBlobs(int per_blob, float offset, std::uint64_t seed) {
  Random random(seed);
  Blobs blobs{Eigen::MatrixXf(4 * per_blob, 2), Eigen::VectorXi(4 * per_blob)};
  for (int row = 0; row < blobs.points.rows(); ++row) {
    const int corner = row % 4;
    blobs.classes[row] = corner;
    blobs.points(row, 0) = offset + 5.0F * static_cast<float>(corner % 2) + 0.3F * static_cast<float>(random.Normal());
    blobs.points(row, 1) = offset + (corner < 2 ? 0.0F : 5.0F) + 0.3F * static_cast<float>(random.Normal());
  }
  return blobs;
}

KMeansOptions Options(int clusters, std::uint64_t seed = 0) {
  KMeansOptions options;
  options.clusters = clusters;
  options.seed = seed;
  return options;
}

Eigen::MatrixXf Column(std::initializer_list<float> values) {
  Eigen::MatrixXf column(static_cast<Eigen::Index>(values.size()), 1);
  Eigen::Index row = 0;
  for (const float value : values) column(row++, 0) = value;
  return column;
}

TEST(KMeans, FindsPlantedBlobsForEverySeed) {
  const Blobs blobs = CornerBlobs(30, 0.0F, 1);
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const KMeansResult result = KMeans(blobs.points, Options(4, seed));
    EXPECT_TRUE(SamePartition(result.labels, blobs.classes)) << "seed " << seed;
  }
}

TEST(KMeans, FindsPlantedBlobsFarFromTheOrigin) {
  // |c|^2 is 1e9 here. Floats are 64 apart there, more than the blobs.
  const Blobs blobs = CornerBlobs(30, 30000.0F, 1);
  const KMeansResult result = KMeans(blobs.points, Options(4));
  EXPECT_TRUE(SamePartition(result.labels, blobs.classes));
}

TEST(KMeans, NumbersClustersByTheirFirstPoint) {
  const KMeansResult result = KMeans(Column({9.0F, 1.0F, 9.5F, 20.0F, 1.5F}), Options(3));
  EXPECT_EQ(result.labels, (Eigen::VectorXi(5) << 0, 1, 0, 2, 1).finished());
  EXPECT_FLOAT_EQ(result.centroids(0, 0), 9.25F);
  EXPECT_FLOAT_EQ(result.centroids(1, 0), 1.25F);
  EXPECT_FLOAT_EQ(result.centroids(2, 0), 20.0F);
}

TEST(KMeans, InertiaIsTheSumOfSquaredDistances) {
  const KMeansResult result = KMeans(Column({0.0F, 2.0F, 10.0F, 14.0F}), Options(2));
  EXPECT_NEAR(result.inertia, 1.0 + 1.0 + 4.0 + 4.0, 1e-5);
}

TEST(KMeans, CentroidsAreTheMeansOfTheirPointsAndLabelsTheNearest) {
  const Blobs blobs = CornerBlobs(25, 3.0F, 2);
  const KMeansResult result = KMeans(blobs.points, Options(6, 3));
  EXPECT_EQ(result.labels, NearestCentroids(result.centroids, blobs.points));
  for (int cluster = 0; cluster < 6; ++cluster) {
    Eigen::RowVector2f sum = Eigen::RowVector2f::Zero();
    float count = 0.0F;
    for (Eigen::Index row = 0; row < blobs.points.rows(); ++row) {
      if (result.labels[row] != cluster) continue;
      sum += blobs.points.row(row);
      count += 1.0F;
    }
    ASSERT_GT(count, 0.0F);
    EXPECT_TRUE((sum / count).isApprox(result.centroids.row(cluster), 1e-4F));
  }
}

TEST(KMeans, EqualSeedsGiveEqualResults) {
  const Blobs blobs = CornerBlobs(20, 0.0F, 4);
  const KMeansResult first = KMeans(blobs.points, Options(7, 5));
  const KMeansResult second = KMeans(blobs.points, Options(7, 5));
  EXPECT_EQ(first.labels, second.labels);
  EXPECT_EQ(first.centroids, second.centroids);
  EXPECT_EQ(first.inertia, second.inertia);
}

TEST(KMeans, KeepsTheBestOfItsRestarts) {
  const Blobs blobs = CornerBlobs(15, 0.0F, 6);
  KMeansOptions one = Options(9, 1);
  one.restarts = 1;
  KMeansOptions many = Options(9, 1);
  many.restarts = 40;
  EXPECT_LE(KMeans(blobs.points, many).inertia, KMeans(blobs.points, one).inertia);
}

TEST(KMeans, LeavesNoClusterEmpty) {
  // There are fewer places than clusters. Without a refill, clusters would end empty.
  const KMeansResult result = KMeans(Column({1.0F, 1.0F, 1.0F, 1.0F, 8.0F}), Options(4));
  const std::set<int> used(result.labels.data(), result.labels.data() + result.labels.size());
  EXPECT_EQ(used, (std::set<int>{0, 1, 2, 3}));
  EXPECT_TRUE(result.centroids.allFinite());
  EXPECT_EQ(result.inertia, 0.0);
}

TEST(KMeans, GivesEachPointItsOwnClusterIfThereAreAsManyClusters) {
  const KMeansResult result = KMeans(Column({4.0F, 2.0F, 9.0F}), Options(3));
  EXPECT_EQ(result.labels, (Eigen::VectorXi(3) << 0, 1, 2).finished());
  EXPECT_EQ(result.inertia, 0.0);
}

TEST(KMeans, MakesOneClusterOfEverything) {
  const KMeansResult result = KMeans(Column({1.0F, 2.0F, 6.0F}), Options(1));
  EXPECT_TRUE(result.labels.isZero());
  EXPECT_FLOAT_EQ(result.centroids(0, 0), 3.0F);
}

TEST(KMeans, GivesAPartitionIfDistancesOverflow) {
  const KMeansResult result = KMeans(Column({1e30F, 1e30F, -1e30F}), Options(2));
  EXPECT_EQ(result.labels.size(), 3);
  EXPECT_EQ(result.centroids.rows(), 2);
}

TEST(KMeans, RefusesFaultyInput) {
  const Eigen::MatrixXf points = Column({1.0F, 2.0F, 3.0F});
  EXPECT_THROW(KMeans(points, Options(0)), std::invalid_argument);
  EXPECT_THROW(KMeans(points, Options(4)), std::invalid_argument);
  KMeansOptions options = Options(2);
  options.restarts = 0;
  EXPECT_THROW(KMeans(points, options), std::invalid_argument);
  options = Options(2);
  options.iterations = 0;
  EXPECT_THROW(KMeans(points, options), std::invalid_argument);
  EXPECT_THROW(KMeans(Column({1.0F, std::numeric_limits<float>::quiet_NaN()}), Options(2)), std::invalid_argument);
  EXPECT_THROW(KMeans(Column({1.0F, std::numeric_limits<float>::infinity()}), Options(2)), std::invalid_argument);
}

TEST(NearestCentroid, TakesTheLowerOneOfATie) {
  const Eigen::MatrixXf centroids = Column({1.0F, 3.0F});
  EXPECT_EQ(NearestCentroid(centroids, Eigen::VectorXf::Constant(1, 2.0F)), 0);
  EXPECT_EQ(NearestCentroids(centroids, Column({2.0F}))[0], 0);
}

TEST(NearestCentroids, AgreesWithNearestCentroidFarFromTheOrigin) {
  const Blobs blobs = CornerBlobs(20, 30000.0F, 8);
  const Eigen::MatrixXf centroids = blobs.points.topRows(4);
  const Eigen::VectorXi nearest = NearestCentroids(centroids, blobs.points);
  for (Eigen::Index row = 0; row < blobs.points.rows(); ++row) {
    EXPECT_EQ(nearest[row], NearestCentroid(centroids, blobs.points.row(row).transpose())) << "row " << row;
  }
}

}  // namespace
}  // namespace contact_shapelets::core
