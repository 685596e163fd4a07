#include "evaluation/ucr_reader.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace contact_shapelets::evaluation {
namespace {

namespace fs = std::filesystem;

/// A folder for data sets, which the end of the test deletes.
class UcrReader : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "ucr_reader_XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { fs::remove_all(folder_); }

  void Write(const std::string& path, const std::string& text) const {
    fs::create_directories((folder_ / path).parent_path());
    std::ofstream(folder_ / path) << text;
  }

  void WriteBoth(const std::string& train) const {
    Write("Toy/Toy_TRAIN.tsv", train);
    Write("Toy/Toy_TEST.tsv", kGood);
  }

  DataSet Read() const { return ReadUcrDataSet(folder_.string(), "Toy", nullptr); }

  /// Returns the message of the reader's exception, without the folder.
  std::string Error() const {
    try {
      Read();
    } catch (const std::runtime_error& error) {
      return std::string(error.what()).substr(folder_.string().size() + 1);
    }
    return "no exception";
  }

  const std::string kGood = "1\t0\t1\t2\n1\t0\t2\t2\n-1\t3\t1\t0\n-1\t3\t2\t0\n";
  fs::path folder_;
};

TEST_F(UcrReader, ReadsClassesAndValues) {
  WriteBoth(kGood);
  const DataSet data_set = Read();
  EXPECT_EQ(data_set.name, "Toy");
  EXPECT_EQ(data_set.class_count, 2);
  ASSERT_EQ(data_set.train.series.size(), 4U);
  EXPECT_TRUE(data_set.train.series[1].isApprox(Eigen::Vector3f(0, 2, 2)));
  EXPECT_EQ(data_set.train.classes, Eigen::Vector4i(1, 1, 0, 0));
  EXPECT_EQ(data_set.test.classes, Eigen::Vector4i(1, 1, 0, 0));
}

TEST_F(UcrReader, ReadsTheOlderLayoutsWithCommasAndSpacesToTheSameSeries) {
  Write("Toy/Toy_TRAIN.txt", "1,0,1,2\r\n1,0,2,2\r\n-1,3,1,0\r\n-1,3,2,0\r\n");
  Write("Toy/Toy_TEST", "  1.0000000e+00  0.0  1.0e+00  2.0\n 1.0 0 2 2\n -1.0 3 1 0\n -1.0 3 2 0\n\n");
  const DataSet data_set = Read();
  ASSERT_EQ(data_set.train.series.size(), data_set.test.series.size());
  for (std::size_t index = 0; index < data_set.train.series.size(); ++index) {
    EXPECT_EQ(data_set.train.series[index], data_set.test.series[index]);
  }
  EXPECT_EQ(data_set.train.classes, data_set.test.classes);
}

TEST_F(UcrReader, LeavesOutPaddingAndInterpolatesMissingValues) {
  WriteBoth("1\tNaN\t1\tNaN\t3\n1\t0\t2\tNaN\tNaN\n-1\t3\t1\t0\t1\n-1\t3\t2\t0\t1\n");
  const DataSet data_set = Read();
  EXPECT_TRUE(data_set.train.series[0].isApprox(Eigen::Vector4f(1, 1, 2, 3)));
  EXPECT_TRUE(data_set.train.series[1].isApprox(Eigen::Vector2f(0, 2)));
}

TEST_F(UcrReader, NamesAMissingFile) {
  Write("Toy/Toy_TRAIN.tsv", kGood);
  EXPECT_EQ(Error().find("Toy/Toy_TEST.tsv: there is no such file"), 0U);
}

TEST_F(UcrReader, NamesTheRowOfAnotherWidth) {
  WriteBoth("1\t0\t1\t2\n1\t0\t2\n-1\t3\t1\t0\n-1\t3\t2\t0\n");
  EXPECT_EQ(Error(), "Toy/Toy_TRAIN.tsv: row 2: expected 4 columns as in the first row, found 3");
}

TEST_F(UcrReader, NamesRowAndColumnOfAValueThatIsNotANumber) {
  WriteBoth("1\t0\t1\t2\n1\t0\t2\t2\n-1\t3\tone\t0\n-1\t3\t2\t0\n");
  EXPECT_EQ(Error(), "Toy/Toy_TRAIN.tsv: row 3: column 3 holds 'one', which is not a number");
}

TEST_F(UcrReader, RefusesAQuestionMarkForAMissingValue) {
  WriteBoth("1\t0\t1\t2\n1\t0\t?\t2\n-1\t3\t1\t0\n-1\t3\t2\t0\n");
  EXPECT_EQ(Error(), "Toy/Toy_TRAIN.tsv: row 2: column 3 holds '?', which is not a number");
}

