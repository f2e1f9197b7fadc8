#include "bench/support/files.hpp"

#include <planetree/error.hpp>

#include <unistd.h>

#include <cerrno>
#include <cstdio>
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

/// What stands under the name, or where its symbolic links lead.
fs::file_type typeOf(const fs::path& file) {
  std::error_code error;
  const fs::file_type type = fs::status(file, error).type();
  if (type == fs::file_type::none)
    throwNotWritable(file, error.message());
  return type;
}

/// The file that a chain of symbolic links ends at, which need not exist yet. Only for chains that
/// `typeOf` could follow: one that leads back to itself has no end.
fs::path endOfLinks(fs::path file) {
  while (fs::is_symlink(file))
    file = folderOf(file) / fs::read_symlink(file);
  return file;
}

void writeTo(const fs::path& place, const std::string& bytes, const fs::path& named) {
  std::ofstream stream(place, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream)
    throwNotWritable(named, "writing failed");
}

void replace(const fs::path& file, const std::string& bytes) {
  const fs::path target = endOfLinks(file);
  const fs::path temporary = target.string() + ".part" + std::to_string(::getpid());
  try {
    writeTo(temporary, bytes, file);
    std::error_code error;
    fs::rename(temporary, target, error);
    if (error)
      throwNotWritable(file, error.message());
  } catch (const Error&) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw;
  }
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

void checkIsReadable(const fs::path& file) {
  std::error_code ignored;
  const bool isFolder = fs::is_directory(file, ignored);
  if (isFolder || ::access(file.c_str(), R_OK) != 0) {
    const std::string reason =
        isFolder ? "this is a folder" : std::generic_category().message(errno);
    throw Error(ErrorCode::FileNotReadable, "the file cannot be read (" + reason + ")",
                "Check the name.", {.file = file.string()});
  }
}

void checkIsWritable(const fs::path& file) {
  if (file == kStandardOutput)
    return;
  const fs::file_type type = typeOf(file);
  if (type == fs::file_type::directory)
    throwNotWritable(file, "this is a folder");
  if (!isReplacedWhenWritten(file)) {
    if (::access(file.c_str(), W_OK) != 0)
      throwNotWritable(file, std::generic_category().message(errno));
    return;
  }
  const fs::path folder = folderOf(endOfLinks(file));
  if (!fs::is_directory(folder))
    throwNotWritable(file, "there is no such folder");
  if (::access(folder.c_str(), W_OK) != 0)
    throwNotWritable(file, "its folder cannot be written to");
}

bool isReplacedWhenWritten(const fs::path& file) {
  if (file == kStandardOutput)
    return false;
  const fs::file_type type = typeOf(file);
  return type == fs::file_type::regular || type == fs::file_type::not_found;
}

void writeWholeFile(const fs::path& file, const std::string& bytes) {
  checkIsWritable(file);
  if (file == kStandardOutput) {
    // A failure stays in the stream until finishStandardOutput finds it.
    std::fwrite(bytes.data(), 1, bytes.size(), stdout);
    finishStandardOutput();
  } else if (isReplacedWhenWritten(file)) {
    replace(file, bytes);
  } else {
    // A rename would put a regular file in the place of the device or the pipe.
    writeTo(file, bytes, file);
  }
}

void finishStandardOutput() {
  const bool isFlushed = std::fflush(stdout) == 0;
  if (!isFlushed || std::ferror(stdout) != 0) {
    throw Error(ErrorCode::FileNotWritable, "writing failed",
                "Free some space where it leads, or redirect it elsewhere.",
                {.file = "standard output"});
  }
}

}  // namespace planetree::bench
