#pragma once

#include "import/import_mesh.hpp"

#include <planetree/error.hpp>

#include <gtest/gtest.h>

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>

namespace planetree::test {

/// A folder of its own for each test, which goes with it.
class ModelFolder : public testing::Test {
 protected:
  ModelFolder() {
    std::string pattern =
        (std::filesystem::temp_directory_path() / "planetree-import-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr)
      throw std::runtime_error("no temporary folder");
    folder_ = pattern;
  }
  ~ModelFolder() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  [[nodiscard]] std::filesystem::path write(const std::string& name,
                                            const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }

  /// A program for a shell.
  [[nodiscard]] std::filesystem::path writeScript(const std::string& name,
                                                  const std::string& lines) const {
    const std::filesystem::path path = write(name, "#!/bin/sh\n" + lines + "\n");
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    return path;
  }

 private:
  std::filesystem::path folder_;
};

/// Expects an error that `read` throws, with this code and these words, which names the file and
/// says what to do.
template <class Read>
void expectError(const Read& read, const std::filesystem::path& file, ErrorCode code,
                 const std::string& words) {
  try {
    static_cast<void>(read());
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code) << error.what();
    EXPECT_EQ(error.file(), file.string()) << error.what();
    EXPECT_FALSE(error.advice().empty()) << error.what();
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    return;
  }
  ADD_FAILURE() << file << ": no error";
}

}  // namespace planetree::test
