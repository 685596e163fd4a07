#include "ros/bags/output_file.h"

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <optional>
#include <vector>

#include "ros/bags/bag_fixture.h"

namespace contact_shapelets {
namespace {

class OutputFileTest : public BagTest {
 protected:
  std::vector<std::string> Files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
  }

  /// A process that is writing `path` with half of it written.
  class Writer {
   public:
    explicit Writer(const std::string& path, bool with_removal) {
      std::array<int, 2> ends{};
      if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe can be made");
      process_ = fork();
      if (process_ == 0) WriteHalfAndWait(path, with_removal, ends[1]);
      close(ends[1]);
      char letter = 0;
      begun_ = read(ends[0], &letter, 1) == 1;
      close(ends[0]);
    }
    bool begun() const { return begun_; }
    /// Ends it, and returns the signal that it ended by.
    int EndBy(int number) {
      kill(process_, number);
      int status = 0;
      waitpid(process_, &status, 0);
      return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    }

   private:
    [[noreturn]] static void WriteHalfAndWait(const std::string& path, bool with_removal, int ready) {
      std::optional<RemovalOnSignals> removal;
      if (with_removal) removal.emplace();
      const OutputFile file(path);
      std::ofstream(file.unfinished()) << "half";
      if (write(ready, "x", 1) != 1) _exit(1);
      for (;;) pause();
    }

    pid_t process_ = 0;
    bool begun_ = false;
  };
};

TEST_F(OutputFileTest, TakesItsPlaceWhenItIsFinished) {
  Write(Path("table.csv"), "old");
  {
    OutputFile file(Path("table.csv"));
    std::ofstream(file.unfinished()) << "new";
    EXPECT_EQ(Contents(Path("table.csv")), "old");
    file.Finish();
    EXPECT_EQ(Contents(Path("table.csv")), "new");
  }
  EXPECT_EQ(Files(), std::vector<std::string>{"table.csv"});
}

TEST_F(OutputFileTest, LeavesTheOldFileAndNothingElseWhereItIsNotFinished) {
  Write(Path("table.csv"), "old");
  {
    const OutputFile file(Path("table.csv"));
    std::ofstream(file.unfinished()) << "new";
  }
  EXPECT_EQ(Contents(Path("table.csv")), "old");
  EXPECT_EQ(Files(), std::vector<std::string>{"table.csv"});
}

TEST_F(OutputFileTest, ASignalRemovesWhatIsUnfinishedAndEndsTheProcess) {
  Write(Path("table.csv"), "old");
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    Writer writer(Path("table.csv"), true);
    ASSERT_TRUE(writer.begun());
    ASSERT_EQ(Files().size(), 2U);
    EXPECT_EQ(writer.EndBy(number), number);
    EXPECT_EQ(Files(), std::vector<std::string>{"table.csv"}) << number;
    EXPECT_EQ(Contents(Path("table.csv")), "old");
  }
}

TEST_F(OutputFileTest, WhatAKilledProcessLeftGoesWithTheNextFile) {
  Writer killed(Path("table.csv"), true);
  ASSERT_TRUE(killed.begun());
  EXPECT_EQ(killed.EndBy(SIGKILL), SIGKILL);
  ASSERT_EQ(Files().size(), 1U);
  Write(Path("table.csv.unfinished"), "of somebody else");
  Write(Path("table.csv.unfinished_notes"), "of somebody else");
  OutputFile(Path("table.csv")).Finish();
  EXPECT_EQ(Files(), (std::vector<std::string>{"table.csv", "table.csv.unfinished", "table.csv.unfinished_notes"}));
}

TEST_F(OutputFileTest, WhatALivingProcessWritesStays) {
  Writer writer(Path("table.csv"), false);
  ASSERT_TRUE(writer.begun());
  const std::vector<std::string> before = Files();
  { const OutputFile other(Path("table.csv")); }
  EXPECT_EQ(Files(), before);
  writer.EndBy(SIGKILL);
}

TEST_F(OutputFileTest, TwoOfOneProcessDoNotMeet) {
  OutputFile first(Path("table.csv"));
  OutputFile second(Path("table.csv"));
  EXPECT_NE(first.unfinished(), second.unfinished());
  std::ofstream(first.unfinished()) << "first";
  std::ofstream(second.unfinished()) << "second";
  second.Finish();
  first.Finish();
  EXPECT_EQ(Contents(Path("table.csv")), "first");
}

TEST_F(OutputFileTest, KeepsThePermissionsOfWhatItReplaces) {
  Write(Path("table.csv"), "old");
  ASSERT_EQ(chmod(Path("table.csv").c_str(), 0640), 0);
  OutputFile(Path("table.csv")).Finish();
  struct stat status {};
  ASSERT_EQ(stat(Path("table.csv").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777U, 0640U);
}

TEST_F(OutputFileTest, ReplacesWhatALinkLeadsTo) {
  Write(Path("first.bag"), "old");
  std::filesystem::create_symlink("first.bag", Path("newest.bag"));
  OutputFile file(Path("newest.bag"));
  std::ofstream(file.unfinished()) << "new";
  file.Finish();
  EXPECT_TRUE(std::filesystem::is_symlink(Path("newest.bag")));
  EXPECT_EQ(Contents(Path("first.bag")), "new");
}

TEST_F(OutputFileTest, WritesAPipeDirectly) {
  ASSERT_EQ(mkfifo(Path("pipe").c_str(), 0600), 0);
  OutputFile file(Path("pipe"));
  EXPECT_EQ(file.unfinished(), Path("pipe"));
  file.Finish();
  EXPECT_TRUE(std::filesystem::is_fifo(Path("pipe")));
}

TEST_F(OutputFileTest, SaysWhyItCannotBeMade) {
  ExpectWords(MessageOf([this] { const OutputFile file(Path("none/table.csv")); }), {"No such file"});
}

TEST_F(OutputFileTest, ACheckRefusesWhatIsReadUnderAnyName) {
  Write(Path("day.bag"), "#ROSBAG V2.0\n");
  std::filesystem::create_symlink("day.bag", Path("link.bag"));
  for (const std::string& name :
       {Path("day.bag"), Path("link.bag"), Path("./../" + folder_.filename().string() + "/day.bag")}) {
    ExpectWords(MessageOf([&] { CheckOutput("--csv", name, {Path("day.bag")}); }), {"--csv", "files that are read"});
  }
  EXPECT_EQ(MessageOf([this] { CheckOutput("--csv", Path("other.csv"), {Path("day.bag")}); }), "");
}

TEST_F(OutputFileTest, ACheckRefusesTwoOutputsInOneFileThatIsNotThereYet) {
  ExpectWords(MessageOf([this] { CheckOutput("--annotate", Path("x"), {}, {Path("./x")}); }), {"another output"});
  EXPECT_EQ(MessageOf([this] { CheckOutput("--annotate", Path("x"), {}, {Path("y"), ""}); }), "");
}

TEST_F(OutputFileTest, ACheckRefusesATableInPlaceOfABag) {
  BagWriter(Path("day.bag")).Outcome(0.0, "switched");
  ExpectWords(MessageOf([this] { CheckTextOutput("--csv", Path("day.bag"), {}); }), {"there is a bag already"});
  Write(Path("table.csv"), "old");
  EXPECT_EQ(MessageOf([this] { CheckTextOutput("--csv", Path("table.csv"), {}); }), "");
}

}  // namespace
}  // namespace contact_shapelets
