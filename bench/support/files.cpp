#include "bench/support/files.hpp"

#include <planetree/error.hpp>

#include <unistd.h>

#include <fstream>
#include <iterator>
#include <system_error>

namespace planetree::bench {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void throwNotWritable(const fs::path& file, const std::string& problem) {
  throw Error(ErrorCode::FileNotWritable, problem,
              "Name a file in a folder that can be written to.", {.file = file.string()});
}

fs::path folderOf(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

}  // namespace

std::string readTextFile(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  if (!stream.is_open() || stream.bad() || fs::is_directory(file)) {
    throw Error(ErrorCode::FileNotReadable, "the file cannot be read", "Check the name.",
                {.file = file.string()});
  }
  return text;
}

void checkIsWritable(const fs::path& file) {
  if (fs::is_directory(file))
    throwNotWritable(file, "this is a folder");
  if (!fs::is_directory(folderOf(file)))
    throwNotWritable(file, "there is no such folder");
  if (::access(folderOf(file).c_str(), W_OK) != 0)
    throwNotWritable(file, "its folder cannot be written to");
}

void writeWholeFile(const fs::path& file, const std::string& bytes) {
  checkIsWritable(file);
  const fs::path temporary = file.string() + ".part" + std::to_string(::getpid());
  std::ofstream stream(temporary, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  std::error_code error;
  if (stream)
    fs::rename(temporary, file, error);
  if (!stream || error) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throwNotWritable(file, "writing failed");
  }
}

}  // namespace planetree::bench