TEST_F(UcrReader, RefusesASingleColumn) {
  WriteBoth("1\n1\n-1\n-1\n");
  EXPECT_EQ(Error(), "Toy/Toy_TRAIN.tsv: row 1: the series has fewer than 2 values");
}

TEST_F(UcrReader, RefusesAnEmptyValue) {
  WriteBoth("1,0,1,2\n1,0,,2\n-1,3,1,0\n-1,3,2,0\n");
  EXPECT_EQ(Error(), "Toy/Toy_TRAIN.tsv: row 2: column 3 holds '', which is not a number");
}

TEST_F(UcrReader, RefusesAnInfiniteValue) {
  for (const std::string value : {"inf", "-inf", "1e400", "-1e39"}) {
    WriteBoth("1\t0\t1\t" + value + "\n1\t0\t2\t2\n-1\t3\t1\t0\n-1\t3\t2\t0\n");
    EXPECT_EQ(Error(), "Toy/Toy_TRAIN.tsv: row 1: column 4 holds an infinite value") << value;
  }
}

TEST_F(UcrReader, NamesTheRowOfAConstantSeries) {
  WriteBoth("1\t0\t1\t2\n1\t0\t2\t2\n-1\t3\t1\t0\n-1\t0.1\t0.1\t0.1\n");
  EXPECT_EQ(Error(), "Toy/Toy_TRAIN.tsv: row 4: the series is constant");
}

TEST_F(UcrReader, RefusesASeriesOfPaddingAlone) {
  WriteBoth("1\t0\t1\t2\n1\t0\tNaN\tNaN\n-1\t3\t1\t0\n-1\t3\t2\t0\n");
  EXPECT_EQ(Error(), "Toy/Toy_TRAIN.tsv: row 2: the series has fewer than 2 values");
}

TEST_F(UcrReader, RefusesAClassWithOneMemberInEitherFile) {
  WriteBoth("1\t0\t1\t2\n1\t0\t2\t2\n-1\t3\t1\t0\n-1\t3\t2\t0\n7\t3\t2\t1\n");
  EXPECT_EQ(Error(), "Toy/Toy_TRAIN.tsv: row 5: class 7 has one member, expected 2 or more");
}

TEST_F(UcrReader, AddsANoteOnAClassWithOneMemberInOneFileOnly) {
  WriteBoth("1\t0\t1\t2\n-1\t3\t1\t0\n1\t0\t2\t2\n");
  std::vector<std::string> notes;
  EXPECT_EQ(ReadUcrDataSet(folder_.string(), "Toy", &notes).class_count, 2);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes.front(), (folder_ / "Toy/Toy_TRAIN.tsv: row 2: class -1 has one member").string());
}

TEST_F(UcrReader, RefusesFewerSeriesThanClasses) {
  WriteBoth("1\t0\t1\t2\n");
  EXPECT_EQ(Error(), "Toy/Toy_TRAIN.tsv: row 1: the file ends with 1 series, fewer than the 2 classes of the data set");
}

TEST_F(UcrReader, RefusesAnEmptyFile) {
  WriteBoth("");
  EXPECT_EQ(Error(), "Toy/Toy_TRAIN.tsv: row 1: expected a series, but the file is empty");
}

TEST_F(UcrReader, ListsTheDataSetsOfAFolder) {
  WriteBoth(kGood);
  Write("Second/Second_TRAIN.txt", kGood);
  Write("notes/readme.txt", "");
  EXPECT_EQ(UcrDataSetNames(folder_.string()), (std::vector<std::string>{"Second", "Toy"}));
  EXPECT_THROW(UcrDataSetNames((folder_ / "notes").string()), std::runtime_error);
}

TEST(UcrArchive, HoldsTheSeriesOfThePapersTable) {
  const std::string folder = "../shared/data/ucr";
  if (!fs::is_directory(folder)) GTEST_SKIP() << "the optional folder " << folder << " is not there";
  struct Row {
    const char* name;
    std::size_t train, test;
    int length, classes;
  };
  for (const Row& row : {Row{"ECG200", 100, 100, 96, 2}, Row{"CBF", 30, 900, 128, 3}, Row{"FaceFour", 24, 88, 350, 4},
                         Row{"OSULeaf", 200, 242, 427, 6}}) {
    const DataSet data_set = ReadUcrDataSet(folder, row.name, nullptr);
    EXPECT_EQ(data_set.train.series.size(), row.train) << row.name;
    EXPECT_EQ(data_set.test.series.size(), row.test) << row.name;
    EXPECT_EQ(data_set.train.series.front().size(), row.length) << row.name;
    EXPECT_EQ(data_set.class_count, row.classes) << row.name;
  }
}

}  // namespace
}  // namespace contact_shapelets::evaluation
