#include "bench/support/files.hpp"

#include <planetree/error.hpp>

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <stdexcept>
#include <string>
#include <system_error>

namespace planetree::bench {
namespace {

namespace fs = std::filesystem;

/// Each test writes to an empty folder of its own.
class BenchFiles : public testing::Test {
 protected:
  BenchFiles() {
    std::string pattern = (fs::temp_directory_path() / "planetree-bench-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr)
      throw std::runtime_error("no temporary folder");
    folder_ = pattern;
  }
  ~BenchFiles() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  [[nodiscard]] fs::path in(const std::string& name) const { return folder_ / name; }
  [[nodiscard]] auto fileCount() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }

 private:
  fs::path folder_;
};

TEST_F(BenchFiles, AreReplacedWhole) {
  writeWholeFile(in("file"), "a long text");
  writeWholeFile(in("file"), "short");
  EXPECT_EQ(readTextFile(in("file")), "short");
  EXPECT_EQ(fileCount(), 1);
}

TEST_F(BenchFiles, ArePipesStillAfterTheyWereWrittenTo) {
  ASSERT_EQ(::mkfifo(in("pipe").c_str(), 0600), 0);
  fs::create_symlink("pipe", in("link"));
  const int reader = ::open(in("pipe").c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  EXPECT_FALSE(isReplacedWhenWritten(in("pipe")));
  writeWholeFile(in("pipe"), "one ");
  writeWholeFile(in("link"), "two");
  std::array<char, 16> bytes = {};
  EXPECT_EQ(::read(reader, bytes.data(), bytes.size()), 7);
  ::close(reader);
  EXPECT_EQ(std::string(bytes.data()), "one two");
  EXPECT_TRUE(fs::is_fifo(fs::symlink_status(in("pipe"))));
  EXPECT_TRUE(fs::is_symlink(in("link")));
  EXPECT_EQ(fileCount(), 2);
}

TEST_F(BenchFiles, AreReplacedWhereALinkLeads) {
  fs::create_directory(in("folder"));
  fs::create_symlink("folder/link", in("link"));
  fs::create_symlink("file", in("folder/link"));
  for (const char* text : {"new", "newer"}) {
    writeWholeFile(in("link"), text);
    EXPECT_EQ(readTextFile(in("folder/file")), text);
    EXPECT_TRUE(fs::is_symlink(in("link")));
    EXPECT_TRUE(fs::is_symlink(in("folder/link")));
  }
}

TEST_F(BenchFiles, AreRefusedWhereNothingCanBeWritten) {
  fs::create_symlink("circle", in("circle"));
  fs::create_symlink("missing/file", in("astray"));
  for (const char* name : {"", "missing/file", "circle", "astray"})
    EXPECT_THROW(checkIsWritable(in(name)), Error) << name;
  EXPECT_EQ(fileCount(), 2);
}

TEST_F(BenchFiles, AreRefusedWhereNothingCanBeRead) {
  writeWholeFile(in("file"), "");
  EXPECT_NO_THROW(checkIsReadable(in("file")));
  for (const char* name : {"", "missing", "file/below"})
    EXPECT_THROW(checkIsReadable(in(name)), Error) << name;
}

}  // namespace
}  // namespace planetree::bench
